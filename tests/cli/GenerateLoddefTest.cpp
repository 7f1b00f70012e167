#include "CommandLine.h"
#include "OgreSession.h"
#include "SampleFiles.h"

#include <OgreLodStrategy.h>

#include <gmock/gmock.h>

namespace fs = std::filesystem;

namespace lodsmith::cli {

namespace {

using lodsmith::test::contentOf;
using lodsmith::test::TestDirectory;
using nlohmann::json;
using test::Outcome;
using test::runLodsmith;
using test::torusMesh;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

constexpr unsigned kSegments = 16;

std::string definition(const std::string& content)
{
    return "<lod>\n<automatic enabled='false'/>\n<manual>\n" + content + "\n</manual></lod>";
}

const std::string kHalf = definition("<level distance='30'><value>0.5</value></level>");

class GenerateLoddefTest : public testing::Test {
protected:
    std::string in(const std::string& name) const { return (mDirectory / name).string(); }
    std::string torus(const std::string& name) const { return mDirectory.write(name, torusMesh(kSegments)); }

    static json onlyRecord(const Outcome& outcome)
    {
        const std::vector<json> records = outcome.records();
        EXPECT_EQ(records.size(), 1u);
        return records.empty() ? json() : records[0];
    }

    TestDirectory mDirectory;
};

} // namespace

TEST_F(GenerateLoddefTest, aDefinitionBesideTheMeshIsUsedAndNamed)
{
    const std::string mesh = torus("a.b.mesh"), file = mDirectory.write("a.b.loddef", kHalf);
    const Outcome outcome = runLodsmith({"generate", mesh, "-o", in("out/"), "--json"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const json record = onlyRecord(outcome);
    EXPECT_EQ(record["loddef"], file);
    EXPECT_EQ(record["strategy"], "distance_sphere");
    EXPECT_EQ(record["metric"], "quadric");
    ASSERT_EQ(record["levels"].size(), 2u);
    EXPECT_EQ(record["levels"][1]["value"], 30);
    EXPECT_EQ(record["levels"][1]["vertices"], kSegments * kSegments / 2);
    OgreSession session;
    EXPECT_EQ(session.load(in("out/a.b.mesh")).value()->getLodLevel(1).userValue, 30.0f);
    EXPECT_FALSE(fs::exists(in("out/a.b.loddef"))) << "the output has its levels already";

    const Outcome people = runLodsmith({"generate", mesh, "-o", in("again.mesh")});
    EXPECT_THAT(people.out, HasSubstr("\nlevels as " + file + " says\n"));
}

TEST_F(GenerateLoddefTest, withoutOneNothingIsSaidAboutIt)
{
    mDirectory.write("b.loddef", kHalf);
    const Outcome outcome = runLodsmith({"generate", torus("a.mesh"), "-o", in("b.mesh"), "--json"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_TRUE(onlyRecord(outcome)["loddef"].is_null());
    EXPECT_EQ(onlyRecord(outcome)["strategy"], "pixel_count");
    const Outcome people = runLodsmith({"generate", in("a.mesh"), "-o", in("c.mesh")});
    EXPECT_THAT(people.out, Not(HasSubstr("loddef")));
}

TEST_F(GenerateLoddefTest, eachFileOfADirectoryHasItsOwn)
{
    torus("in/a.mesh");
    torus("in/deep/b.mesh");
    mDirectory.write("in/deep/b.loddef", kHalf);
    const Outcome outcome = runLodsmith({"generate", in("in"), "-o", in("out"), "--json"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    ASSERT_EQ(outcome.records().size(), 2u);
    EXPECT_TRUE(outcome.records()[0]["loddef"].is_null());
    EXPECT_EQ(outcome.records()[1]["loddef"], in("in/deep/b.loddef"));
}

TEST_F(GenerateLoddefTest, noLoddefPassesOverIt)
{
    const std::string mesh = torus("a.mesh");
    mDirectory.write("a.loddef", "<lod");
    const Outcome outcome = runLodsmith({"generate", mesh, "-o", in("b.mesh"), "--no-loddef", "--json"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_TRUE(onlyRecord(outcome)["loddef"].is_null());
    EXPECT_TRUE(onlyRecord(outcome)["notes"].empty());
    EXPECT_EQ(onlyRecord(outcome)["levels"].size(), 5u);
}

TEST_F(GenerateLoddefTest, levelsOfTheCommandLineGoFirstWhichIsNoted)
{
    const std::string mesh = torus("a.mesh"), file = mDirectory.write("a.loddef", "<lod");
    const std::vector<std::vector<std::string>> options{
        {"--levels", "7:proportional:0.25"}, {"--metric", "quadric"}, {"--lock-borders"}, {"--lock-seams"}};
    for (const std::vector<std::string>& option : options) {
        std::vector<std::string> line{"generate", mesh, "-o", in("b.mesh"), "--force", "--json"};
        line.insert(line.end(), option.begin(), option.end());
        const Outcome outcome = runLodsmith(line);
        ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
        EXPECT_TRUE(onlyRecord(outcome)["loddef"].is_null());
        EXPECT_THAT(onlyRecord(outcome)["notes"].dump(), HasSubstr(file + " is not used"));
    }
}

TEST_F(GenerateLoddefTest, aBrokenOneIsAnErrorOfItsMeshAlone)
{
    torus("in/a.mesh");
    torus("in/b.mesh");
    const std::string file =
        mDirectory.write("in/a.loddef", "<lod>\n<automatic enabled='no'/>\n<manual><level/></manual></lod>");
    const Outcome outcome = runLodsmith({"generate", in("in"), "-o", in("out"), "--json"});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_THAT(outcome.err, HasSubstr("lodsmith: " + file + ":2: enabled is 'no'"));
    EXPECT_THAT(outcome.err, HasSubstr("(and 1 more; lodsmith validate lists them)"));
    ASSERT_EQ(outcome.records().size(), 2u);
    EXPECT_THAT(outcome.records()[0]["error"].get<std::string>(), HasSubstr(file + ":2: "));
    EXPECT_TRUE(outcome.records()[0]["loddef"].is_null());
    EXPECT_TRUE(outcome.records()[1]["error"].is_null());
    EXPECT_THAT(mDirectory.files(),
                ElementsAre("in/a.loddef", "in/a.mesh", "in/b.mesh", "out/.lodsmith/b.mesh.json", "out/b.mesh"));
}

TEST_F(GenerateLoddefTest, oneForAll)
{
    torus("in/a.mesh");
    torus("in/b.mesh");
    mDirectory.write("in/a.loddef", "<lod");
    const std::string far = mDirectory.write("far.loddef", kHalf);
    const Outcome outcome = runLodsmith({"generate", in("in"), "-o", in("out"), "--loddef", far, "--json"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    for (const json& record : outcome.records()) {
        EXPECT_EQ(record["loddef"], far);
        EXPECT_EQ(record["levels"].size(), 2u);
    }
}

TEST_F(GenerateLoddefTest, oneThatIsMissingIsAnError)
{
    const Outcome outcome =
        runLodsmith({"generate", torus("a.mesh"), "-o", in("b.mesh"), "--loddef", in("gone.loddef")});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_THAT(outcome.err, HasSubstr("lodsmith: " + in("gone.loddef") + ": no such file"));
    fs::create_symlink("nowhere", mDirectory / "a.loddef");
    EXPECT_EQ(runLodsmith({"generate", in("a.mesh"), "-o", in("b.mesh")}).exitCode, 1);
    EXPECT_FALSE(fs::exists(in("b.mesh")));
}

TEST_F(GenerateLoddefTest, strategyMetricAndLocksAreThoseOfTheDefinition)
{
    mDirectory.write("a.loddef",
                     definition("<strategy>screen_ratio_pixel_count</strategy><subMesh index='0' importance='1'/>"
                                "<level distance='0.5'><method>collapsecost</method><value>100</value></level>"
                                "<level distance='0.25'/>"));
    const Outcome outcome = runLodsmith({"generate", torus("a.mesh"), "-o", in("b.mesh"), "--json"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const json record = onlyRecord(outcome);
    EXPECT_EQ(record["strategy"], "screen_ratio_pixel_count");
    EXPECT_EQ(record["metric"], "curvature");
    EXPECT_EQ(record["levels"][1]["skipped"], true) << "its only submesh is locked";
    EXPECT_EQ(record["levels"][2]["stop"], "locked");
}

TEST_F(GenerateLoddefTest, automaticAndNoLevelsAreTwoThings)
{
    const std::string mesh = torus("a.mesh");
    mDirectory.write("a.loddef", "<lod><manual><level distance='5'/></manual></lod>");
    const json automatic = onlyRecord(runLodsmith({"generate", mesh, "-o", in("b.mesh"), "--json"}));
    EXPECT_EQ(automatic["levels"].size(), 5u);
    EXPECT_EQ(automatic["loddef"], in("a.loddef"));
    mDirectory.write("a.loddef", definition(""));
    const Outcome none = runLodsmith({"generate", mesh, "-o", in("c.mesh"), "--json"});
    ASSERT_EQ(none.exitCode, 0) << none.err;
    EXPECT_EQ(onlyRecord(none)["levels"].size(), 1u);
    OgreSession session;
    EXPECT_EQ(session.load(in("c.mesh")).value()->getNumLodLevels(), 1);
}

TEST_F(GenerateLoddefTest, warningsAreNotes)
{
    mDirectory.write("a.loddef", "<lod>\n<history/></lod>");
    const Outcome outcome = runLodsmith({"generate", torus("a.mesh"), "-o", in("b.mesh")});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("note: " + in("a.loddef") + ":2: <history> in <lod> is unknown"));
}

TEST_F(GenerateLoddefTest, handMadeLevelsGoAlong)
{
    torus("in/a.mesh");
    const std::string box = mDirectory.write("in/lods/box.mesh", torusMesh(8));
    mDirectory.write("in/a.loddef",
                     definition("<type>user</type><level distance='90'><meshName>lods/box.mesh</meshName>"
                                "</level><level distance='40'><meshName>lods/box.mesh</meshName></level>"));
    const Outcome outcome = runLodsmith({"generate", in("in"), "-o", in("out"), "--json"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const json record = onlyRecord(outcome);
    ASSERT_EQ(record["levels"].size(), 3u);
    EXPECT_EQ(record["levels"][1]["value"], 40);
    EXPECT_EQ(record["levels"][1]["manual"], "box.mesh");
    EXPECT_EQ(record["levels"][2]["triangles"], test::torusTriangles(8));
    EXPECT_EQ(contentOf(in("out/box.mesh")), contentOf(box));
    EXPECT_FALSE(fs::exists(in("out/lods")));
    OgreSession session;
    EXPECT_EQ(session.load(in("out/a.mesh")).value()->getLodLevel(2).manualName, "box.mesh");
}

TEST_F(GenerateLoddefTest, aHandMadeLevelThatCannotBeHadIsAnError)
{
    const std::string mesh = torus("a.mesh");
    const auto errorWith = [&](const std::string& name) {
        mDirectory.write("a.loddef", definition("<level distance='50'><meshName>" + name + "</meshName></level>"));
        const Outcome outcome = runLodsmith({"generate", mesh, "-o", in("out/")});
        EXPECT_EQ(outcome.exitCode, 1) << name;
        EXPECT_FALSE(fs::exists(in("out"))) << name;
        return outcome.err;
    };
    EXPECT_THAT(errorWith("gone.mesh"), AllOf(HasSubstr(in("a.loddef") + ": "), HasSubstr("'gone.mesh'")));
    EXPECT_THAT(errorWith("../gone.mesh"), HasSubstr("not below the directory"));
    EXPECT_THAT(errorWith("a.mesh"), HasSubstr("file name of its own"));
    mDirectory.write("broken.mesh", "no mesh");
    EXPECT_THAT(errorWith("broken.mesh"), HasSubstr(in("broken.mesh")));
    ASSERT_EQ(runLodsmith({"generate", mesh, "-o", in("nested.mesh"), "--levels", "5:proportional:0.5"}).exitCode, 0);
    EXPECT_THAT(errorWith("nested.mesh"), HasSubstr("levels of its own"));
}

TEST_F(GenerateLoddefTest, twoHandMadeLevelsOfOneFileNameAreRefused)
{
    torus("a.mesh");
    mDirectory.write("x/box.mesh", torusMesh(8));
    mDirectory.write("y/box.mesh", torusMesh(8));
    mDirectory.write("a.loddef", definition("<level distance='5'><meshName>x/box.mesh</meshName></level>"
                                            "<level distance='9'><meshName>y/box.mesh</meshName></level>"));
    const Outcome outcome = runLodsmith({"generate", in("a.mesh"), "-o", in("out/")});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_THAT(outcome.err, HasSubstr("file name of its own"));
}

TEST_F(GenerateLoddefTest, aSubMeshThatIsNotThereIsAnError)
{
    mDirectory.write("a.loddef", definition("<subMesh index='3' importance='0.5'/><level distance='5'/>"));
    const Outcome outcome = runLodsmith({"generate", torus("a.mesh"), "-o", in("b.mesh")});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_THAT(outcome.err, HasSubstr(in("a.loddef") + ": there is no submesh 3"));
}

} // namespace lodsmith::cli
