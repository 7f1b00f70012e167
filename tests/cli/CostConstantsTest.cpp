#include "CostConstants.h"

#include <gmock/gmock.h>

namespace lodsmith::cli {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string complaintAbout(const std::string& text)
{
    StreamingCostSettings settings;
    const Result<Done> set = setCostConstants(text, settings);
    return set ? "nothing" : set.error().message;
}

} // namespace

TEST(CostConstants, everyConstantHasAName)
{
    StreamingCostSettings settings = honestCost();
    const Result<Done> set = setCostConstants(
        "metadata_discount=1,minimum_bytes=2,bytes_per_triangle=3,triangle_budget=4,budget_cost=5,largest_area=6,"
        "smallest_area=0.7,largest_distance=8,switch_ratios=0.5/0.25,free_without_lowest=yes,charge_duplicates=no",
        settings);
    ASSERT_TRUE(set) << describe(set.error());
    EXPECT_EQ(settings.metadataDiscount, 1);
    EXPECT_EQ(settings.minimumBytes, 2);
    EXPECT_EQ(settings.bytesPerTriangle, 3);
    EXPECT_EQ(settings.triangleBudget, 4);
    EXPECT_EQ(settings.budgetCost, 5);
    EXPECT_EQ(settings.largestArea, 6);
    EXPECT_EQ(settings.smallestArea, 0.7);
    EXPECT_EQ(settings.largestDistance, 8);
    EXPECT_THAT(settings.switchRatios, ElementsAre(0.5, 0.25));
    EXPECT_TRUE(settings.freeWithoutLowest);
    EXPECT_FALSE(settings.chargeDuplicates);
}

TEST(CostConstants, whatIsNotNamedStays)
{
    StreamingCostSettings settings = viewerCost();
    ASSERT_TRUE(setCostConstants("budget_cost=1", settings));
    EXPECT_EQ(settings.largestArea, viewerCost().largestArea);
    EXPECT_TRUE(settings.freeWithoutLowest);
}

TEST(CostConstants, whatIsWrongIsSaid)
{
    EXPECT_THAT(complaintAbout("price=1"), HasSubstr("'price' is no constant; there are "));
    EXPECT_THAT(complaintAbout("price=1"), HasSubstr("triangle_budget"));
    EXPECT_THAT(complaintAbout(""), HasSubstr("NAME=VALUE"));
    EXPECT_THAT(complaintAbout("budget_cost"), HasSubstr("NAME=VALUE"));
    EXPECT_THAT(complaintAbout("budget_cost=1,"), HasSubstr("NAME=VALUE"));
    EXPECT_THAT(complaintAbout("budget_cost=1,budget_cost=2"), HasSubstr("twice"));
    EXPECT_THAT(complaintAbout("budget_cost=much"), HasSubstr("'much' is no number"));
    EXPECT_THAT(complaintAbout("switch_ratios=0.2//0.1"), HasSubstr("'' is no number"));
    EXPECT_THAT(complaintAbout("switch_ratios=0.1/0.2"), HasSubstr("do not fall"));
    EXPECT_THAT(complaintAbout("charge_duplicates=1"), HasSubstr("neither yes nor no"));
    EXPECT_THAT(complaintAbout("bytes_per_triangle=0"), HasSubstr("above 0"));
}

} // namespace lodsmith::cli
