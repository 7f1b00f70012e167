#include <lodsmith/loddef/LoddefXml.h>

#include <gmock/gmock.h>

namespace lodsmith {

namespace {

using Kind = LevelTarget::Kind;
using testing::HasSubstr;
using testing::IsEmpty;

/// The definition of a text that has to be without errors and warnings.
LodDefinition clean(const std::string& text)
{
    LoddefReading reading = parseLoddef(text, "test.loddef");
    for (const Error& error : reading.errors)
        ADD_FAILURE() << describe(error);
    for (const Error& warning : reading.warnings)
        ADD_FAILURE() << describe(warning);
    return reading.definition.value_or(LodDefinition());
}

LodDefinition manual(const std::string& content)
{
    return clean("<lod><automatic enabled=\"false\"/><manual>" + content + "</manual></lod>");
}

LodLevelDefinition level(const std::string& content)
{
    const LodDefinition definition = manual("<level distance=\"20\">" + content + "</level>");
    EXPECT_EQ(definition.levels.size(), 1u);
    return definition.levels.empty() ? LodLevelDefinition() : definition.levels[0];
}

LevelTarget target(const std::string& method, const std::string& value)
{
    return level("<method>" + method + "</method><value>" + value + "</value>").target;
}

} // namespace

TEST(OriginalGrammar, theExampleMeansWhatItAlwaysMeant)
{
    const LodDefinition definition = clean(R"(<lod>
  <automatic enabled="false"/>
  <manual>
    <type>automatic</type>                 <!-- automatic | user -->
    <strategy>pixelcount</strategy>        <!-- distance | pixelcount -->
    <level distance="8000000">             <!-- under pixelcount this attribute carries pixels -->
      <method>constant</method>            <!-- proportional | constant | collapsecost -->
      <value>50</value>
    </level>
  </manual>
</lod>
)");
    EXPECT_FALSE(definition.automatic);
    EXPECT_EQ(definition.type, LodDefinitionType::Automatic);
    EXPECT_EQ(definition.strategy, LodStrategy::PixelCount);
    ASSERT_EQ(definition.levels.size(), 1u);
    EXPECT_EQ(definition.levels[0].value, 8000000.0f);
    EXPECT_EQ(definition.levels[0].target.kind, Kind::Constant);
    EXPECT_EQ(definition.levels[0].target.amount, 50.0);
    EXPECT_FALSE(definition.levels[0].isManual());
}

TEST(OriginalGrammar, handMadeLevelsNameMeshes)
{
    const LodDefinition definition = manual(R"(<type>user</type>
        <level distance="100"><meshName>path/to/other.mesh</meshName></level>
        <level distance="50"><meshName> near.mesh </meshName></level>)");
    EXPECT_EQ(definition.type, LodDefinitionType::User);
    ASSERT_EQ(definition.levels.size(), 2u);
    EXPECT_EQ(definition.levels[0].meshName, "path/to/other.mesh");
    EXPECT_EQ(definition.levels[1].meshName, "near.mesh");
    EXPECT_EQ(definition.levels[1].value, 50.0f);
}

TEST(OriginalGrammar, whatIsAbsentTakesItsDefault)
{
    for (const std::string text : {"<lod/>", "<lod></lod>", "<lod><automatic/></lod>", "<lod><manual/></lod>",
                                   "<?xml version=\"1.0\" encoding=\"UTF-8\"?><lod/>", "\xef\xbb\xbf<lod/>\r\n"}) {
        EXPECT_EQ(clean(text), LodDefinition()) << text;
    }
    EXPECT_EQ(level("").target.kind, Kind::Proportional);
    EXPECT_EQ(level("").target.amount, 0.5);
    EXPECT_EQ(level("<method>proportional</method>").target.amount, 0.5);
    EXPECT_EQ(level("<value>0.25</value>").target.kind, Kind::Proportional);
    EXPECT_FALSE(simplifyOptions(clean("<lod/>")).lockBorders);
}

TEST(OriginalGrammar, automaticIsOnOrOff)
{
    for (const std::string word : {"true", "1", " true "})
        EXPECT_TRUE(clean("<lod><automatic enabled=\"" + word + "\"/></lod>").automatic);
    for (const std::string word : {"false", "0"})
        EXPECT_FALSE(clean("<lod><automatic enabled='" + word + "'/></lod>").automatic);
}

TEST(OriginalGrammar, strategiesAreTheTwoWordsAndOgresFourNames)
{
    const std::pair<std::string, LodStrategy> words[] = {
        {"distance", LodStrategy::DistanceSphere},
        {"pixelcount", LodStrategy::PixelCount},
        {"distance_sphere", LodStrategy::DistanceSphere},
        {"distance_box", LodStrategy::DistanceBox},
        {"pixel_count", LodStrategy::PixelCount},
        {"screen_ratio_pixel_count", LodStrategy::ScreenRatioPixelCount},
    };
    for (const auto& [word, strategy] : words)
        EXPECT_EQ(manual("<strategy>" + word + "</strategy>").strategy, strategy) << word;
}

TEST(OriginalGrammar, methodsHaveTheirAmounts)
{
    EXPECT_EQ(target("proportional", "1").amount, 1.0);
    EXPECT_EQ(target("constant", "0").kind, Kind::Constant);
    EXPECT_EQ(target("constant", "123.456").amount, 123.456) << "a slider may have written it";
    EXPECT_EQ(target("collapsecost", "0.0325").kind, Kind::CollapseCost);
    EXPECT_EQ(target("collapsecost", "0.0325").amount, 0.0325);
}

TEST(OriginalGrammar, numbersAreReadInEveryFormThatStreamsWrite)
{
    EXPECT_EQ(target("constant", "8e+06").amount, 8e6);
    EXPECT_EQ(target("constant", " 8E6\n").amount, 8e6);
    EXPECT_EQ(target("collapsecost", "+.5").amount, 0.5);
    EXPECT_EQ(target("collapsecost", "5.").amount, 5.0);
    EXPECT_EQ(target("collapsecost", "0.1").amount, 0.1);
    EXPECT_EQ(manual("<level distance='1.17549435e-38'/>").levels[0].value, 1.17549435e-38f);
}

TEST(OriginalGrammar, amountsWithoutAMeaningWarn)
{
    const LoddefReading reading =
        parseLoddef("<lod><manual>\n<level distance='1'><method>constant</method></level></manual></lod>", "a.loddef");
    ASSERT_TRUE(reading.ok());
    EXPECT_EQ(reading.definition->levels[0].target.amount, 0.5);
    ASSERT_EQ(reading.warnings.size(), 1u);
    EXPECT_EQ(describe(reading.warnings[0]).substr(0, 12), "a.loddef:2: ");
    EXPECT_THAT(reading.warnings[0].message, HasSubstr("method constant"));
}

TEST(OriginalGrammar, orderCommentsAndSectionsDoNotMatter)
{
    const LodDefinition definition = clean(R"(<!-- before --><lod><manual><level distance="2">
        <value><!-- half -->0.<![CDATA[25]]></value><method>proportional</method></level>
        <strategy>pixel&#99;ount</strategy></manual><automatic enabled="false"/></lod><!-- behind -->)");
    EXPECT_FALSE(definition.automatic);
    EXPECT_EQ(definition.strategy, LodStrategy::PixelCount);
    EXPECT_EQ(definition.levels.at(0).target.amount, 0.25);
}

TEST(OriginalGrammar, levelsStayInTheOrderOfTheFile)
{
    const LodDefinition definition = manual("<level distance='3'/><level distance='1'/><level distance='2'/>");
    ASSERT_EQ(definition.levels.size(), 3u);
    EXPECT_EQ(definition.levels[0].value, 3.0f);
    EXPECT_EQ(definition.levels[1].value, 1.0f);
    EXPECT_EQ(definition.levels[2].value, 2.0f);
}

TEST(Extensions, methodsForTrianglesAndDeviation)
{
    EXPECT_EQ(target("triangles", "400").kind, Kind::Triangles);
    EXPECT_EQ(target("triangles", "400").amount, 400.0);
    EXPECT_EQ(target("deviation", "0.01").kind, Kind::Deviation);
    EXPECT_EQ(target("deviation", "0.01").amount, 0.01);
}

TEST(Extensions, metricAndWeightsAreGivenOrAbsent)
{
    EXPECT_FALSE(manual("").metric.has_value());
    EXPECT_FALSE(manual("").weights.any());
    EXPECT_FALSE(manual("<weights/>").weights.any());
    EXPECT_EQ(manual("<metric>curvature</metric>").metric, Metric::Curvature);
    EXPECT_EQ(manual("<metric>quadric</metric>").metric, Metric::Quadric);
    const GivenAttributeWeights weights = manual("<weights normal='0.5' bone='0'/>").weights;
    EXPECT_EQ(weights.normal, 0.5f);
    EXPECT_EQ(weights.bone, 0.0f);
    EXPECT_FALSE(weights.uv.has_value());
    EXPECT_FALSE(weights.colour.has_value());
    EXPECT_EQ(manual("<weights colour='1' uv='2'/>").weights.colour, 1.0f);
}

TEST(Extensions, bordersAreLockedOrFree)
{
    EXPECT_TRUE(manual("<borders>locked</borders>").lockBorders);
    EXPECT_FALSE(manual("<borders>free</borders>").lockBorders);
}

TEST(Extensions, subMeshesHaveAnImportance)
{
    const LodDefinition definition =
        manual("<subMesh index='7' importance='1'/><subMesh index='0' importance='0.25'/>");
    ASSERT_EQ(definition.subMeshes.size(), 2u);
    EXPECT_EQ(definition.subMeshes[0].subMesh, 7);
    EXPECT_EQ(definition.subMeshes[0].importance, 1.0f);
    EXPECT_EQ(definition.subMeshes[1].importance, 0.25f);
}

TEST(Extensions, handMadeLevelsStandAmongReducedOnes)
{
    const LodDefinition definition =
        manual("<level distance='1'/><level distance='2'><meshName>a.mesh</meshName></level>");
    EXPECT_FALSE(definition.levels.at(0).isManual());
    EXPECT_TRUE(definition.levels.at(1).isManual());
}

TEST(Extensions, theVersionIsOptional)
{
    EXPECT_EQ(clean("<lod version='1'/>"), LodDefinition());
    EXPECT_EQ(clean("<lod version=' 1 '/>"), LodDefinition());
}

TEST(Extensions, whatEditorsNeedIsNoUnknownAttribute)
{
    clean(R"(<lod version="1" xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xml:lang="en"
        xsi:noNamespaceSchemaLocation="loddef.xsd"/>)");
}

} // namespace lodsmith
