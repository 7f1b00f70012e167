#include "CommandLine.h"
#include "OgreSession.h"
#include "SampleFiles.h"

#include <gmock/gmock.h>

#include <filesystem>

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
using testing::Not;

// At half of the vertices the tree's outline stays, at a quarter and an eighth it does not.
const std::vector<std::string> kThinning = {"--levels",
                                            "20:proportional:0.5,60:proportional:0.75,150:proportional:0.875"};

class GenerateFoliageTest : public testing::Test {
protected:
    void SetUp() override { mDirectory.write("in/tree.mesh", contentOf(LODSMITH_MEDIA_DIR "/tree/tree.mesh")); }

    std::string in(const std::string& name) const { return (mDirectory / name).string(); }

    Outcome generate(const std::string& input, const std::string& output, const std::vector<std::string>& more) const
    {
        std::vector<std::string> arguments{"generate", in(input), "-o", in(output)};
        arguments.insert(arguments.end(), kThinning.begin(), kThinning.end());
        arguments.insert(arguments.end(), more.begin(), more.end());
        return runLodsmith(arguments);
    }

    json record(const std::string& input, const std::string& output, std::vector<std::string> more) const
    {
        more.emplace_back("--json");
        const Outcome outcome = generate(input, output, more);
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
        return outcome.records().at(0);
    }

    TestDirectory mDirectory;
};

} // namespace

TEST_F(GenerateFoliageTest, isLeftAloneAndNotedWithoutPermission)
{
    const json record = this->record("in/tree.mesh", "out/tree.mesh", {});
    EXPECT_THAT(mDirectory.files(), ElementsAre("in/tree.mesh", "out/.lodsmith/tree.mesh.json", "out/tree.mesh"));
    EXPECT_TRUE(record["levels"][0]["coverage"].is_null());
    EXPECT_GT(record["levels"][1]["coverage"], 0.95);
    EXPECT_LT(record["levels"][2]["coverage"], 0.95);
    for (const json& level : record["levels"])
        EXPECT_TRUE(level["separate"].is_null());
    ASSERT_EQ(record["notes"].size(), 2u);
    EXPECT_THAT(record["notes"][0], HasSubstr("level 2 covers 92.8 % "));
    EXPECT_THAT(record["notes"][0], HasSubstr("--separate-meshes"));
    EXPECT_THAT(record["notes"][1], HasSubstr("level 3 covers "));
}

TEST_F(GenerateFoliageTest, becomesMeshesOfItsOwnWherePermitted)
{
    const json thin = record("in/tree.mesh", "thin/tree.mesh", {});
    const json record = this->record("in/tree.mesh", "out/tree.mesh", {"--separate-meshes"});
    EXPECT_THAT(mDirectory.files(),
                ElementsAre("in/tree.mesh", "out/.lodsmith/tree.lod2.mesh.json", "out/.lodsmith/tree.lod3.mesh.json",
                            "out/.lodsmith/tree.mesh.json", "out/tree.lod2.mesh", "out/tree.lod3.mesh", "out/tree.mesh",
                            "thin/.lodsmith/tree.mesh.json", "thin/tree.mesh"));
    EXPECT_EQ(record["levels"][1], thin["levels"][1]) << "it covers enough";
    for (const std::size_t i : {2, 3}) {
        SCOPED_TRACE(i);
        const json &level = record["levels"][i], &before = thin["levels"][i];
        const std::string file = "tree.lod" + std::to_string(i) + ".mesh";
        EXPECT_EQ(level["separate"], file);
        EXPECT_EQ(level["value"], before["value"]);
        EXPECT_GE(level["coverage"], 0.95);
        EXPECT_LE(level["triangles"], before["triangles"]);
        EXPECT_EQ(level["bytes"], fs::file_size(in("out/" + file)));
    }
    EXPECT_TRUE(record["notes"].empty());

    OgreSession session;
    const auto mesh = session.load(in("out/tree.mesh"));
    ASSERT_TRUE(mesh) << describe(mesh.error());
    EXPECT_EQ(mesh.value()->getLodLevel(2).manualName, "tree.lod2.mesh");
    EXPECT_EQ(mesh.value()->getLodLevel(2).userValue, 60.0f);
}

TEST_F(GenerateFoliageTest, saysSoToPeople)
{
    const Outcome outcome = generate("in/tree.mesh", "out/tree.mesh", {"--separate-meshes"});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("\nlevel 2: a mesh of its own, tree.lod2.mesh, covers 9"));
    EXPECT_THAT(outcome.out, Not(HasSubstr("hand-made")));
}

TEST_F(GenerateFoliageTest, isTheSameEveryTimeAndReplacesOnlyWithForce)
{
    ASSERT_EQ(generate("in/tree.mesh", "one/tree.mesh", {"--separate-meshes"}).exitCode, 0);
    ASSERT_EQ(generate("in/tree.mesh", "two/tree.mesh", {"--separate-meshes", "-j", "2"}).exitCode, 0);
    for (const char* name : {"/tree.mesh", "/tree.lod2.mesh", "/tree.lod3.mesh"})
        EXPECT_EQ(contentOf(in("one") + name), contentOf(in("two") + name));

    const std::string other = mDirectory.write("three/tree.lod3.mesh", "somebody's");
    const Outcome refused = generate("in/tree.mesh", "three/tree.mesh", {"--separate-meshes"});
    EXPECT_EQ(refused.exitCode, 1);
    EXPECT_THAT(refused.err, HasSubstr("tree.lod3.mesh"));
    EXPECT_THAT(refused.err, HasSubstr("--force"));
    EXPECT_EQ(contentOf(other), "somebody's");
    EXPECT_FALSE(fs::exists(in("three/tree.mesh")));
    EXPECT_FALSE(fs::exists(in("three/tree.lod2.mesh"))) << "all or nothing";
    EXPECT_EQ(generate("in/tree.mesh", "three/tree.mesh", {"--separate-meshes", "--force"}).exitCode, 0);
    EXPECT_EQ(contentOf(other), contentOf(in("one/tree.lod3.mesh")));
}

TEST_F(GenerateFoliageTest, refusesNamesThatItsFilesCouldHave)
{
    mDirectory.write("in/tree.lod2.mesh", torusMesh(8));
    const Outcome refused = generate("in", "out", {"--separate-meshes"});
    EXPECT_EQ(refused.exitCode, 2);
    EXPECT_THAT(refused.err, HasSubstr("tree.lod2.mesh"));
    EXPECT_FALSE(fs::exists(in("out")));
    EXPECT_EQ(generate("in", "out", {}).exitCode, 0) << "nothing is separate";
}

TEST_F(GenerateFoliageTest, isNothingToMeshesWithout)
{
    mDirectory.write("in/torus.mesh", torusMesh(16));
    const json record = this->record("in/torus.mesh", "out/torus.mesh", {"--separate-meshes"});
    EXPECT_THAT(mDirectory.files(),
                ElementsAre("in/torus.mesh", "in/tree.mesh", "out/.lodsmith/torus.mesh.json", "out/torus.mesh"));
    for (const json& level : record["levels"]) {
        EXPECT_TRUE(level["coverage"].is_null());
        EXPECT_TRUE(level["separate"].is_null());
    }
    ASSERT_EQ(generate("in/torus.mesh", "plain/torus.mesh", {}).exitCode, 0);
    EXPECT_EQ(contentOf(in("out/torus.mesh")), contentOf(in("plain/torus.mesh")));
}

TEST_F(GenerateFoliageTest, canBeNamedByADefinitionAfterwards)
{
    ASSERT_EQ(generate("in/tree.mesh", "out/tree.mesh", {"--separate-meshes"}).exitCode, 0);
    fs::remove(in("out/tree.mesh"));
    mDirectory.write("out/tree.mesh", contentOf(in("in/tree.mesh")));
    mDirectory.write("out/tree.loddef",
                     "<lod><automatic enabled='false'/><manual><type>user</type>"
                     "<level distance='80'><meshName>tree.lod2.mesh</meshName></level></manual></lod>");
    const Outcome outcome = runLodsmith({"generate", in("out/tree.mesh"), "-o", in("again/tree.mesh"), "--json"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_EQ(outcome.records().at(0)["levels"][1]["manual"], "tree.lod2.mesh");
    EXPECT_EQ(contentOf(in("again/tree.lod2.mesh")), contentOf(in("out/tree.lod2.mesh")));
}

} // namespace lodsmith::cli
