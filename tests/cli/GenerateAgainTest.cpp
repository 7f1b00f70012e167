#include "CommandLine.h"
#include "SampleFiles.h"

#include <gmock/gmock.h>

#include <sys/stat.h>

namespace fs = std::filesystem;

namespace lodsmith::cli {

namespace {

using lodsmith::test::contentOf;
using lodsmith::test::TestDirectory;
using nlohmann::json;
using test::Outcome;
using test::runLodsmith;
using test::torusMesh;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr unsigned kSegments = 12;
constexpr const char* kHalf = "<lod><automatic enabled='false'/><manual><level distance='30'><value>0.5</value></level>"
                              "</manual></lod>";

/// `lodsmith generate in -o out`, more than once.
class GenerateAgainTest : public testing::Test {
protected:
    std::string in(const std::string& name) const { return (mDirectory / name).string(); }
    void torus(const std::string& name, unsigned segments = kSegments) const
    {
        mDirectory.write(name, torusMesh(segments));
    }

    Outcome run(std::vector<std::string> more = {}) const
    {
        more.insert(more.begin(), {"generate", in("in"), "-o", in("out"), "--json"});
        return runLodsmith(more);
    }

    /// Which of the meshes were made, in their order.
    std::vector<bool> made(const std::vector<std::string>& more = {}) const
    {
        const Outcome outcome = run(more);
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
        std::vector<bool> all;
        for (const json& record : outcome.records())
            all.push_back(!record["up_to_date"].get<bool>());
        return all;
    }

    void writeRecord(const std::string& name, const json& record) const { mDirectory.write(name, record.dump()); }

    TestDirectory mDirectory;
};

ino_t inode(const std::string& path)
{
    struct stat status = {};
    return ::stat(path.c_str(), &status) == 0 ? status.st_ino : 0;
}

} // namespace

TEST_F(GenerateAgainTest, whatIsUpToDateIsNotTouched)
{
    torus("in/a.mesh");
    torus("in/deep/b.mesh");
    ASSERT_THAT(made(), ElementsAre(true, true));
    const ino_t before = inode(in("out/deep/b.mesh"));
    EXPECT_THAT(made(), ElementsAre(false, false));
    EXPECT_EQ(inode(in("out/deep/b.mesh")), before);
}

TEST_F(GenerateAgainTest, whatIsSaidOfAMeshIsTheSameButForTimes)
{
    torus("in/a.mesh");
    json first = run().records().at(0), second = run().records().at(0);
    for (const char* time :
         {"cached", "read_ms", "generate_ms", "generate_min_ms", "order_ms", "foliage_ms", "write_ms", "peak_kb"}) {
        EXPECT_FALSE(first[time].is_null()) << time;
        EXPECT_TRUE(second[time].is_null()) << time;
        first[time] = nullptr;
    }
    EXPECT_EQ(first["up_to_date"], false);
    EXPECT_EQ(second["up_to_date"], true);
    first["up_to_date"] = true;
    EXPECT_EQ(first, second);

    const Outcome told = runLodsmith({"generate", in("in"), "-o", in("out")});
    EXPECT_EQ(told.out, in("in/a.mesh") + " -> " + in("out/a.mesh") + ": up to date\n");
}

TEST_F(GenerateAgainTest, theSumIsTold)
{
    torus("in/a.mesh");
    torus("in/b.mesh");
    mDirectory.write("in/c.mesh", "no mesh");
    EXPECT_THAT(run().err, HasSubstr("\n2 made, 0 up to date, 1 failed\n"));
    EXPECT_THAT(run().err, HasSubstr("\n0 made, 2 up to date, 1 failed\n"));
}

TEST_F(GenerateAgainTest, aChangedMeshIsMadeAgainAndNoOther)
{
    torus("in/a.mesh");
    torus("in/b.mesh");
    made();
    torus("in/b.mesh", 14);
    EXPECT_THAT(made(), ElementsAre(false, true));
    torus("other/b.mesh", 14);
    runLodsmith({"generate", in("other"), "-o", in("clean")});
    EXPECT_TRUE(contentOf(in("out/b.mesh")) == contentOf(in("clean/b.mesh")));
}

TEST_F(GenerateAgainTest, timeStampsAreNotTrusted)
{
    torus("in/a.mesh");
    made();
    const auto written = fs::last_write_time(in("in/a.mesh"));
    fs::last_write_time(in("in/a.mesh"), written + std::chrono::hours(1));
    EXPECT_THAT(made(), ElementsAre(false));
    std::string bytes = contentOf(in("in/a.mesh"));
    bytes[bytes.size() / 2] ^= 1;
    mDirectory.write("in/a.mesh", bytes);
    fs::last_write_time(in("in/a.mesh"), written);
    EXPECT_THAT(made(), ElementsAre(true));
}

TEST_F(GenerateAgainTest, aDefinitionThatComesChangesOrGoesCounts)
{
    torus("in/a.mesh");
    made();
    mDirectory.write("in/a.loddef", kHalf);
    EXPECT_THAT(made(), ElementsAre(true));
    EXPECT_THAT(made(), ElementsAre(false));
    mDirectory.write("in/a.loddef", std::string(kHalf) + "<!-- -->");
    EXPECT_THAT(made(), ElementsAre(true));
    fs::remove(in("in/a.loddef"));
    EXPECT_THAT(made(), ElementsAre(true));
}

TEST_F(GenerateAgainTest, aDefinitionThatIsGivenCounts)
{
    torus("in/a.mesh");
    const std::string file = mDirectory.write("all.loddef", kHalf);
    made({"--loddef", file});
    EXPECT_THAT(made({"--loddef", file}), ElementsAre(false));
    mDirectory.write("all.loddef", std::string(kHalf) + "<!-- -->");
    EXPECT_THAT(made({"--loddef", file}), ElementsAre(true));
    EXPECT_THAT(made(), ElementsAre(true));
}

TEST_F(GenerateAgainTest, aLinkThatLeadsElsewhereCounts)
{
    torus("in/a.mesh");
    mDirectory.write("one/x.loddef", kHalf);
    mDirectory.write("two/x.loddef", std::string(kHalf) + "<!-- -->");
    fs::create_directory_symlink(in("one"), in("now"));
    const std::vector<std::string> options{"--loddef", in("now/x.loddef")};
    made(options);
    EXPECT_THAT(made(options), ElementsAre(false));
    fs::remove(in("now"));
    fs::create_directory_symlink(in("two"), in("now"));
    EXPECT_THAT(made(options), ElementsAre(true));
}

TEST_F(GenerateAgainTest, aHandMadeLevelCounts)
{
    torus("in/a.mesh");
    torus("made/box.mesh", 5);
    const std::vector<std::string> options{"--levels", "10:proportional:0.5,50:mesh:" + in("made/box.mesh")};
    made(options);
    EXPECT_THAT(made(options), ElementsAre(false));
    torus("made/box.mesh", 6);
    EXPECT_THAT(made(options), ElementsAre(true)) << "and the copy that went along is replaced";
    EXPECT_TRUE(contentOf(in("out/box.mesh")) == contentOf(in("made/box.mesh")));
}

TEST_F(GenerateAgainTest, aHandMadeLevelFromElsewhereReplacesTheOneBefore)
{
    torus("in/a.mesh");
    torus("in/b.mesh");
    torus("in/c.mesh");
    torus("old/box.mesh", 5);
    torus("new/box.mesh", 6);
    for (const std::string directory : {"old", "new", "old"}) {
        const std::string box = in(directory + "/box.mesh");
        EXPECT_THAT(made({"--levels", "50:mesh:" + box}), Each(true));
        EXPECT_THAT(made({"--levels", "50:mesh:" + box}), Each(false));
        EXPECT_TRUE(contentOf(in("out/box.mesh")) == contentOf(box));
    }
}

TEST_F(GenerateAgainTest, aHandMadeLevelThatComesNearerCounts)
{
    torus("in/a.mesh");
    torus("defined/box.mesh", 5);
    mDirectory.write("defined/x.loddef", "<lod><automatic enabled='false'/><manual><level distance='30'>"
                                         "<meshName>box.mesh</meshName></level></manual></lod>");
    const std::vector<std::string> options{"--loddef", in("defined/x.loddef")};
    ASSERT_THAT(made(options), ElementsAre(true));
    EXPECT_THAT(made(options), ElementsAre(false));
    torus("in/box.mesh", 6);
    EXPECT_THAT(made(options), ElementsAre(true)) << "beside the mesh it is the one that counts";
    EXPECT_TRUE(contentOf(in("out/box.mesh")) == contentOf(in("in/box.mesh")));
}

TEST_F(GenerateAgainTest, theSkeletonCounts)
{
    mDirectory.write("in/a.mesh", torusMesh(kSegments, "a.skeleton"));
    made();
    EXPECT_THAT(made(), ElementsAre(false)) << "it is missing as before";
    for (const char* content : {"bones", "other bones"}) {
        mDirectory.write("in/a.skeleton", content);
        EXPECT_THAT(made(), ElementsAre(true));
        EXPECT_EQ(contentOf(in("out/a.skeleton")), content);
        EXPECT_THAT(made(), ElementsAre(false));
    }
}

TEST_F(GenerateAgainTest, meshesThatShareASkeletonAllGetTheNewOne)
{
    for (const char* name : {"in/a.mesh", "in/b.mesh", "in/c.mesh"})
        mDirectory.write(name, torusMesh(kSegments, "x.skeleton"));
    for (const char* content : {"bones", "other bones"}) {
        mDirectory.write("in/x.skeleton", content);
        EXPECT_THAT(made(), Each(true));
        EXPECT_THAT(made(), Each(false));
        EXPECT_EQ(contentOf(in("out/x.skeleton")), content);
    }
}

TEST_F(GenerateAgainTest, differentSkeletonsOfOneNameAreRefusedInLaterRunsToo)
{
    for (const std::string name : {"a", "b"}) {
        mDirectory.write(name + "/" + name + ".mesh", torusMesh(kSegments, "x.skeleton"));
        mDirectory.write(name + "/x.skeleton", "bones of " + name);
    }
    const auto generate = [&](const std::string& name) {
        return runLodsmith({"generate", in(name + "/" + name + ".mesh"), "-o", in("out/")});
    };
    ASSERT_EQ(generate("a").exitCode, 0);
    EXPECT_EQ(generate("b").exitCode, 1);
    EXPECT_EQ(contentOf(in("out/x.skeleton")), "bones of a");
    mDirectory.write("b/x.skeleton", "bones of a");
    EXPECT_EQ(generate("b").exitCode, 0) << "they are the same now";
    mDirectory.write("b/x.skeleton", "bones of b");
    fs::remove(in("a/x.skeleton"));
    EXPECT_EQ(generate("b").exitCode, 0) << "nothing stands for the other one any more";
    EXPECT_EQ(contentOf(in("out/x.skeleton")), "bones of b");
}

TEST_F(GenerateAgainTest, optionsThatChangeTheMeshCountAndOthersDoNot)
{
    torus("in/a.mesh");
    made();
    for (const std::vector<std::string>& options :
         std::vector<std::vector<std::string>>{{"--levels", "10:proportional:0.5"},
                                               {"--levels", "10:proportional:0.25"},
                                               {"--levels", "10:proportional:0.25", "--lock-seams"},
                                               {"--levels", "10:proportional:0.25", "--metric", "curvature"},
                                               {"--levels", "10:proportional:0.25", "--normal-weight", "0.1"},
                                               {"--levels", "10:proportional:0.25", "--strategy", "distance_box"},
                                               {"--share-buffers"},
                                               {"--endian", "big"},
                                               {"--mesh-version", "1.8"},
                                               {"--no-loddef"},
                                               {}}) {
        EXPECT_THAT(made(options), ElementsAre(true)) << testing::PrintToString(options);
        EXPECT_THAT(made(options), ElementsAre(false)) << testing::PrintToString(options);
    }
    EXPECT_THAT(made({"-j", "3", "--time-limit", "77", "--cache", in("cache"), "--memory", "500", "--shard", "1/1"}),
                ElementsAre(false));
}

TEST_F(GenerateAgainTest, whatAnotherVersionHasMadeIsMadeAgain)
{
    torus("in/a.mesh");
    made();
    const std::string name = "out/.lodsmith/a.mesh.json", text = contentOf(in(name));
    json record = json::parse(text);
    record["version"] = "lodsmith 0.0.1, OGRE 1.12.10";
    writeRecord(name, record);
    EXPECT_THAT(made(), ElementsAre(true));
    EXPECT_EQ(contentOf(in(name)), text);
}

TEST_F(GenerateAgainTest, whatWasChangedOrDeletedByHandIsMadeAgain)
{
    mDirectory.write("in/a.mesh", torusMesh(kSegments, "a.skeleton"));
    mDirectory.write("in/a.skeleton", "bones");
    made();
    for (const std::string name : {"out/a.mesh", "out/a.skeleton"}) {
        const std::string bytes = contentOf(in(name));
        for (const std::string& other : {bytes.substr(1), std::string(), "x" + bytes.substr(1)}) {
            mDirectory.write(name, other);
            EXPECT_THAT(made(), ElementsAre(true)) << name;
            EXPECT_EQ(contentOf(in(name)), bytes);
        }
        fs::remove(in(name));
        EXPECT_THAT(made(), ElementsAre(true)) << name;
        EXPECT_EQ(contentOf(in(name)), bytes);
    }
    EXPECT_THAT(made(), ElementsAre(false));
}

TEST_F(GenerateAgainTest, aDamagedRecordMeansMakingItAgain)
{
    torus("in/a.mesh");
    made();
    const std::string name = "out/.lodsmith/a.mesh.json", text = contentOf(in(name));
    std::vector<std::string> records{"", text.substr(0, text.size() / 2), "[]", "{\"format\":1}",
                                     "{\"format\":1,\"result\":0}"};
    for (const char* member : {"result", "read", "written", "input"})
        for (const char* value : {"null", "true", "1", "\"text\"", "[]", "[1]", "{}"}) {
            nlohmann::json record = nlohmann::json::parse(text);
            record[member] = nlohmann::json::parse(value);
            records.push_back(record.dump());
        }
    for (const std::string& damaged : records) {
        mDirectory.write(name, damaged);
        EXPECT_THAT(made(), ElementsAre(true)) << damaged;
        EXPECT_EQ(contentOf(in(name)), text);
    }
}

TEST_F(GenerateAgainTest, whatNobodyHasARecordOfIsNotOverwritten)
{
    torus("in/a.mesh");
    mDirectory.write("out/a.mesh", "somebody's");
    const Outcome refused = run();
    EXPECT_EQ(refused.exitCode, 1);
    EXPECT_THAT(refused.err, HasSubstr("out/a.mesh: is there already; --force overwrites it"));
    EXPECT_TRUE(contentOf(in("out/a.mesh")) == "somebody's");
    EXPECT_FALSE(fs::exists(in("out/.lodsmith")));
    EXPECT_THAT(made({"--force"}), ElementsAre(true));
    EXPECT_THAT(made(), ElementsAre(false));
}

TEST_F(GenerateAgainTest, aSkeletonThatNobodyHasARecordOfIsNotOverwritten)
{
    mDirectory.write("in/a.mesh", torusMesh(kSegments, "a.skeleton"));
    mDirectory.write("in/a.skeleton", "bones");
    mDirectory.write("out/a.skeleton", "somebody's");
    EXPECT_THAT(run().err, HasSubstr("out/a.skeleton: is there already; --force overwrites it"));
    EXPECT_THAT(mDirectory.files(), ElementsAre("in/a.mesh", "in/a.skeleton", "out/a.skeleton"));
    EXPECT_THAT(made({"--force"}), ElementsAre(true));
    EXPECT_EQ(contentOf(in("out/a.skeleton")), "bones");
}

TEST_F(GenerateAgainTest, forceMakesEverythingAgain)
{
    torus("in/a.mesh");
    made();
    const std::string bytes = contentOf(in("out/a.mesh")), record = contentOf(in("out/.lodsmith/a.mesh.json"));
    EXPECT_THAT(made({"--force"}), ElementsAre(true));
    EXPECT_TRUE(contentOf(in("out/a.mesh")) == bytes);
    EXPECT_EQ(contentOf(in("out/.lodsmith/a.mesh.json")), record);
}

TEST_F(GenerateAgainTest, timesThatAreAskedForAreMeasured)
{
    torus("in/a.mesh");
    made();
    EXPECT_THAT(made({"--repeat", "2"}), ElementsAre(true));
}

TEST_F(GenerateAgainTest, aMeshInItsOwnPlaceNeedsForceEveryTime)
{
    torus("a.mesh");
    EXPECT_EQ(runLodsmith({"generate", in("a.mesh"), "-o", in("a.mesh"), "--force"}).exitCode, 0);
    EXPECT_THAT(mDirectory.files(), ElementsAre("a.mesh"));
    EXPECT_EQ(runLodsmith({"generate", in("a.mesh"), "-o", in("a.mesh")}).exitCode, 1);
}

TEST_F(GenerateAgainTest, inputsAndOutputsMayBeMovedTogether)
{
    torus("project/in/a.mesh");
    mDirectory.write("project/in/a.loddef", kHalf);
    ASSERT_EQ(runLodsmith({"generate", in("project/in"), "-o", in("project/out")}).exitCode, 0);
    fs::rename(in("project"), in("moved"));
    const Outcome outcome = runLodsmith({"generate", in("moved/in"), "-o", in("moved/out"), "--json"});
    EXPECT_EQ(outcome.records().at(0)["up_to_date"], true);
}

TEST_F(GenerateAgainTest, anotherInputOfTheSameContentIsAnotherInput)
{
    torus("in/a.mesh");
    made();
    torus("other/a.mesh");
    mDirectory.write("other/a.loddef", kHalf);
    const Outcome outcome = runLodsmith({"generate", in("other"), "-o", in("out"), "--json"});
    EXPECT_EQ(outcome.records().at(0)["up_to_date"], false);
    EXPECT_EQ(outcome.records().at(0)["levels"].size(), 2u);
}

TEST_F(GenerateAgainTest, namesOfAnyBytesAreKnownAgain)
{
    const std::string odd = "\xff%41 \n\"\xc3\xbc";
    torus("in/" + odd + "/" + odd + ".mesh");
    EXPECT_THAT(made(), ElementsAre(true));
    EXPECT_THAT(made(), ElementsAre(false));
}

TEST_F(GenerateAgainTest, aMeshThatFailsLeavesWhatIsThereAndIsTriedAgain)
{
    torus("in/a.mesh");
    made();
    const std::string bytes = contentOf(in("out/a.mesh")), mesh = contentOf(in("in/a.mesh"));
    mDirectory.write("in/a.mesh", "no mesh");
    EXPECT_EQ(run().exitCode, 1);
    EXPECT_EQ(run().exitCode, 1);
    EXPECT_TRUE(contentOf(in("out/a.mesh")) == bytes);
    mDirectory.write("in/a.mesh", mesh);
    EXPECT_THAT(made(), ElementsAre(false));
}

} // namespace lodsmith::cli
