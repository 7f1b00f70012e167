#include <lodsmith/loddef/LoddefXml.h>

#include <gmock/gmock.h>

namespace lodsmith {

namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

std::vector<std::string> described(const std::vector<Error>& errors)
{
    std::vector<std::string> texts;
    for (const Error& error : errors)
        texts.push_back(describe(error));
    return texts;
}

/// A text and the one error it has to give.
struct Wrong {
    const char* text;
    const char* place; ///< "line: "
    const char* found;
    const char* allowed;
};

void expectErrors(const std::vector<Wrong>& cases)
{
    for (const Wrong& wrong : cases) {
        const LoddefReading reading = parseLoddef(wrong.text, "a.loddef");
        EXPECT_FALSE(reading.ok()) << wrong.text;
        EXPECT_THAT(described(reading.errors), ElementsAre(AllOf(StartsWith("a.loddef:" + std::string(wrong.place)),
                                                                 HasSubstr(wrong.found), HasSubstr(wrong.allowed))))
            << wrong.text;
    }
}

} // namespace

TEST(LoddefErrors, unknownWordsAreNamed)
{
    expectErrors({
        {"<lod>\n<automatic enabled='yes'/></lod>", "2: ", "enabled is 'yes'", "true, false, 1 and 0"},
        {"<lod><automatic\n enabled=''/></lod>", "2: ", "enabled is ''", "true"},
        {"<lod><manual>\n\n<type>manual</type></manual></lod>", "3: ", "<type> is 'manual'", "automatic and user"},
        {"<lod><manual><type/></manual></lod>", "1: ", "<type> is ''", "automatic and user"},
        {"<lod><manual>\n<strategy>Distance</strategy></manual></lod>", "2: ", "<strategy> is 'Distance'",
         "distance, pixelcount, distance_sphere, distance_box, pixel_count and screen_ratio_pixel_count"},
        {"<lod><manual>\n<metric>fast</metric></manual></lod>", "2: ", "'fast'", "quadric and curvature"},
        {"<lod><manual>\n<borders>true</borders></manual></lod>", "2: ", "'true'", "locked and free"},
        {"<lod><manual><level distance='1'>\n<method>halve</method><value>50</value></level></manual></lod>",
         "2: ", "<method> is 'halve'", "proportional, constant, collapsecost, triangles and deviation"},
    });
}

TEST(LoddefErrors, malformedNumbersAreNamed)
{
    for (const std::string text : {"5x", "", "0,5", "1 2", "nan", "inf", "-nan", "0x10", "1e400", "--1", "+-1", "."}) {
        const LoddefReading value = parseLoddef(
            "<lod><manual><level distance='1'>\n<value>" + text + "</value></level></manual></lod>", "a.loddef");
        EXPECT_THAT(described(value.errors), ElementsAre(AllOf(StartsWith("a.loddef:2: <value> is '" + text + "'"),
                                                               HasSubstr("allowed: a number"))));
        const LoddefReading distance =
            parseLoddef("<lod><manual>\n<level distance='" + text + "'/></manual></lod>", "a.loddef");
        EXPECT_THAT(described(distance.errors), ElementsAre(StartsWith("a.loddef:2: distance is '" + text + "'")));
    }
}

TEST(LoddefErrors, amountsHaveTheRangeOfTheirMethod)
{
    expectErrors({
        {"<lod><manual><level distance='1'>\n<value>1.5</value></level></manual></lod>", "2: ", "'1.5'", "0 to 1"},
        {"<lod><manual><level distance='1'>\n<value>-0.5</value></level></manual></lod>", "2: ", "'-0.5'", "0 to 1"},
        {"<lod><manual><level distance='1'><method>constant</method>\n<value>-1</value></level></manual></lod>",
         "2: ", "constant is '-1'", "0 to 4294967295"},
        {"<lod><manual><level distance='1'><method>triangles</method>\n<value>1.5</value></level></manual></lod>",
         "2: ", "'1.5'", "a whole number"},
        {"<lod><manual><level distance='1'><method>deviation</method>\n<value>-1</value></level></manual></lod>",
         "2: ", "'-1'", "world units"},
        {"<lod><manual><level distance='1'><method>collapsecost</method>\n<value>-1</value></level></manual></lod>",
         "2: ", "'-1'", "world units"},
        {"<lod><manual>\n<level distance='1'><method>triangles</method></level></manual></lod>", "2: ", "no <value>",
         "triangles"},
        {"<lod><manual>\n<level distance='1'><method>deviation</method></level></manual></lod>", "2: ", "no <value>",
         "deviation"},
    });
}

TEST(LoddefErrors, everyLevelHasItsOwnDistance)
{
    expectErrors({
        {"<lod><manual>\n<level/></manual></lod>", "2: ", "<level> has no attribute 'distance'", "allowed: one"},
        {"<lod><manual>\n<level distance='0'/></manual></lod>", "2: ", "'0'", "above 0 and at most 1e18"},
        {"<lod><manual>\n<level\ndistance='-5'/></manual></lod>", "3: ", "'-5'", "above 0 and at most 1e18"},
        {"<lod><manual>\n<level distance='2e18'/></manual></lod>", "2: ", "'", "above 0 and at most 1e18"},
        {"<lod><manual>\n<level distance='20'/>\n<level distance='30'/>\n<level distance='2e1'/></manual></lod>",
         "4: ", "that of the level in line 2 already", "each distance once"},
        {"<lod><manual>\n<level distance='20'/>\n<level distance='20.0000001'/></manual></lod>",
         "3: ", "that of the level in line 2 already", "each distance once"},
    });
}

TEST(LoddefErrors, handMadeLevelsNameAMeshAndNothingElse)
{
    expectErrors({
        {"<lod><manual><level distance='1'>\n<meshName/></level></manual></lod>", "2: ", "the mesh name is ''",
         "the name of a mesh"},
        {"<lod><manual><type>user</type><level distance='1'>\n<meshName>  </meshName></level></manual></lod>",
         "2: ", "the mesh name is ''", "the name of a mesh"},
        {"<lod><manual><level distance='1'>\n<meshName>a\nb</meshName></level></manual></lod>", "2: ", "'a\nb'",
         "without control characters"},
        {"<lod><manual><type>user</type>\n<level distance='1'/></manual></lod>", "2: ", "no mesh name", "type user"},
        {"<lod><manual><type>user</type><level distance='1'>\n<meshName>a</meshName>\n<method>constant</method></level>"
         "</manual></lod>",
         "3: ", "<method> stands beside <meshName>", "<meshName> alone"},
        {"<lod><manual><level distance='1'>\n<meshName>a</meshName>\n<value>1</value></level></manual></lod>",
         "3: ", "<value> stands beside <meshName>", "<meshName> alone"},
    });
    const LoddefReading reduced =
        parseLoddef("<lod><manual><type>user</type>\n<level "
                    "distance='1'>\n<method>constant</method>\n<value>5</value></level></manual></lod>",
                    "a.loddef");
    EXPECT_THAT(described(reduced.errors),
                ElementsAre(StartsWith("a.loddef:2: the level has no mesh name"),
                            StartsWith("a.loddef:3: <method> is in a level of the type user"),
                            StartsWith("a.loddef:4: <value> is in a level of the type user")));
}

TEST(LoddefErrors, weightsAndImportancesAreInRange)
{
    expectErrors({
        {"<lod><manual><weights normal='1'\nuv='-1'/></manual></lod>", "2: ", "the weight uv is '-1'", "0 or more"},
        {"<lod><manual><weights\nbone='much'/></manual></lod>", "2: ", "bone is 'much'", "0 or more"},
        {"<lod><manual><metric>curvature</metric>\n<weights uv='1'/></manual></lod>", "2: ", "'curvature'",
         "the metric quadric"},
        {"<lod><manual>\n<subMesh importance='1'/></manual></lod>", "2: ", "no attribute 'index'", "allowed: one"},
        {"<lod><manual>\n<subMesh index='1'/></manual></lod>", "2: ", "no attribute 'importance'", "allowed: one"},
        {"<lod><manual>\n<subMesh index='-1' importance='1'/></manual></lod>", "2: ", "index is '-1'", "0 to 65535"},
        {"<lod><manual>\n<subMesh index='65536' importance='1'/></manual></lod>", "2: ", "'65536'", "0 to 65535"},
        {"<lod><manual>\n<subMesh index='1.5' importance='1'/></manual></lod>", "2: ", "'1.5'", "whole number"},
        {"<lod><manual>\n<subMesh index='1' importance='2'/></manual></lod>", "2: ", "submesh 1 is '2'", "0 to 1"},
        {"<lod><manual>\n<subMesh index='1' importance='1'/>\n<subMesh index='1' importance='1'/></manual></lod>",
         "3: ", "submesh 1 has an importance already", "one each"},
    });
}

TEST(LoddefErrors, nothingIsSaidTwice)
{
    expectErrors({
        {"<lod>\n<automatic/>\n<automatic/></lod>", "3: ", "<automatic> is there already, in line 2", "once"},
        {"<lod>\n<manual/>\n<manual/></lod>", "3: ", "in line 2", "once"},
        {"<lod><manual>\n<type>user</type>\n<type>user</type></manual></lod>", "3: ", "in line 2", "once"},
        {"<lod><manual><level distance='1'>\n<value>0</value>\n<value>0</value></level></manual></lod>",
         "3: ", "in line 2", "once"},
        {"<lod><manual><level distance='1'\ndistance='2'/></manual></lod>",
         "2: ", "an attribute is malformed or given twice", "once"},
    });
}

TEST(LoddefErrors, thereIsOneLodAndNoStrayText)
{
    expectErrors({
        {"", "1: ", "nothing in it", "<lod/>"},
        {" \n ", "1: ", "nothing in it", "<lod/>"},
        {"<!-- no element -->", "1: ", "the outermost element is ''", "lod"},
        {"\n<mesh/>", "2: ", "the outermost element is 'mesh'", "lod"},
        {"<lod/>\n<lod/>", "2: ", "beside <lod> is 'lod'", "comments"},
        {"<lod/>\n\nmore", "3: ", "stands outside of all", "text in elements"},
        {"<lod>\n<manual>8000</manual></lod>", "2: ", "the text in <manual> is '8000'", "elements"},
        {"<lod>\n<automatic>false</automatic></lod>", "2: ", "the text in <automatic> is 'false'", "elements"},
    });
}

TEST(LoddefErrors, brokenXmlHasItsLine)
{
    expectErrors({
        {"<lod>\n<manual>\n</lod>", "2: ", "not closed", "</name>"},
        {"<lod>\n<automatic enabled=false/></lod>", "2: ", "attribute is malformed", "allowed: name=\"value\""},
        {"<lod>\n<!-- no end", "2: ", "comment does not end", "allowed: <!--"},
        {"lod", "1: ", "", ""},
    });
    EXPECT_FALSE(parseLoddef("<lod>\n<manual>", "a.loddef").ok());
}

TEST(LoddefErrors, versionsAreKnownOrRefused)
{
    expectErrors({
        {"<lod\nversion='one'/>", "2: ", "version is 'one'", "allowed: 1"},
        {"<lod version='0'/>", "1: ", "version is '0'", "allowed: 1"},
        {"<lod version='-1'/>", "1: ", "version is '-1'", "allowed: 1"},
        {"<lod version=''/>", "1: ", "version is ''", "allowed: 1"},
    });
    const LoddefReading newer =
        parseLoddef("<lod version='2'><manual><type>cluster</type><level/></manual></lod>", "a.loddef");
    ASSERT_EQ(newer.errors.size(), 1u) << "what a newer grammar means is not for this one to say";
    EXPECT_EQ(newer.errors[0].code, ErrorCode::Unsupported);
    EXPECT_THAT(newer.errors[0].message, AllOf(HasSubstr("version is '2'"), HasSubstr("newer library")));
}

TEST(LoddefErrors, allOfAFileAreReportedInOrder)
{
    const LoddefReading reading = parseLoddef(R"(<lod>
<automatic enabled="maybe"/>
<manual>
<type>auto</type>
<level distance="x"><method>constant</method><value>y</value></level>
<level><value>2</value></level>
<level distance="-1"/>
<level distance="9"><value>3</value></level>
<level distance="9"/>
</manual>
</lod>)",
                                              "a.loddef");
    std::vector<int> lines;
    for (const Error& error : reading.errors)
        lines.push_back(error.line);
    EXPECT_THAT(lines, ElementsAre(2, 4, 5, 5, 6, 7, 8, 9));
}

TEST(LoddefErrors, longTextsAreCut)
{
    const LoddefReading reading =
        parseLoddef("<lod><manual><type>" + std::string(100000, 'x') + "</type></manual></lod>", "a.loddef");
    ASSERT_EQ(reading.errors.size(), 1u);
    EXPECT_LT(reading.errors[0].message.size(), 200u);
}

} // namespace lodsmith
