#include "Statistics.h"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

namespace lodsmith::benchmarks {

namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using Values = std::vector<double>;

constexpr double kRounding = 1e-12;

TEST(Statistics, theRankTestOfSeparateSamplesCountsTheTwoExtremeChoices)
{
    // Of the 20 ways to choose three of six ranks one is lowest and one highest.
    EXPECT_NEAR(rankTest({1, 2, 3}, {4, 5, 6}), 2.0 / 20.0, kRounding);
    EXPECT_NEAR(rankTest({4, 5, 6}, {1, 2, 3}), 2.0 / 20.0, kRounding);
    EXPECT_NEAR(leastRankChance(3, 3), 2.0 / 20.0, kRounding);
}

TEST(Statistics, theRankTestCountsEveryChoiceThatIsAsFarApart)
{
    // Rank sum 7 for {1, 2, 4}: lower are {1, 2, 3} alone, so 2 of 20 choices at each end.
    EXPECT_NEAR(rankTest({1, 2, 4}, {3, 5, 6}), 4.0 / 20.0, kRounding);
    EXPECT_DOUBLE_EQ(rankTest({1, 4}, {2, 3}), 1.0);
}

TEST(Statistics, theRankTestSaysNothingOfEqualOrMissingValues)
{
    EXPECT_DOUBLE_EQ(rankTest({2, 2, 2}, {2, 2, 2}), 1.0);
    EXPECT_DOUBLE_EQ(rankTest({}, {1, 2, 3}), 1.0);
}

TEST(Statistics, theApproximationForLargeSamplesAgreesWithTheExactTest)
{
    std::mt19937 random(3);
    std::normal_distribution<double> noise;
    for (const double shift : {0.0, 0.4, 0.8}) {
        Values a, b;
        for (int i = 0; i < 20; ++i) {
            a.push_back(noise(random));
            b.push_back(noise(random) + shift);
        }
        const double exact = rankTest(a, b);
        // One tie, between the smallest two values, hardly changes the ranks but takes the other way.
        Values tied = a;
        tied.push_back(-100.0);
        tied.push_back(-100.0);
        Values untied = a;
        untied.push_back(-100.0);
        untied.push_back(-101.0);
        EXPECT_NEAR(rankTest(tied, b), rankTest(untied, b), 0.02) << "shift " << shift;
        EXPECT_GE(exact, leastRankChance(20, 20));
    }
}

TEST(Statistics, theRankTestIsWrongAsOftenAsItSays)
{
    std::mt19937 random(7);
    std::lognormal_distribution<double> noise;
    constexpr int kTrials = 4000;
    int alarms = 0;
    for (int trial = 0; trial < kTrials; ++trial) {
        Values a, b;
        for (int i = 0; i < 9; ++i) {
            a.push_back(noise(random));
            b.push_back(noise(random));
        }
        alarms += rankTest(a, b) < 0.05;
    }
    // Four standard deviations above 5%; the test is discrete, so that it may well be below.
    EXPECT_LT(alarms, kTrials * 0.05 + 4.0 * std::sqrt(kTrials * 0.05 * 0.95));
    EXPECT_GT(alarms, kTrials * 0.03);
}

TEST(Statistics, theSignTestCountsChoicesOfSigns)
{
    // Of the 64 choices two have all signs the same.
    EXPECT_NEAR(signTest({1, 2, 3, 4, 5, 6}), 2.0 / 64.0, kRounding);
    EXPECT_NEAR(signTest({-1, -2, -3, -4, -5, -6}), 2.0 / 64.0, kRounding);
    EXPECT_DOUBLE_EQ(signTest({1, -1}), 1.0);
    EXPECT_DOUBLE_EQ(signTest({}), 1.0);
}

TEST(Statistics, theSignTestOfManyValuesIsReproducibleAndNeverZero)
{
    const Values values(40, 0.1);
    EXPECT_EQ(signTest(values), signTest(values));
    EXPECT_GT(signTest(values), 0.0);
    EXPECT_LT(signTest(values), 0.001);
    Values even = values;
    for (std::size_t i = 0; i < even.size(); i += 2)
        even[i] = -even[i];
    EXPECT_GT(signTest(even), 0.5);
}

TEST(Statistics, manyQuestionsMakeEachAnswerLessCertain)
{
    // Holm: the least times 3, the next times 2, the largest as it is, and never below one before.
    EXPECT_THAT(correctedForMany({0.02, 0.01, 0.5}),
                ElementsAre(DoubleNear(0.04, kRounding), DoubleNear(0.03, kRounding), DoubleNear(0.5, kRounding)));
    EXPECT_THAT(correctedForMany({0.01, 0.012}), ElementsAre(DoubleNear(0.02, kRounding), DoubleNear(0.02, kRounding)));
    EXPECT_THAT(correctedForMany({0.9, 0.8}), ElementsAre(1.0, 1.0));
}

TEST(Statistics, theSpreadIgnoresAFewOutliers)
{
    std::mt19937 random(5);
    std::normal_distribution<double> noise(3.0, 0.5);
    Values values;
    for (int i = 0; i < 1000; ++i)
        values.push_back(i % 20 == 0 ? 100.0 : noise(random));
    EXPECT_NEAR(robustSpread(values), 0.5, 0.07);
}

} // namespace

} // namespace lodsmith::benchmarks
