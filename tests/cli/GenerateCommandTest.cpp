#include "../../src/ogre/MeshHeader.h"
#include "CommandLine.h"
#include "OgreSession.h"
#include "SampleFiles.h"

#include <OgreSubMesh.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

namespace fs = std::filesystem;

namespace lodsmith::cli {

namespace {

using lodsmith::test::contentOf;
using lodsmith::test::TestDirectory;
using nlohmann::json;
using test::Outcome;
using test::runLodsmith;
using test::torusMesh;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr unsigned kSegments = 24;
constexpr const char* kHalves = "10:proportional:0.5,20:proportional:0.75";

class GenerateCommandTest : public testing::Test {
protected:
    std::string in(const std::string& name) const { return (mDirectory / name).string(); }
    std::string torus(const std::string& name) const { return mDirectory.write(name, torusMesh(kSegments)); }

    TestDirectory mDirectory;
};

} // namespace

TEST_F(GenerateCommandTest, theRecordHoldsWhatIsPromised)
{
    const Outcome outcome =
        runLodsmith({"generate", torus("a.mesh"), "-o", in("b.mesh"), "--levels", kHalves, "--repeat", "3", "--json"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const std::vector<json> records = outcome.records();
    ASSERT_EQ(records.size(), 1u);
    const json& record = records[0];
    EXPECT_EQ(record["input"], in("a.mesh"));
    EXPECT_EQ(record["output"], in("b.mesh"));
    EXPECT_EQ(record["vertices"], kSegments * kSegments);
    EXPECT_EQ(record["buffer_vertices"], (kSegments + 1) * (kSegments + 1));
    EXPECT_EQ(record["triangles"], test::torusTriangles(kSegments));
    EXPECT_NEAR(record["radius"].get<double>(), 3.0, 1e-5);
    EXPECT_TRUE(record["error"].is_null());
    for (const char* time : {"read_ms", "generate_ms", "generate_min_ms", "order_ms", "foliage_ms", "write_ms"})
        EXPECT_GE(record[time].get<double>(), 0.0) << time;
    EXPECT_LE(record["generate_min_ms"], record["generate_ms"]);
    EXPECT_TRUE(record["peak_kb"].is_number_integer());
}

TEST_F(GenerateCommandTest, theLevelsAreThoseOfTheRecord)
{
    const Outcome outcome =
        runLodsmith({"generate", torus("a.mesh"), "-o", in("b.mesh"), "--levels", kHalves, "--json"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const json levels = outcome.records().at(0)["levels"];
    ASSERT_EQ(levels.size(), 3u);
    EXPECT_TRUE(levels[0]["value"].is_null());
    EXPECT_EQ(levels[1]["vertices"], kSegments * kSegments / 2);
    EXPECT_EQ(levels[2]["vertices"], kSegments * kSegments / 4);
    EXPECT_EQ(levels[1]["stop"], "target_reached");
    EXPECT_GT(levels[2]["deviation"], levels[1]["deviation"]);

    OgreSession session;
    const Ogre::MeshPtr mesh = session.load(in("b.mesh")).value();
    ASSERT_EQ(mesh->getNumLodLevels(), 3);
    for (Ogre::ushort level = 1; level < 3; ++level) {
        EXPECT_EQ(mesh->getLodLevel(level).userValue, 10.0f * level);
        EXPECT_EQ(mesh->getSubMesh(0)->mLodFaceList[level - 1]->indexCount,
                  3 * levels[level]["triangles"].get<std::size_t>());
    }
    EXPECT_EQ(mesh->getSubMesh(0)->getMaterialName(), "Stone");
}

TEST_F(GenerateCommandTest, automaticLevelsNeedNoOptions)
{
    const Outcome outcome = runLodsmith({"generate", torus("a.mesh"), "-o", in("b.mesh"), "--json"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const json record = outcome.records().at(0);
    EXPECT_EQ(record["strategy"], "pixel_count");
    ASSERT_GE(record["levels"].size(), 4u);
    for (std::size_t i = 1; i < record["levels"].size(); ++i) {
        const json& level = record["levels"][i];
        EXPECT_FALSE(level["skipped"]) << "candidates that were not chosen are not shown";
        const double radius = std::sqrt(level["value"].get<double>() / 3.14159265);
        EXPECT_LE(level["deviation"].get<double>() / record["radius"].get<double>() * radius, 1.01)
            << "a pixel at most";
    }
}

TEST_F(GenerateCommandTest, theTableHasARowForEachLevel)
{
    const Outcome outcome = runLodsmith({"generate", torus("a.mesh"), "-o", in("b.mesh"), "--levels", kHalves});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("level  distance  vertices  triangles"));
    EXPECT_THAT(outcome.out, testing::ContainsRegex("\n +1 +10 +288 "));
    EXPECT_THAT(outcome.out, testing::ContainsRegex("\n +2 +20 +144 "));
    EXPECT_EQ(outcome.err, "");
}

TEST_F(GenerateCommandTest, missedTargetsAreExplained)
{
    const Outcome outcome =
        runLodsmith({"generate", torus("a.mesh"), "-o", in("b.mesh"), "--levels", "10:proportional:1", "--lock-seams"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("level 1: stopped before its target: "));
}

TEST_F(GenerateCommandTest, directoriesKeepTheirShapeAndOrder)
{
    torus("in/b/x.mesh");
    torus("in/a/x.mesh");
    const Outcome outcome =
        runLodsmith({"generate", in("in"), "-o", in("out"), "--levels", kHalves, "-j", "2", "--json"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const auto records = outcome.records();
    ASSERT_EQ(records.size(), 2u);
    EXPECT_EQ(records[0]["input"], in("in/a/x.mesh"));
    EXPECT_EQ(records[1]["output"], in("out/b/x.mesh"));
    EXPECT_EQ(contentOf(in("out/a/x.mesh")), contentOf(in("out/b/x.mesh")));
    EXPECT_THAT(outcome.err, HasSubstr("2 of 2: "));
}

TEST_F(GenerateCommandTest, nothingIsOverwrittenWithoutForce)
{
    const std::string mesh = torus("a.mesh"), before = contentOf(mesh);
    const Outcome kept = runLodsmith({"generate", mesh, "-o", mesh, "--levels", kHalves, "--json"});
    EXPECT_EQ(kept.exitCode, 1);
    EXPECT_THAT(kept.records().at(0)["error"].get<std::string>(), HasSubstr("--force"));
    EXPECT_EQ(contentOf(mesh), before);
    EXPECT_EQ(runLodsmith({"generate", mesh, "-o", mesh, "--levels", kHalves, "--force"}).exitCode, 0);
    EXPECT_GT(contentOf(mesh).size(), before.size());
}

TEST_F(GenerateCommandTest, levelsThatAreThereAreReplaced)
{
    const std::string mesh = torus("a.mesh");
    ASSERT_EQ(runLodsmith({"generate", mesh, "-o", in("b.mesh"), "--levels", kHalves}).exitCode, 0);
    ASSERT_EQ(runLodsmith({"generate", in("b.mesh"), "-o", in("c.mesh"), "--levels", kHalves}).exitCode, 0);
    EXPECT_EQ(contentOf(in("b.mesh")), contentOf(in("c.mesh")));
}

TEST_F(GenerateCommandTest, twoInputsToOneOutputAreRefused)
{
    const Outcome outcome = runLodsmith({"generate", torus("a/x.mesh"), torus("b/x.mesh"), "-o", in("out")});
    EXPECT_EQ(outcome.exitCode, 2);
    EXPECT_FALSE(fs::exists(in("out")));
}

TEST_F(GenerateCommandTest, theSkeletonGoesAlong)
{
    const std::string mesh = mDirectory.write("in/a.mesh", torusMesh(kSegments, "a.skeleton"));
    mDirectory.write("in/a.skeleton", "not read without bones");
    const Outcome outcome = runLodsmith({"generate", mesh, "-o", in("out/"), "--levels", kHalves});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_EQ(contentOf(in("out/a.skeleton")), contentOf(in("in/a.skeleton")));
}

TEST_F(GenerateCommandTest, differentSkeletonsOfOneNameAreRefusedEvenWithForce)
{
    std::vector<std::string> arguments{"generate", "-o", in("out/"), "--levels", kHalves, "--force", "-j", "1"};
    for (const std::string name : {"a", "b"}) {
        arguments.push_back(mDirectory.write(name + "/" + name + ".mesh", torusMesh(kSegments, "x.skeleton")));
        mDirectory.write(name + "/x.skeleton", "bones of " + name);
    }
    const Outcome outcome = runLodsmith(arguments);
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_THAT(outcome.err,
                HasSubstr("both '" + in("b/x.skeleton") + "' and '" + in("a/x.skeleton") + "' would be this file"));
    EXPECT_THAT(mDirectory.files(),
                ElementsAre("a/a.mesh", "a/x.skeleton", "b/b.mesh", "b/x.skeleton", "out/.lodsmith/a.mesh.json",
                            "out/.lodsmith/x.skeleton.json", "out/a.mesh", "out/x.skeleton"));
}

TEST_F(GenerateCommandTest, aSkeletonThatIsMissingIsNoted)
{
    const std::string mesh = mDirectory.write("a.mesh", torusMesh(kSegments, "gone.skeleton"));
    const Outcome outcome = runLodsmith({"generate", mesh, "-o", in("out/"), "--levels", kHalves});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("note: skeleton 'gone.skeleton'"));
}

TEST_F(GenerateCommandTest, namesFromInsideNeverLeadOutside)
{
    mDirectory.write("evil.skeleton", "bones");
    const std::string mesh = mDirectory.write("in/deep/a.mesh", torusMesh(kSegments, "../../evil.skeleton"));
    const Outcome outcome = runLodsmith({"generate", mesh, "-o", in("out/deep/er/"), "--levels", kHalves});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_THAT(mDirectory.files(), ElementsAre("evil.skeleton", "in/deep/a.mesh", "out/deep/er/.lodsmith/a.mesh.json",
                                                "out/deep/er/a.mesh"));
}

TEST_F(GenerateCommandTest, handMadeLevelsGoAlongUnderTheirOwnName)
{
    const std::string box = mDirectory.write("made/box.mesh", torusMesh(8));
    const Outcome outcome = runLodsmith(
        {"generate", torus("a.mesh"), "-o", in("out/"), "--levels", "10:proportional:0.5,50:mesh:" + box, "--json"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const json level = outcome.records().at(0)["levels"][2];
    EXPECT_EQ(level["manual"], "box.mesh");
    EXPECT_EQ(level["triangles"], test::torusTriangles(8));
    EXPECT_EQ(contentOf(in("out/box.mesh")), contentOf(box));
    OgreSession session;
    EXPECT_EQ(session.load(in("out/a.mesh")).value()->getLodLevel(2).manualName, "box.mesh");
}

TEST_F(GenerateCommandTest, aHandMadeLevelThatIsMissingIsAnError)
{
    const Outcome outcome =
        runLodsmith({"generate", torus("a.mesh"), "-o", in("out/"), "--levels", "50:mesh:" + in("gone.mesh")});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_THAT(outcome.err, HasSubstr("lodsmith: " + in("gone.mesh") + ": no such file"));
    EXPECT_FALSE(fs::exists(in("out")));
}

TEST_F(GenerateCommandTest, formatOptionsReachTheFile)
{
    ASSERT_EQ(runLodsmith({"generate", torus("a.mesh"), "-o", in("b.mesh"), "--levels", kHalves, "--mesh-version",
                           "1.8", "--endian", "big"})
                  .exitCode,
              0);
    const MeshHeader header = parseMeshHeader(contentOf(in("b.mesh"))).value();
    EXPECT_EQ(header.version, "1.8");
    EXPECT_TRUE(header.bigEndian);
}

TEST_F(GenerateCommandTest, twoRunsMakeTheSameBytes)
{
    const std::string mesh = torus("a.mesh");
    ASSERT_EQ(runLodsmith({"generate", mesh, "-o", in("b.mesh"), "--levels", kHalves}).exitCode, 0);
    ASSERT_EQ(runLodsmith({"generate", mesh, "-o", in("c.mesh"), "--levels", kHalves, "--repeat", "3"}).exitCode, 0);
    EXPECT_EQ(contentOf(in("b.mesh")), contentOf(in("c.mesh")));
}

TEST_F(GenerateCommandTest, outputThatCannotBeWrittenIsAFailure)
{
    const std::string command = "\"$0\" generate \"$1\" -o \"$2\" --json > /dev/full";
    const Outcome outcome = test::runProgram({"sh", "-c", command, LODSMITH_PROGRAM, torus("a.mesh"), in("b.mesh")});
    EXPECT_EQ(outcome.exitCode, 1);
}

TEST_F(GenerateCommandTest, realMeshesOfOthers)
{
    const std::string media = LODSMITH_EXTRA_MEDIA;
    if (media.empty())
        GTEST_SKIP() << "LODSMITH_EXTRA_MEDIA names no directory with further meshes";
    const Outcome outcome = runLodsmith({"generate", media, "-o", in("out"), "--levels", kHalves, "--json"});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    for (const json& record : outcome.records()) {
        ASSERT_TRUE(record["error"].is_null()) << record["error"];
        EXPECT_TRUE(fs::exists(record["output"].get<std::string>()));
    }
}

} // namespace lodsmith::cli
