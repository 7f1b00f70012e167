#include <lodsmith/analysis/CheapestChain.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace lodsmith {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// A level for each octave of deviation, each half as large as the one above.
std::vector<CandidateLevel> halvings()
{
    std::vector<CandidateLevel> candidates = {{100000, 0}};
    for (int i = 0; i < 8; ++i)
        candidates.push_back({50000 / std::pow(2, i), 0.002 * std::pow(2, i)});
    return candidates;
}

/// The cost of a choice, nothing when a level of it would not be seen from a square metre of the disc.
std::optional<double> costOf(const std::vector<CandidateLevel>& candidates, unsigned choice, const ErrorBudget& budget,
                             const StreamingCostSettings& settings)
{
    std::vector<CandidateLevel> chosen;
    for (std::size_t i = 1; i < candidates.size(); ++i)
        if ((choice >> (i - 1) & 1) != 0)
            chosen.push_back(candidates[i]);
    if (chosen.size() + 1 > budget.mostLevels)
        return std::nullopt;
    std::sort(chosen.begin(), chosen.end(),
              [](const CandidateLevel& a, const CandidateLevel& b) { return a.deviation < b.deviation; });
    std::vector<CostedLevel> levels = {{candidates[0].bytes, 0}};
    std::vector<double> distances;
    for (const CandidateLevel& level : chosen) {
        levels.push_back({level.bytes, 0});
        distances.push_back(sightDistance(level.deviation, budget));
    }
    const auto within = [&](double distance) {
        return std::min(kPi * std::pow(std::min(distance, settings.largestDistance), 2), settings.largestArea);
    };
    for (std::size_t i = 0; i < distances.size(); ++i) {
        const double end = i + 1 < distances.size() ? within(distances[i + 1]) : settings.largestArea;
        if (end - within(distances[i]) < settings.smallestArea)
            return std::nullopt;
    }
    return streamingCost(levels, distances, settings).value().cost;
}

double leastOfAllChoices(const std::vector<CandidateLevel>& candidates, const ErrorBudget& budget,
                         const StreamingCostSettings& settings)
{
    double least = costOf(candidates, 0, budget, settings).value();
    for (unsigned choice = 1; choice < 1u << (candidates.size() - 1); ++choice)
        least = std::min(least, costOf(candidates, choice, budget, settings).value_or(least));
    return least;
}

rc::Gen<double> real(double least, double most)
{
    return rc::gen::map(rc::gen::inRange<int>(0, 100001),
                        [=](int step) { return least + (most - least) * step / 100000.0; });
}

TEST(CheapestChainTest, SightDistanceIsWhereTheDeviationIsThatManyPixels)
{
    ErrorBudget budget;
    budget.pixels = 2;
    const double distance = sightDistance(0.3, budget);
    const double pixelsAtDistance = 0.3 / distance * (1080.0 / 2) / std::tan(kPi / 8);
    EXPECT_NEAR(pixelsAtDistance, 2, 1e-12);
    EXPECT_EQ(sightDistance(0, budget), 0);
}

RC_GTEST_PROP(CheapestChainProperty, NoChoiceIsCheaper, ())
{
    const auto count = *rc::gen::inRange<std::size_t>(0, 10);
    std::vector<CandidateLevel> candidates = {{*real(1, 100000), 0}};
    for (std::size_t i = 0; i < count; ++i)
        // Some deviations are equal, some beyond the disc, some candidates larger than the original.
        candidates.push_back({*real(1, 120000), std::floor(*real(0, 12)) * *rc::gen::element(0.0005, 0.02)});
    StreamingCostSettings settings = *rc::gen::element(seedCost(), viewerCost(), honestCost());
    settings.smallestArea = *rc::gen::element(1.0, 5000.0);
    settings.largestDistance = *rc::gen::element(512.0, 100.0);
    ErrorBudget budget;
    budget.pixels = *real(0.1, 3);
    budget.mostLevels = *rc::gen::inRange<std::size_t>(1, 11);
    const auto chain = cheapestChain(candidates, budget, settings);
    RC_ASSERT(chain.ok());
    const double least = leastOfAllChoices(candidates, budget, settings);
    RC_ASSERT(chain.value().cost.cost <= least * (1 + 1e-8));
    RC_ASSERT(chain.value().cost.cost >= least * (1 - 1e-12));
}

TEST(CheapestChainTest, ThisManyHalvingsAreAllWorthIt)
{
    ErrorBudget budget;
    budget.mostLevels = 20;
    const auto chain = cheapestChain(halvings(), budget, seedCost());
    ASSERT_TRUE(chain);
    // 0.128 m is a pixel at 167 m, inside of the disc; 0.256 m is not.
    EXPECT_EQ(chain.value().candidates, (std::vector<std::size_t>{0, 1, 2, 3, 4, 5, 6, 7}));
    EXPECT_NEAR(chain.value().distances.front(), sightDistance(0.002, budget), 1e-12);
    EXPECT_EQ(chain.value().cost.levels.size(), 8u);
}

TEST(CheapestChainTest, EachLevelIsWithinTheBudgetWhereItAppears)
{
    for (const double pixels : {0.25, 1.0, 4.0}) {
        ErrorBudget budget;
        budget.pixels = pixels;
        const std::vector<CandidateLevel> candidates = halvings();
        const auto chain = cheapestChain(candidates, budget, seedCost());
        ASSERT_TRUE(chain);
        for (std::size_t i = 0; i < chain.value().distances.size(); ++i) {
            const double deviation = candidates[chain.value().candidates[i + 1]].deviation;
            EXPECT_LE(deviation / chain.value().distances[i] * 540 / std::tan(kPi / 8), pixels * (1 + 1e-12));
        }
    }
}

TEST(CheapestChainTest, AWiderBudgetIsNeverDearer)
{
    double before = std::numeric_limits<double>::infinity();
    for (const double pixels : {0.1, 0.5, 1.0, 2.0, 8.0}) {
        ErrorBudget budget;
        budget.pixels = pixels;
        const auto chain = cheapestChain(halvings(), budget, seedCost());
        ASSERT_TRUE(chain);
        EXPECT_LT(chain.value().cost.cost, before);
        before = chain.value().cost.cost;
    }
}

TEST(CheapestChainTest, LeavesOutWhatSavesNothing)
{
    // Larger than what is drawn before; as small as it gets already; never seen.
    const std::vector<CandidateLevel> candidates = {{400, 0}, {500, 0.01}, {300, 0.02}, {100, 5000}};
    const auto chain = cheapestChain(candidates, {}, seedCost());
    ASSERT_TRUE(chain);
    EXPECT_EQ(chain.value().candidates, std::vector<std::size_t>{0});
    EXPECT_TRUE(chain.value().distances.empty());
}

TEST(CheapestChainTest, PicksTheOneBestLevelWhenThereMayBeOnlyOne)
{
    ErrorBudget budget;
    budget.mostLevels = 2;
    const std::vector<CandidateLevel> candidates = halvings();
    const auto chain = cheapestChain(candidates, budget, seedCost());
    ASSERT_TRUE(chain);
    ASSERT_EQ(chain.value().candidates.size(), 2u);
    EXPECT_NEAR(chain.value().cost.cost, leastOfAllChoices(candidates, budget, seedCost()), 1e-9);
}

TEST(CheapestChainTest, RefusesWhatIsOutOfRange)
{
    const auto fails = [](const std::vector<CandidateLevel>& candidates, const ErrorBudget& budget = {}) {
        const auto chain = cheapestChain(candidates, budget, seedCost());
        return !chain && chain.error().code == ErrorCode::InvalidSetting;
    };
    EXPECT_FALSE(fails({{1, 0}, {1, 1}}));
    EXPECT_TRUE(fails({}));
    EXPECT_TRUE(fails({{1, 1}}));
    EXPECT_TRUE(fails({{1, 0}, {0, 1}}));
    EXPECT_TRUE(fails({{1, 0}, {1, -1}}));
    EXPECT_TRUE(fails({{1, 0}, {1, std::nan("")}}));
    EXPECT_TRUE(fails({{1, 0}}, {0, 1080, 1, 8}));
    EXPECT_TRUE(fails({{1, 0}}, {1, 0, 1, 8}));
    EXPECT_TRUE(fails({{1, 0}}, {1, 1080, 4, 8}));
    EXPECT_TRUE(fails({{1, 0}}, {1, 1080, 1, 0}));
    StreamingCostSettings settings;
    settings.switchRatios.clear();
    EXPECT_FALSE(cheapestChain({{1, 0}}, {}, settings));
}

} // namespace
} // namespace lodsmith
