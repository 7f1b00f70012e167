#include <lodsmith/analysis/StreamingCost.h>

#include "Rings.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lodsmith {

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kViewerRadius = 181.01933598375618; // 128 * sqrt(2)

Error invalid(std::string message)
{
    return Error{ErrorCode::InvalidSetting, std::move(message)};
}

bool isAtLeastZero(double number)
{
    return std::isfinite(number) && number >= 0.0;
}

bool isPositive(double number)
{
    return std::isfinite(number) && number > 0.0;
}

std::string troubleWithRatios(const std::vector<double>& ratios)
{
    if (ratios.empty())
        return "there are no switch ratios";
    if (!std::all_of(ratios.begin(), ratios.end(), isPositive))
        return "a switch ratio is no number above 0";
    return std::is_sorted(ratios.rbegin(), ratios.rend()) ? "" : "the switch ratios do not fall";
}

/// Whether fewer bytes count as fewer triangles.
bool shrinks(double bytes, const StreamingCostSettings& settings)
{
    return bytes - settings.metadataDiscount > settings.minimumBytes;
}

/// Triangles that a level's duplicates count as. The discount goes off here too, so that a level that is a duplicate as
/// a whole is charged as what it is.
double duplicateTriangles(const CostedLevel& level, const StreamingCostSettings& settings)
{
    return settings.chargeDuplicates
               ? std::max(level.duplicateBytes - settings.metadataDiscount, 0.0) / settings.bytesPerTriangle
               : 0.0;
}

Result<Done> check(const std::vector<CostedLevel>& levels, const std::vector<double>& distances,
                   const StreamingCostSettings& settings)
{
    if (const std::string trouble = troubleWith(settings); !trouble.empty())
        return invalid(trouble);
    if (levels.empty())
        return invalid("a chain has at least one level");
    if (distances.size() + 1 != levels.size())
        return invalid(std::to_string(levels.size()) + " levels have " + std::to_string(levels.size() - 1)
                       + " switch distances, not " + std::to_string(distances.size()));
    for (const CostedLevel& level : levels)
        if (!isAtLeastZero(level.bytes) || !isAtLeastZero(level.duplicateBytes) || level.duplicateBytes > level.bytes)
            return invalid("the bytes of a level are a number of at least 0, and duplicates are among them");
    if (!std::all_of(distances.begin(), distances.end(), isAtLeastZero)
        || !std::is_sorted(distances.begin(), distances.end()))
        return invalid("switch distances are numbers of at least 0, and do not fall");
    return Done{};
}

/// Each level's distance and share.
std::vector<LevelCost> ringsOf(const std::vector<double>& distances, const StreamingCostSettings& settings)
{
    std::vector<LevelCost> levels(distances.size() + 1);
    double sum = 0.0;
    for (std::size_t i = 0; i < levels.size(); ++i) {
        levels[i].distance = i == 0 ? 0.0 : distances[i - 1];
        const double outer = i < distances.size() ? distances[i] : std::numeric_limits<double>::infinity();
        levels[i].share = ringArea(levels[i].distance, outer, settings);
        sum += levels[i].share;
    }
    for (LevelCost& level : levels)
        level.share /= sum;
    return levels;
}

/// Counts triangles and what a byte of each level weighs: a level that is missing is drawn from the bytes of the one
/// above.
void countTriangles(const std::vector<CostedLevel>& levels, const StreamingCostSettings& settings,
                    StreamingCost& result)
{
    const double costOfTriangle = settings.budgetCost / settings.triangleBudget;
    std::size_t drawn = 0;
    for (std::size_t i = 0; i < levels.size(); ++i) {
        if (levels[i].bytes > 0.0)
            drawn = i;
        LevelCost& level = result.levels[i];
        level.triangles = countedTriangles(levels[drawn].bytes, settings);
        const double charged = duplicateTriangles(levels[i], settings);
        const double weighted = level.share * level.triangles + charged;
        level.cost = weighted * costOfTriangle;
        result.weightedTriangles += weighted;
        result.bytes += levels[i].bytes;
        const double weight =
            (shrinks(levels[drawn].bytes, settings) ? level.share : 0.0) + (charged > 0.0 ? 1.0 : 0.0);
        result.levels[drawn].costPerByte += weight * costOfTriangle / settings.bytesPerTriangle;
    }
    result.cost = result.weightedTriangles * costOfTriangle;
}

/// A chain that costs nothing, whatever it weighs.
void makeFree(StreamingCost& result)
{
    result.cost = result.weightedTriangles = 0.0;
    for (LevelCost& level : result.levels)
        level.cost = level.costPerByte = level.triangles = 0.0;
}

} // namespace

StreamingCostSettings seedCost()
{
    return {};
}

StreamingCostSettings viewerCost()
{
    StreamingCostSettings settings;
    settings.largestArea = kPi * kViewerRadius * kViewerRadius;
    settings.freeWithoutLowest = true;
    return settings;
}

StreamingCostSettings honestCost()
{
    StreamingCostSettings settings = viewerCost();
    settings.freeWithoutLowest = false;
    settings.chargeDuplicates = true;
    return settings;
}

std::string troubleWith(const StreamingCostSettings& settings)
{
    if (!isAtLeastZero(settings.metadataDiscount) || !isAtLeastZero(settings.minimumBytes))
        return "the discount and the least bytes of a level are numbers of at least 0";
    if (!isPositive(settings.bytesPerTriangle) || !isPositive(settings.triangleBudget)
        || !isPositive(settings.budgetCost))
        return "the bytes of a triangle, the budget and its cost are numbers above 0";
    if (!isPositive(settings.smallestArea) || !isPositive(settings.largestArea)
        || settings.smallestArea > settings.largestArea)
        return "areas are numbers above 0, the smallest no larger than the largest";
    if (!isPositive(settings.largestDistance))
        return "the largest distance is a number above 0";
    return troubleWithRatios(settings.switchRatios);
}

Result<std::vector<double>> presetDistances(double radius, std::size_t levels, const StreamingCostSettings& settings)
{
    if (const std::string trouble = troubleWith(settings); !trouble.empty())
        return invalid(trouble);
    if (!isAtLeastZero(radius))
        return invalid("the radius is no number of at least 0");
    if (levels == 0)
        return invalid("a chain has at least one level");
    std::vector<double> distances;
    double ratio = 0.0;
    for (std::size_t i = 0; i + 1 < levels; ++i) {
        ratio = i < settings.switchRatios.size() ? settings.switchRatios[i] : ratio / 2.0;
        // The ratio of a long chain's last levels may come to nothing.
        distances.push_back(radius > 0.0 ? std::min(radius / ratio, settings.largestDistance) : 0.0);
    }
    return distances;
}

Result<StreamingCost> streamingCost(const std::vector<CostedLevel>& levels, const std::vector<double>& distances,
                                    const StreamingCostSettings& settings)
{
    if (const Result<Done> checked = check(levels, distances, settings); !checked)
        return checked.error();
    StreamingCost result;
    result.levels = ringsOf(distances, settings);
    countTriangles(levels, settings, result);
    if (levels.front().bytes <= 0.0 || (settings.freeWithoutLowest && levels.back().bytes <= 0.0))
        makeFree(result);
    if (!std::isfinite(result.cost) || !std::isfinite(result.weightedTriangles))
        return Error{ErrorCode::InvalidSetting,
                     "the cost is too large for a number: a constant is far too small or large"};
    return result;
}

std::size_t levelAt(const StreamingCost& cost, double distance)
{
    std::size_t level = 0;
    while (level + 1 < cost.levels.size() && cost.levels[level + 1].distance <= distance)
        ++level;
    return level;
}

} // namespace lodsmith
