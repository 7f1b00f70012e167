#include "LevelSpec.h"

#include <gmock/gmock.h>

namespace lodsmith::cli {

namespace {

using testing::HasSubstr;

std::string messageOf(const std::string& text)
{
    const Result<LevelSpec> level = parseLevelSpec(text);
    return level ? "no error" : level.error().message;
}

} // namespace

TEST(LevelSpec, everyMethodHasItsTarget)
{
    const std::pair<const char*, LevelTarget::Kind> methods[] = {
        {"20:proportional:1", LevelTarget::Kind::Proportional},
        {"20:constant:1", LevelTarget::Kind::Constant},
        {"20:triangles:1", LevelTarget::Kind::Triangles},
        {"20:deviation:1", LevelTarget::Kind::Deviation},
        {"20:collapsecost:1", LevelTarget::Kind::CollapseCost}};
    for (const auto& [text, kind] : methods) {
        const Result<LevelSpec> level = parseLevelSpec(text);
        ASSERT_TRUE(level) << text;
        EXPECT_EQ(level.value().target.kind, kind) << text;
        EXPECT_EQ(level.value().target.amount, 1.0) << text;
        EXPECT_EQ(level.value().value, 20.0f) << text;
    }
}

TEST(LevelSpec, aFileNameMayHoldColons)
{
    const Result<LevelSpec> level = parseLevelSpec("1.5:mesh:dir/a:b.mesh");
    ASSERT_TRUE(level);
    EXPECT_TRUE(level.value().isManual());
    EXPECT_EQ(level.value().meshFile, "dir/a:b.mesh");
}

TEST(LevelSpec, amountsOutsideTheirRangeAreRefused)
{
    for (const char* text :
         {"20:proportional:1.01", "20:proportional:-0.1", "20:proportional:nan", "20:proportional:0,5",
          "20:proportional:", "20:constant:0.5", "20:constant:-1", "20:constant:4294967296", "20:triangles:1e3",
          "20:deviation:-1", "20:deviation:inf", "20:collapsecost:1e999"})
        EXPECT_THAT(messageOf(text), HasSubstr("is no amount")) << text;
}

TEST(LevelSpec, valuesThatNoStrategyCanHoldAreRefused)
{
    for (const char* text : {"0:proportional:0.5", "-1:proportional:0.5", "abc:proportional:0.5", ":proportional:0.5",
                             "1e19:proportional:0.5", "1e-60:proportional:0.5", "inf:proportional:0.5"})
        EXPECT_THAT(messageOf(text), HasSubstr("is no strategy value")) << text;
}

TEST(LevelSpec, errorsNameWhatWasFoundAndWhatIsAllowed)
{
    EXPECT_THAT(messageOf("20:half:0.5"), testing::AllOf(HasSubstr("'half'"), HasSubstr("proportional, constant")));
    EXPECT_THAT(messageOf("20:proportional:x"), testing::AllOf(HasSubstr("'x'"), HasSubstr("0 to 1")));
    EXPECT_THAT(messageOf("20"), HasSubstr("VALUE:METHOD:AMOUNT"));
    EXPECT_THAT(messageOf("20:mesh:"), HasSubstr("names no mesh file"));
}

TEST(LevelSpec, levelsComeNearestFirst)
{
    EXPECT_TRUE(parseLevelSpecs("10:constant:1,20:constant:2", LevelOrder::Rising));
    EXPECT_TRUE(parseLevelSpecs("20:constant:1,10:constant:2", LevelOrder::Falling));
    EXPECT_FALSE(parseLevelSpecs("20:constant:1,10:constant:2", LevelOrder::Rising));
    EXPECT_FALSE(parseLevelSpecs("10:constant:1,10:constant:2", LevelOrder::Rising));
    // Different numbers that are one and the same to OGRE.
    EXPECT_FALSE(parseLevelSpecs("16777216:constant:1,16777217:constant:2", LevelOrder::Rising));
}

TEST(LevelSpec, emptyPartsAreErrors)
{
    EXPECT_FALSE(parseLevelSpecs("", LevelOrder::Rising));
    EXPECT_FALSE(parseLevelSpecs("10:constant:1,", LevelOrder::Rising));
    EXPECT_FALSE(parseLevelSpecs(",10:constant:1", LevelOrder::Rising));
}

} // namespace lodsmith::cli
