#include <lodsmith/analysis/StreamingCost.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

namespace lodsmith {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kRounding = 1e-12;

rc::Gen<double> real(double least, double most)
{
    return rc::gen::map(rc::gen::inRange<int>(0, 1000001),
                        [=](int step) { return least + (most - least) * step / 1000000.0; });
}

/// Millimetres to beyond the disc, as many small ones as large ones.
rc::Gen<double> radius()
{
    return rc::gen::map(real(-3, 3), [](double exponent) { return std::pow(10.0, exponent); });
}

rc::Gen<double> bytes()
{
    return rc::gen::map(rc::gen::inRange<int>(1, 300000), [](int count) { return static_cast<double>(count); });
}

rc::Gen<std::vector<CostedLevel>> chain()
{
    return rc::gen::mapcat(rc::gen::inRange<std::size_t>(1, 9), [](std::size_t levels) {
        return rc::gen::map(rc::gen::container<std::vector<double>>(levels, bytes()),
                            [](const std::vector<double>& counts) {
                                std::vector<CostedLevel> made;
                                for (const double count : counts)
                                    made.push_back({count, std::floor(count / 3)});
                                return made;
                            });
    });
}

/// A chain in which each level is smaller than the one above.
rc::Gen<std::vector<CostedLevel>> fallingChain()
{
    return rc::gen::map(chain(), [](std::vector<CostedLevel> levels) {
        std::sort(levels.begin(), levels.end(),
                  [](const CostedLevel& a, const CostedLevel& b) { return a.bytes > b.bytes; });
        return levels;
    });
}

rc::Gen<StreamingCostSettings> preset()
{
    return rc::gen::element(seedCost(), viewerCost(), honestCost());
}

StreamingCost costOf(const std::vector<CostedLevel>& levels, double radius, const StreamingCostSettings& settings)
{
    return streamingCost(levels, presetDistances(radius, levels.size(), settings).value(), settings).value();
}

/// What the whole disc would cost at the finest of the levels, and all duplicates on top.
double mostOf(const std::vector<CostedLevel>& levels, const StreamingCostSettings& settings)
{
    double most = 0;
    for (const CostedLevel& level : levels)
        most = std::max(most, std::max(level.bytes, settings.metadataDiscount + settings.minimumBytes));
    return most / settings.bytesPerTriangle * settings.budgetCost / settings.triangleBudget;
}

RC_GTEST_PROP(StreamingCostProperty, IsTheFourLevelFormulaForFourLevels, ())
{
    const double r = *radius();
    const std::array<double, 4> given = {*bytes(), *real(0, 1) < 0.3 ? 0.0 : *bytes(),
                                         *real(0, 1) < 0.3 ? 0.0 : *bytes(), *bytes()};
    const auto triangles = [](double count) { return std::max(count - 384, 16.0) / 16; };
    const auto within = [](double distance) { return std::min(kPi * distance * distance, 102932.0); };
    const double mid = within(std::min(r / 0.24, 512.0)), low = within(std::min(r / 0.06, 512.0)),
                 lowest = within(std::min(r / 0.03, 512.0));
    const std::array<double, 4> areas = {mid, low - mid, lowest - low, 102932.0 - lowest};
    double weighted = 0, sum = 0, taken = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        taken = given[i] > 0 ? given[i] : taken;
        weighted += std::max(areas[i], 1.0) * triangles(taken);
        sum += std::max(areas[i], 1.0);
    }
    const double expected = weighted / sum / 250000 * 15000;
    const std::vector<CostedLevel> levels = {{given[0], 0}, {given[1], 0}, {given[2], 0}, {given[3], 0}};
    RC_ASSERT(std::abs(costOf(levels, r, seedCost()).cost - expected) <= kRounding * expected);
}

RC_GTEST_PROP(StreamingCostProperty, SharesSumToOneAndNoneIsNothing, ())
{
    const StreamingCost cost = costOf(*chain(), *radius(), *preset());
    double sum = 0;
    for (const LevelCost& level : cost.levels) {
        RC_ASSERT(level.share > 0);
        sum += level.share;
    }
    RC_ASSERT(std::abs(sum - 1) <= kRounding);
}

RC_GTEST_PROP(StreamingCostProperty, NeverFallsWithBytes, ())
{
    const std::vector<CostedLevel> levels = *chain();
    const StreamingCostSettings settings = *preset();
    const double r = *radius();
    const double before = costOf(levels, r, settings).cost;
    for (std::size_t i = 0; i < levels.size(); ++i) {
        std::vector<CostedLevel> more = levels;
        more[i].bytes += *bytes();
        RC_ASSERT(costOf(more, r, settings).cost >= before * (1 - kRounding));
        more[i].duplicateBytes = more[i].bytes;
        RC_ASSERT(costOf(more, r, settings).cost >= before * (1 - kRounding));
    }
}

RC_GTEST_PROP(StreamingCostProperty, TakingBytesAwaySavesWhatTheDerivativeSays, ())
{
    const std::vector<CostedLevel> levels = *chain();
    const StreamingCostSettings settings = *preset();
    const double r = *radius();
    const StreamingCost before = costOf(levels, r, settings);
    for (std::size_t i = 0; i < levels.size(); ++i) {
        // Where the discount begins the two sides differ.
        const double kink = settings.metadataDiscount;
        if (levels[i].bytes < 2 || std::abs(levels[i].bytes - kink - settings.minimumBytes) < 2
            || std::abs(levels[i].duplicateBytes - kink) < 2)
            continue;
        std::vector<CostedLevel> less = levels;
        less[i].bytes -= 1;
        less[i].duplicateBytes -= std::min(1.0, less[i].duplicateBytes);
        const double saved = before.cost - costOf(less, r, settings).cost;
        RC_ASSERT(std::abs(saved - before.levels[i].costPerByte) <= 1e-9 * before.cost);
    }
}

RC_GTEST_PROP(StreamingCostProperty, NeverFallsWithSizeWhereLevelsGetSmaller, ())
{
    const std::vector<CostedLevel> levels = *fallingChain();
    const StreamingCostSettings settings = *preset();
    const double r = *radius(), larger = r * (1 + *real(0, 2));
    RC_ASSERT(costOf(levels, larger, settings).cost >= costOf(levels, r, settings).cost * (1 - kRounding));
}

RC_GTEST_PROP(StreamingCostProperty, NeverFallsByMoreThanTheClampWhenASwitchMovesAway, ())
{
    const std::vector<CostedLevel> levels = *fallingChain();
    RC_PRE(levels.size() > 1);
    const StreamingCostSettings settings = *preset();
    auto distances = *rc::gen::container<std::vector<double>>(levels.size() - 1, real(0, 250));
    std::sort(distances.begin(), distances.end());
    const double before = streamingCost(levels, distances, settings).value().cost;
    const auto moved = *rc::gen::inRange<std::size_t>(0, distances.size());
    const double end = moved + 1 < distances.size() ? distances[moved + 1] : 300.0;
    distances[moved] = *real(distances[moved], end);
    const double after = streamingCost(levels, distances, settings).value().cost;
    const double clamp = static_cast<double>(levels.size()) * settings.smallestArea / settings.largestArea;
    RC_ASSERT(after >= before - clamp * mostOf(levels, settings));
}

RC_GTEST_PROP(StreamingCostProperty, DoesNotJumpWithSize, ())
{
    constexpr double kStep = 1e-6;
    const std::vector<CostedLevel> levels = *chain();
    const StreamingCostSettings settings = *preset();
    const double r = *radius();
    const double change = std::abs(costOf(levels, r * (1 + kStep), settings).cost - costOf(levels, r, settings).cost);
    // Each area changes by at most twice its own size times the step, or its neighbours'.
    RC_ASSERT(change <= 8 * kStep * static_cast<double>(levels.size()) * mostOf(levels, settings));
}

RC_GTEST_PROP(StreamingCostProperty, IdenticalLevelsCostTheSameAtAnySize, ())
{
    const double count = *bytes();
    const std::vector<CostedLevel> levels(*rc::gen::inRange<std::size_t>(1, 9), {count, 0});
    const StreamingCostSettings settings = *preset();
    const double one = costOf({{count, 0}}, 1, settings).cost;
    RC_ASSERT(std::abs(costOf(levels, *radius(), settings).cost - one) <= kRounding * one);
}

RC_GTEST_PROP(StreamingCostProperty, UnitsDoNotMatter, ())
{
    const std::vector<CostedLevel> levels = *chain();
    const StreamingCostSettings settings = *preset();
    const double r = *radius(), scale = *real(0.01, 100);
    StreamingCostSettings scaled = settings;
    scaled.largestArea *= scale * scale;
    scaled.smallestArea *= scale * scale;
    scaled.largestDistance *= scale;
    const double expected = costOf(levels, r, settings).cost;
    RC_ASSERT(std::abs(costOf(levels, r * scale, scaled).cost - expected) <= 1e-9 * expected);
}

RC_GTEST_PROP(StreamingCostProperty, FollowsItsConstants, ())
{
    const std::vector<CostedLevel> levels = *chain();
    const StreamingCostSettings settings = *preset();
    const double r = *radius(), before = costOf(levels, r, settings).cost, more = 1 + *real(0, 5);
    const auto with = [&](const std::function<void(StreamingCostSettings&)>& change) {
        StreamingCostSettings changed = settings;
        change(changed);
        return costOf(levels, r, changed).cost;
    };
    const double slack = kRounding * before * more;
    RC_ASSERT(std::abs(with([&](auto& s) { s.budgetCost *= more; }) - before * more) <= slack);
    RC_ASSERT(std::abs(with([&](auto& s) { s.triangleBudget /= more; }) - before * more) <= slack);
    RC_ASSERT(std::abs(with([&](auto& s) { s.bytesPerTriangle /= more; }) - before * more) <= slack);
    RC_ASSERT(with([&](auto& s) { s.metadataDiscount *= more; }) <= before + slack);
    RC_ASSERT(with([&](auto& s) { s.minimumBytes *= more; }) >= before - slack);
}

} // namespace
} // namespace lodsmith
