#include <lodsmith/analysis/StreamingCost.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace lodsmith {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// The published formula with the viewer's disc, and the published treatment of missing levels.
StreamingCostSettings published()
{
    StreamingCostSettings settings = viewerCost();
    settings.freeWithoutLowest = false;
    return settings;
}

std::vector<CostedLevel> levelsOf(const std::vector<double>& bytes)
{
    std::vector<CostedLevel> levels;
    for (const double count : bytes)
        levels.push_back({count, 0.0});
    return levels;
}

StreamingCost costAt(double radius, const std::vector<CostedLevel>& levels,
                     const StreamingCostSettings& settings = published())
{
    const auto distances = presetDistances(radius, levels.size(), settings);
    EXPECT_TRUE(distances);
    const auto cost = streamingCost(levels, distances.value(), settings);
    EXPECT_TRUE(cost) << describe(cost.error());
    return cost.value();
}

double costAt(double radius, const std::vector<double>& bytes, const StreamingCostSettings& settings = published())
{
    return costAt(radius, levelsOf(bytes), settings).cost;
}

const std::vector<double> kChain = {33000, 8500, 2500, 1000};
const std::vector<double> kHighOnly = {33000, 0, 0, 0};

TEST(StreamingCostTest, AgreesWithTheIndependentEvaluationOfTheFormula)
{
    const std::pair<double, double> expected[] = {{0.5, 2.4175}, {1, 2.7401},   {5, 13.0636},
                                                  {10, 31.8758}, {20, 49.9049}, {60, 122.3068}};
    for (const auto& [radius, cost] : expected) {
        EXPECT_NEAR(costAt(radius, kChain), cost, 1e-4 * cost) << radius;
        EXPECT_NEAR(costAt(radius, kHighOnly), 122.31, 1e-4 * 122.31) << radius;
    }
    EXPECT_NEAR(costAt(10, kChain, seedCost()), 31.8786, 1e-5 * 31.8786);
}

TEST(StreamingCostTest, TheViewersDiscIsThatOfItsRadius)
{
    EXPECT_NEAR(viewerCost().largestArea, 102944, 0.5);
    EXPECT_NEAR(viewerCost().largestArea, kPi * std::pow(128 * std::sqrt(2.0), 2), 1e-6);
}

TEST(StreamingCostTest, AMissingLevelIsDrawnFromTheNextHigherOne)
{
    EXPECT_DOUBLE_EQ(costAt(7, {33000, 0, 2500, 0}), costAt(7, {33000, 33000, 2500, 2500}));
    EXPECT_DOUBLE_EQ(costAt(7, {33000, 8500, 0, 0}), costAt(7, {33000, 8500, 8500, 8500}));
}

TEST(StreamingCostTest, AMissingHighLevelMakesItFree)
{
    const StreamingCost cost = costAt(7, levelsOf({0, 8500, 2500, 1000}));
    EXPECT_EQ(cost.cost, 0);
    EXPECT_EQ(cost.weightedTriangles, 0);
    EXPECT_EQ(cost.bytes, 12000);
    for (const LevelCost& level : cost.levels)
        EXPECT_EQ(level.costPerByte, 0);
}

TEST(StreamingCostTest, TodaysViewerAsksNothingWithoutALowestLevel)
{
    EXPECT_EQ(costAt(7, {33000, 8500, 2500, 0}, viewerCost()), 0);
    EXPECT_GT(costAt(7, {33000, 8500, 2500, 0}, seedCost()), 0);
    EXPECT_NEAR(costAt(10, kChain, viewerCost()), 31.8758, 1e-4 * 31.8758);
}

TEST(StreamingCostTest, SwitchesAndInflectionsAreAsPublished)
{
    const auto distances = presetDistances(2.4, 4, published());
    ASSERT_TRUE(distances);
    EXPECT_NEAR(distances.value()[0], 10, 1e-12);
    EXPECT_NEAR(distances.value()[1], 40, 1e-12);
    EXPECT_NEAR(distances.value()[2], 80, 1e-12);
    // The lowest, the low and the middle level leave the disc one after the other.
    const std::pair<double, std::size_t> gone[] = {{5.43, 3}, {10.86, 2}, {43.44, 1}};
    for (const auto& [radius, level] : gone) {
        EXPECT_GT(costAt(radius - 0.02, levelsOf(kChain)).levels[level].share, 1.5e-5) << radius;
        EXPECT_LT(costAt(radius + 0.02, levelsOf(kChain)).levels[level].share, 1.0e-5) << radius;
    }
}

TEST(StreamingCostTest, BeyondTheLastInflectionOnlyTheHighLevelCounts)
{
    for (const double radius : {43.45, 60.0, 500.0})
        EXPECT_NEAR(costAt(radius, kChain), costAt(radius, kHighOnly), 3e-5 * costAt(radius, kHighOnly));
}

TEST(StreamingCostTest, NoSwitchIsBeyondTheLargestDistance)
{
    const auto distances = presetDistances(60, 4, published());
    ASSERT_TRUE(distances);
    EXPECT_DOUBLE_EQ(distances.value()[0], 250);
    EXPECT_EQ(distances.value()[1], 512);
    EXPECT_EQ(distances.value()[2], 512);
}

TEST(StreamingCostTest, FurtherLevelsAppearAtHalfTheRatioEach)
{
    const auto distances = presetDistances(0.3, 6, published());
    ASSERT_TRUE(distances);
    EXPECT_NEAR(distances.value()[3], 2 * distances.value()[2], 1e-12);
    EXPECT_NEAR(distances.value()[4], 4 * distances.value()[2], 1e-12);
    const auto none = presetDistances(0.0, 5000, published());
    ASSERT_TRUE(none);
    EXPECT_EQ(none.value().back(), 0);
}

TEST(StreamingCostTest, FourIdenticalLevelsCostFourTimesAsMuchOnlyWhereDuplicatesAreCharged)
{
    const std::vector<CostedLevel> copies = {{33000, 0}, {33000, 33000}, {33000, 33000}, {33000, 33000}};
    for (const double radius : {0.5, 5.0, 60.0}) {
        EXPECT_NEAR(costAt(radius, copies, viewerCost()).cost, 122.31, 1e-9);
        EXPECT_NEAR(costAt(radius, copies, honestCost()).cost, 4 * 122.31, 1e-9);
        EXPECT_NEAR(costAt(radius, levelsOf(kChain), honestCost()).cost, costAt(radius, kChain), 1e-9);
    }
}

TEST(StreamingCostTest, PartsSumToTheWhole)
{
    const StreamingCost cost = costAt(6, {{33000, 0}, {8500, 4000}, {0, 0}, {1000, 900}, {900, 0}}, honestCost());
    double costs = 0, shares = 0;
    for (const LevelCost& level : cost.levels) {
        costs += level.cost;
        shares += level.share;
    }
    EXPECT_NEAR(costs, cost.cost, 1e-12 * cost.cost);
    EXPECT_NEAR(shares, 1, 1e-12);
    EXPECT_EQ(cost.bytes, 33000 + 8500 + 1000 + 900);
    EXPECT_NEAR(cost.cost, cost.weightedTriangles * 15000 / 250000, 1e-12 * cost.cost);
}

TEST(StreamingCostTest, TheDerivativeIsWhatAByteLessSaves)
{
    // A level that is missing below, one with duplicates, one that is down to the least already.
    const std::vector<CostedLevel> levels = {{33000, 0}, {8500, 4000}, {0, 0}, {390, 100}, {900, 900}};
    const StreamingCost cost = costAt(3, levels, honestCost());
    for (std::size_t i = 0; i < levels.size(); ++i) {
        std::vector<CostedLevel> less = levels;
        const double taken = levels[i].bytes > 0 ? 1 : 0;
        less[i].bytes -= taken;
        less[i].duplicateBytes -= std::min(taken, less[i].duplicateBytes);
        EXPECT_NEAR(cost.levels[i].costPerByte, cost.cost - costAt(3, less, honestCost()).cost, 1e-9) << i;
    }
    EXPECT_GT(cost.levels[1].costPerByte, 0);
    EXPECT_EQ(cost.levels[2].costPerByte, 0);
    EXPECT_EQ(cost.levels[3].costPerByte, 0);
}

TEST(StreamingCostTest, SaysWhichLevelIsDrawnWhere)
{
    const StreamingCost cost = costAt(2.4, levelsOf(kChain)); // 10, 40, 80
    EXPECT_EQ(levelAt(cost, 0), 0u);
    EXPECT_EQ(levelAt(cost, 9.99), 0u);
    EXPECT_EQ(levelAt(cost, 10.01), 1u);
    EXPECT_EQ(levelAt(cost, 79), 2u);
    EXPECT_EQ(levelAt(cost, 1e9), 3u);
}

TEST(StreamingCostTest, RefusesWhatIsOutOfRange)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto fails = [](const std::vector<CostedLevel>& levels, const std::vector<double>& distances,
                          const StreamingCostSettings& settings = seedCost()) {
        const auto cost = streamingCost(levels, distances, settings);
        return !cost && cost.error().code == ErrorCode::InvalidSetting;
    };
    EXPECT_FALSE(fails({{1, 0}, {1, 0}}, {1}));
    EXPECT_TRUE(fails({}, {}));
    EXPECT_TRUE(fails({{1, 0}}, {1}));
    EXPECT_TRUE(fails({{1, 0}, {1, 0}}, {-1}));
    EXPECT_TRUE(fails({{1, 0}, {1, 0}}, {nan}));
    EXPECT_TRUE(fails({{1, 0}, {1, 0}, {1, 0}}, {2, 1}));
    EXPECT_TRUE(fails({{-1, 0}}, {}));
    EXPECT_TRUE(fails({{nan, 0}}, {}));
    EXPECT_TRUE(fails({{1, 2}}, {}));
    EXPECT_FALSE(presetDistances(nan, 1, seedCost()));
    EXPECT_FALSE(presetDistances(-1, 1, seedCost()));
    EXPECT_FALSE(presetDistances(1, 0, seedCost()));
}

TEST(StreamingCostTest, RefusesConstantsThatMakeNoSense)
{
    const auto fails = [](const std::function<void(StreamingCostSettings&)>& change) {
        StreamingCostSettings settings;
        change(settings);
        return !troubleWith(settings).empty() && !streamingCost({{1, 0}}, {}, settings)
               && !presetDistances(1, 1, settings);
    };
    EXPECT_FALSE(fails([](auto&) {}));
    EXPECT_TRUE(fails([](auto& settings) { settings.metadataDiscount = -1; }));
    EXPECT_TRUE(fails([](auto& settings) { settings.minimumBytes = -1; }));
    EXPECT_TRUE(fails([](auto& settings) { settings.bytesPerTriangle = 0; }));
    EXPECT_TRUE(fails([](auto& settings) { settings.triangleBudget = 0; }));
    EXPECT_TRUE(fails([](auto& settings) { settings.budgetCost = 0; }));
    EXPECT_TRUE(fails([](auto& settings) { settings.smallestArea = 0; }));
    EXPECT_TRUE(fails([](auto& settings) { settings.largestArea = 0.5; }));
    EXPECT_TRUE(fails([](auto& settings) { settings.largestDistance = 0; }));
    EXPECT_TRUE(fails([](auto& settings) { settings.switchRatios.clear(); }));
    EXPECT_TRUE(fails([](auto& settings) { settings.switchRatios = {0.1, 0.2}; }));
    EXPECT_TRUE(fails([](auto& settings) { settings.switchRatios = {0.1, 0}; }));
}

} // namespace
} // namespace lodsmith
