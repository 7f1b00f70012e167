#include <lodsmith/loddef/LoddefXml.h>

#include <gmock/gmock.h>

#include <algorithm>

namespace lodsmith {

namespace {

using Kind = LevelTarget::Kind;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

LodDefinition parsed(const std::string& text)
{
    const LoddefReading reading = parseLoddef(text, "a.loddef");
    for (const Error& error : reading.errors)
        ADD_FAILURE() << describe(error);
    return reading.definition.value_or(LodDefinition());
}

std::string saved(const LodDefinition& definition)
{
    const Result<std::string> text = loddefText(definition);
    EXPECT_TRUE(text.ok()) << (text ? "" : describe(text.error()));
    return text ? text.value() : "";
}

/// Whether these stand in the text in this order.
void expectInOrder(const std::string& text, const std::vector<std::string>& parts)
{
    std::size_t position = 0;
    for (const std::string& part : parts) {
        const std::size_t found = text.find(part, position);
        if (found == std::string::npos) {
            ADD_FAILURE() << part << " is not in its place in\n" << text;
            return;
        }
        position = found + part.size();
    }
}

constexpr const char* kForeign = R"(<?xml version="1.0" encoding="UTF-8"?>
<!-- of the tree -->
<lod author="anna" xml:lang="en">
    <history><save by="anna"/>at <b>noon</b></history>
    <manual editor="2">
        <strategy note="by eye">pixel_count</strategy>
        <!-- near -->
        <level distance="2e5" locked="yes">
            <value unit="share"> 0.50 </value>
            <icon>a&lt;b</icon>
            <method>proportional</method>
        </level>
        <break/>
        <!-- far -->
        <level distance="1000">
            <tint><![CDATA[<red>]]></tint>
        </level>
        <type>automatic</type>
    </manual>
    <thumbnail/>
</lod>
)";

} // namespace

TEST(LoddefKeep, newFilesAreWrittenInFull)
{
    LodDefinition definition;
    definition.automatic = false;
    definition.levels = {{8000000.0f, {Kind::Constant, 50}, "", ""}, {0.1f, {}, "a&b.mesh", ""}};
    EXPECT_EQ(saved(definition), R"(<lod version="1">
    <automatic enabled="false"/>
    <manual>
        <type>automatic</type>
        <strategy>distance</strategy>
        <level distance="8000000">
            <method>constant</method>
            <value>50</value>
        </level>
        <level distance="0.1">
            <meshName>a&amp;b.mesh</meshName>
        </level>
    </manual>
</lod>
)");
}

TEST(LoddefKeep, extensionsHaveTheirPlace)
{
    LodDefinition definition;
    definition.metric = Metric::Quadric;
    definition.weights.uv = 0.25f;
    definition.lockBorders = true;
    definition.subMeshes = {{3, 1.0f}};
    definition.levels = {{1.0f, {Kind::Deviation, 1e-7}, "", ""}};
    expectInOrder(saved(definition), {"<type>", "<strategy>", "<metric>quadric</metric>", "<weights uv=\"0.25\"/>",
                                      "<borders>locked</borders>", "<subMesh index=\"3\" importance=\"1\"/>", "<level",
                                      "<method>deviation</method>", "<value>1e-07</value>"});
}

TEST(LoddefKeep, unknownElementsAndAttributesWarnWithTheirLine)
{
    const LoddefReading reading = parseLoddef(kForeign, "a.loddef");
    std::vector<std::string> warnings;
    for (const Error& warning : reading.warnings)
        warnings.push_back(describe(warning));
    EXPECT_THAT(warnings, ElementsAre(AllOf(StartsWith("a.loddef:3: "), HasSubstr("'author' of <lod>")),
                                      AllOf(StartsWith("a.loddef:4: "), HasSubstr("<history> in <lod>")),
                                      AllOf(StartsWith("a.loddef:5: "), HasSubstr("'editor' of <manual>")),
                                      AllOf(StartsWith("a.loddef:6: "), HasSubstr("'note' of <strategy>")),
                                      AllOf(StartsWith("a.loddef:8: "), HasSubstr("'locked' of <level>")),
                                      AllOf(StartsWith("a.loddef:9: "), HasSubstr("'unit' of <value>")),
                                      AllOf(StartsWith("a.loddef:10: "), HasSubstr("<icon> in <level>")),
                                      AllOf(StartsWith("a.loddef:13: "), HasSubstr("<break> in <manual>")),
                                      AllOf(StartsWith("a.loddef:16: "), HasSubstr("<tint> in <level>")),
                                      AllOf(StartsWith("a.loddef:20: "), HasSubstr("<thumbnail> in <lod>"))));
}

TEST(LoddefKeep, savingUnchangedKeepsEverythingInItsPlace)
{
    const std::string text = saved(parsed(kForeign));
    expectInOrder(text, {"<?xml version=\"1.0\" encoding=\"UTF-8\"?>",
                         "<!-- of the tree -->",
                         "<lod author=\"anna\" xml:lang=\"en\" version=\"1\">",
                         "<automatic enabled=\"true\"/>",
                         "<history>",
                         "<save by=\"anna\"/>at <b>noon</b>",
                         "<manual editor=\"2\">",
                         "<strategy note=\"by eye\">pixel_count</strategy>",
                         "<!-- near -->",
                         "<level distance=\"2e5\" locked=\"yes\">",
                         "<value unit=\"share\"> 0.50 </value>",
                         "<icon>a&lt;b</icon>",
                         "<method>proportional</method>",
                         "</level>",
                         "<break/>",
                         "<!-- far -->",
                         "<level distance=\"1000\">",
                         "<method>",
                         "<value>0.5</value>",
                         "<tint><![CDATA[<red>]]></tint>",
                         "</level>",
                         "<type>automatic</type>",
                         "</manual>",
                         "<thumbnail/>",
                         "</lod>"});
    EXPECT_EQ(saved(parsed(text)), text);
}

TEST(LoddefKeep, aChangeChangesNothingElse)
{
    LodDefinition definition = parsed(kForeign);
    definition.strategy = LodStrategy::DistanceBox;
    definition.levels[0].value = 7.0f;
    definition.levels[0].target.amount = 0.75;
    const std::string text = saved(definition);
    expectInOrder(text, {"<strategy note=\"by eye\">distance_box</strategy>", "<!-- near -->",
                         "<level distance=\"7\" locked=\"yes\">", "<value unit=\"share\">0.75</value>",
                         "<icon>a&lt;b</icon>", "</level>", "<break/>", "<!-- far -->", "<level distance=\"1000\">"});
    EXPECT_EQ(parsed(text), definition);
}

TEST(LoddefKeep, whatAValueSaysAlreadyStaysAsItWasWritten)
{
    const std::string text =
        "<lod version=\"1\">\n    <automatic enabled=\"0\"/>\n    <manual>\n        <type>automatic</type>\n"
        "        <strategy>distance_sphere</strategy>\n        <level distance=\"1e1\">\n"
        "            <method>constant</method>\n            <value>5.0</value>\n        </level>\n"
        "    </manual>\n</lod>\n";
    EXPECT_EQ(saved(parsed(text)), text);
}

TEST(LoddefKeep, levelsTakeWhatIsTheirsAlong)
{
    LodDefinition definition = parsed(kForeign);
    std::reverse(definition.levels.begin(), definition.levels.end());
    expectInOrder(saved(definition),
                  {"<level distance=\"1000\"", "<tint>", "<level distance=\"2e5\" locked", "<icon>"});

    definition = parsed(kForeign);
    definition.levels.erase(definition.levels.begin());
    const std::string without = saved(definition);
    EXPECT_THAT(without, AllOf(Not(HasSubstr("<icon>")), HasSubstr("<break/>"), HasSubstr("<tint>")));

    definition = parsed(kForeign);
    definition.levels.push_back(definition.levels[0]);
    definition.levels.back().value = 10.0f;
    expectInOrder(saved(definition),
                  {"<level distance=\"2e5\" locked", "<icon>", "<break/>", "<level distance=\"1000\">", "<tint>",
                   "<level distance=\"10\" locked", "<icon>", "</level>", "<type>"});
}

TEST(LoddefKeep, aLevelCanBePastedIntoAnotherDefinition)
{
    LodDefinition target = parsed("<lod><manual><level distance='5'/><level distance='1'/></manual></lod>");
    target.levels.insert(target.levels.begin() + 1, parsed(kForeign).levels[0]);
    expectInOrder(saved(target), {"distance=\"5\"", "distance=\"2e5\" locked=\"yes\"", "<icon>", "distance=\"1\""});
}

TEST(LoddefKeep, newLevelsStandWhereTheDefinitionHasThem)
{
    LodDefinition definition =
        parsed("<lod><manual><!-- a --><level distance='5'/><!-- b --><level distance='1'/></manual></lod>");
    definition.levels.insert(definition.levels.begin(), {9.0f, {}, "", ""});
    definition.levels.insert(definition.levels.begin() + 2, {3.0f, {}, "", ""});
    expectInOrder(saved(definition),
                  {"<!-- a -->", "distance=\"9\"", "distance=\"5\"", "distance=\"3\"", "<!-- b -->", "distance=\"1\""});
}

TEST(LoddefKeep, aLevelBecomesHandMadeAndReducedAgain)
{
    LodDefinition definition = parsed(kForeign);
    definition.levels[0].meshName = "a.mesh";
    std::string text = saved(definition);
    EXPECT_THAT(text, AllOf(HasSubstr("<meshName>a.mesh</meshName>"), HasSubstr("<icon>"), Not(HasSubstr("unit"))));
    definition = parsed(text);
    definition.levels[0].meshName.clear();
    definition.levels[0].target = {Kind::Triangles, 12};
    text = saved(definition);
    EXPECT_THAT(text, AllOf(Not(HasSubstr("meshName")), HasSubstr("<value>12</value>"), HasSubstr("<icon>")));
}

TEST(LoddefKeep, extensionsGoWhenTheyAreNotGivenAnyMore)
{
    LodDefinition definition = parsed("<lod><manual><metric>quadric</metric><weights uv='1' normal='1' shine='1'/>"
                                      "<borders>locked</borders><subMesh index='1' importance='1' name='roof'/>"
                                      "<subMesh index='2' importance='1'/></manual></lod>");
    definition.metric.reset();
    definition.weights = {};
    definition.lockBorders = false;
    definition.subMeshes = {{5, 0.5f}, {1, 0.25f}};
    std::string text = saved(definition);
    EXPECT_THAT(text,
                AllOf(Not(HasSubstr("metric")), HasSubstr("<weights shine=\"1\"/>"), HasSubstr("<borders>free<")));
    expectInOrder(text, {"index=\"5\"", "index=\"1\" importance=\"0.25\" name=\"roof\""});
    EXPECT_THAT(text, Not(HasSubstr("index=\"2\"")));

    definition = parsed("<lod><manual><weights uv='1'/></manual></lod>");
    definition.weights = {};
    EXPECT_THAT(saved(definition), Not(HasSubstr("weights")));
}

TEST(LoddefKeep, aByteOrderMarkStays)
{
    EXPECT_THAT(saved(parsed("\xef\xbb\xbf<lod/>")), StartsWith("\xef\xbb\xbf<lod"));
}

TEST(LoddefKeep, definitionsThatAreNotInOrderAreNotWritten)
{
    LodDefinition definition;
    definition.levels = {{-1.0f, {}, "", ""}};
    const Result<std::string> text = loddefText(definition);
    ASSERT_FALSE(text);
    EXPECT_EQ(text.error().code, ErrorCode::InvalidSetting);
}

TEST(LoddefKeep, originalsThatAreNoneAreRefused)
{
    for (const std::string original :
         {"<lod", "<mesh/>", "<lod version='2'/>", "<lod><manual><type>x</type></manual></lod>"}) {
        LodDefinition definition;
        definition.original = original;
        const Result<std::string> text = loddefText(definition);
        ASSERT_FALSE(text) << original;
        EXPECT_EQ(text.error().code, ErrorCode::BadFile);
    }
    for (const std::string original : {"<level", "<lod/>", "<level>text</level>", "<level><!DOCTYPE x></level>",
                                       "<level><value>1</value><value>2</value></level>"}) {
        LodDefinition definition;
        definition.levels = {{1.0f, {}, "", original}};
        const Result<std::string> text = loddefText(definition);
        ASSERT_FALSE(text) << original;
        EXPECT_EQ(text.error().code, ErrorCode::BadFile);
    }
}

} // namespace lodsmith
