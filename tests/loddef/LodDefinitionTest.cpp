#include <lodsmith/loddef/LodDefinition.h>

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

namespace lodsmith {

namespace {

using Kind = LevelTarget::Kind;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

LodLevelDefinition reduced(float value, LevelTarget target = {})
{
    return {value, target, "", ""};
}

LodLevelDefinition manual(float value, const std::string& name)
{
    return {value, {}, name, ""};
}

LodDefinition withLevels(std::vector<LodLevelDefinition> levels)
{
    LodDefinition definition;
    definition.levels = std::move(levels);
    return definition;
}

/// The only error, as text; empty when there is none, all of them when there are several.
std::string errorOf(const LodDefinition& definition)
{
    std::string all;
    for (const Error& error : findErrors(definition)) {
        EXPECT_EQ(error.code, ErrorCode::InvalidSetting);
        all += (all.empty() ? "" : "\n") + describe(error);
    }
    return all;
}

} // namespace

TEST(LodDefinition, defaultsAreInOrder)
{
    const LodDefinition definition;
    EXPECT_TRUE(definition.automatic);
    EXPECT_EQ(definition.type, LodDefinitionType::Automatic);
    EXPECT_EQ(definition.strategy, LodStrategy::DistanceSphere);
    EXPECT_THAT(findErrors(definition), IsEmpty());
}

TEST(LodDefinition, valuesAreAboveZeroAndWithinWhatASquareCanHold)
{
    for (const float value : {1e-30f, 20.0f, 1e18f})
        EXPECT_EQ(errorOf(withLevels({reduced(value)})), "");
    for (const float value : {0.0f, -1.0f, 2e18f, kNan, kInfinity})
        EXPECT_THAT(errorOf(withLevels({reduced(value)})), HasSubstr("allowed: a number above 0 and at most 1e18"));
}

TEST(LodDefinition, amountsAreWithinTheRangeOfTheirMethod)
{
    const LevelTarget right[] = {{Kind::Proportional, 0.0}, {Kind::Proportional, 1.0}, {Kind::Constant, 50.5},
                                 {Kind::Triangles, 0.0},    {Kind::Deviation, 0.0},    {Kind::CollapseCost, 1e300}};
    for (const LevelTarget& target : right)
        EXPECT_EQ(errorOf(withLevels({reduced(1, target)})), "") << target.amount;
    const LevelTarget wrong[] = {
        {Kind::Proportional, -0.1},   {Kind::Proportional, 1.001}, {Kind::Constant, -1},
        {Kind::Constant, 4294967296}, {Kind::Triangles, 10.5},     {Kind::Triangles, -1},
        {Kind::Deviation, -1},        {Kind::Deviation, kNan},     {Kind::CollapseCost, kInfinity}};
    for (const LevelTarget& target : wrong)
        EXPECT_THAT(errorOf(withLevels({reduced(1, target)})), AllOf(HasSubstr("level 1: "), HasSubstr("; allowed: ")))
            << target.amount;
}

TEST(LodDefinition, noDistanceComesTwice)
{
    EXPECT_THAT(errorOf(withLevels({reduced(20), reduced(40), manual(20, "a.mesh")})),
                AllOf(HasSubstr("level 3: "), HasSubstr("that of level 1 already")));
}

TEST(LodDefinition, everyLevelOfTheTypeUserHasAMesh)
{
    LodDefinition definition = withLevels({manual(20, "a.mesh"), reduced(40)});
    EXPECT_EQ(errorOf(definition), "");
    definition.type = LodDefinitionType::User;
    EXPECT_THAT(errorOf(definition), HasSubstr("level 2: the level has no mesh name"));
}

TEST(LodDefinition, meshNamesAreOnesThatAFileCanHold)
{
    for (const std::string& name :
         {std::string("a.mesh"), std::string("dir/\xc3\xa9 <&>'\".mesh"), std::string(1024, 'x')})
        EXPECT_EQ(errorOf(withLevels({manual(1, name)})), "");
    for (const std::string& name : {std::string(" "), std::string("a "), std::string("\ta"), std::string("a\nb"),
                                    std::string("a\0b", 3), std::string("\xff"), std::string(1025, 'x')})
        EXPECT_THAT(errorOf(withLevels({manual(1, name)})), HasSubstr("the mesh name is")) << name;
}

TEST(LodDefinition, thereAreAsManyLevelsAsAllowed)
{
    LodDefinition definition;
    while (definition.levels.size() < kMaxLoddefLevels)
        definition.levels.push_back(reduced(1.0f + static_cast<float>(definition.levels.size())));
    EXPECT_EQ(errorOf(definition), "");
    definition.levels.push_back(reduced(1e6f));
    EXPECT_THAT(errorOf(definition), HasSubstr("257 levels are too many"));
}

TEST(LodDefinition, weightsAreNumbersForTheQuadricMetric)
{
    LodDefinition definition;
    definition.weights.uv = 0.5f;
    EXPECT_EQ(errorOf(definition), "");
    definition.metric = Metric::Curvature;
    EXPECT_THAT(errorOf(definition), HasSubstr("allowed: the metric quadric"));
    definition.metric.reset();
    definition.levels = {reduced(1, {Kind::CollapseCost, 1.0})};
    EXPECT_THAT(errorOf(definition), HasSubstr("allowed: the metric quadric"));
    definition.metric = Metric::Quadric;
    EXPECT_EQ(errorOf(definition), "");
    definition.weights.uv = -1.0f;
    EXPECT_THAT(errorOf(definition), HasSubstr("the weight uv is '-1'"));
}

TEST(LodDefinition, eachSubMeshHasOneImportance)
{
    LodDefinition definition;
    definition.subMeshes = {{0, 0.0f}, {65535, 1.0f}};
    EXPECT_EQ(errorOf(definition), "");
    definition.subMeshes = {{2, 1.5f}, {3, kNan}};
    EXPECT_THAT(errorOf(definition), AllOf(HasSubstr("submesh 2 is '1.5'"), HasSubstr("submesh 3 is 'nan'")));
    definition.subMeshes = {{2, 0.5f}, {2, 0.5f}};
    EXPECT_THAT(errorOf(definition), HasSubstr("submesh 2 has an importance already"));
}

TEST(LodDefinition, levelsComeNearestFirst)
{
    LodDefinition definition = withLevels({reduced(40), manual(10, "a.mesh"), reduced(20)});
    const auto values = [&definition] {
        std::vector<float> all;
        for (const LodLevelDefinition& level : levelsNearestFirst(definition))
            all.push_back(level.value);
        return all;
    };
    for (const LodStrategy strategy : {LodStrategy::DistanceSphere, LodStrategy::DistanceBox}) {
        definition.strategy = strategy;
        EXPECT_THAT(values(), testing::ElementsAre(10, 20, 40));
    }
    for (const LodStrategy strategy : {LodStrategy::PixelCount, LodStrategy::ScreenRatioPixelCount}) {
        definition.strategy = strategy;
        EXPECT_THAT(values(), testing::ElementsAre(40, 20, 10));
    }
    EXPECT_TRUE(levelsNearestFirst(definition)[2].isManual());
}

TEST(LodDefinition, optionsTakeDefaultsForWhatIsNotGiven)
{
    LodDefinition definition;
    definition.weights.uv = 0.0f;
    definition.lockBorders = true;
    const SimplifyOptions options = simplifyOptions(definition);
    EXPECT_EQ(options.weights.uv, 0.0f);
    EXPECT_EQ(options.weights.normal, AttributeWeights().normal);
    EXPECT_EQ(options.weights.colour, AttributeWeights().colour);
    EXPECT_EQ(options.weights.bone, AttributeWeights().bone);
    EXPECT_TRUE(options.lockBorders);
    EXPECT_FALSE(options.lockSeams);
}

TEST(LodDefinition, costsTakeTheMetricTheyWereMadeForUnlessOneIsNamed)
{
    LodDefinition definition = withLevels({reduced(1), reduced(2, {Kind::Deviation, 1.0})});
    EXPECT_EQ(simplifyOptions(definition).metric, Metric::Quadric);
    definition.levels.push_back(reduced(3, {Kind::CollapseCost, 1.0}));
    EXPECT_EQ(simplifyOptions(definition).metric, Metric::Curvature);
    definition.levels[2].meshName = "a.mesh";
    EXPECT_EQ(simplifyOptions(definition).metric, Metric::Quadric) << "a hand-made level has no target";
    definition.levels[2].meshName.clear();
    definition.metric = Metric::Quadric;
    EXPECT_EQ(simplifyOptions(definition).metric, Metric::Quadric);
}

TEST(LodDefinition, equalityIsThatOfTheMeaning)
{
    const LodDefinition definition = withLevels({reduced(1, {Kind::Constant, 5}), manual(2, "a.mesh")});
    LodDefinition other = definition;
    other.original = "<lod/>";
    other.levels[0].original = "<level/>";
    other.levels[1].target = {Kind::Constant, 7};
    EXPECT_EQ(other, definition);
    other.levels[0].target.amount = 6;
    EXPECT_NE(other, definition);
    other = definition;
    other.weights.bone = 0.0f;
    EXPECT_NE(other, definition) << "a weight of 0 is not the same as none";
}

TEST(LodDefinition, strategiesHaveOgresNames)
{
    EXPECT_STREQ(ogreName(LodStrategy::DistanceSphere), "distance_sphere");
    EXPECT_STREQ(ogreName(LodStrategy::DistanceBox), "distance_box");
    EXPECT_STREQ(ogreName(LodStrategy::PixelCount), "pixel_count");
    EXPECT_STREQ(ogreName(LodStrategy::ScreenRatioPixelCount), "screen_ratio_pixel_count");
}

} // namespace lodsmith
