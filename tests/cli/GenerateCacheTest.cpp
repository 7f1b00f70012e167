#include "CommandLine.h"
#include "SampleFiles.h"

#include <gmock/gmock.h>

namespace fs = std::filesystem;

namespace lodsmith::cli {

namespace {

using lodsmith::test::contentOf;
using lodsmith::test::TestDirectory;
using test::Outcome;
using test::runLodsmith;
using test::torusMesh;
using testing::Each;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::SizeIs;

class GenerateCacheTest : public testing::Test {
protected:
    std::string in(const std::string& name) const { return (mDirectory / name).string(); }

    std::vector<std::string> arguments(const std::string& output, const std::vector<std::string>& more) const
    {
        std::vector<std::string> all{"generate", in("in"), "-o", in(output), "--levels", "10:proportional:0.5"};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }

    /// Generates everything below in/; which of the meshes came from the cache.
    std::vector<bool> generate(const std::string& output, std::vector<std::string> more) const
    {
        more.emplace_back("--json");
        const Outcome outcome = runLodsmith(arguments(output, more));
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
        std::vector<bool> cached;
        for (const nlohmann::json& record : outcome.records())
            cached.push_back(record["cached"].get<bool>());
        return cached;
    }

    TestDirectory mDirectory;
};

} // namespace

TEST_F(GenerateCacheTest, whatHasNotChangedIsTakenFromThere)
{
    mDirectory.write("in/a.mesh", torusMesh(12));
    mDirectory.write("in/b.mesh", torusMesh(16));
    EXPECT_THAT(generate("without", {}), ElementsAre(false, false));
    EXPECT_THAT(generate("first", {"--cache", in("cache")}), ElementsAre(false, false));
    mDirectory.write("in/a.mesh", torusMesh(14));
    EXPECT_THAT(generate("second", {"--cache", in("cache")}), ElementsAre(false, true));
    EXPECT_EQ(contentOf(in("first/a.mesh")), contentOf(in("without/a.mesh")));
    EXPECT_EQ(contentOf(in("second/b.mesh")), contentOf(in("without/b.mesh")));
    EXPECT_NE(contentOf(in("second/a.mesh")), contentOf(in("first/a.mesh")));

    const Outcome told = runLodsmith(arguments("third", {"--cache", in("cache")}));
    EXPECT_THAT(told.out, HasSubstr("taken from the cache"));
    EXPECT_THAT(told.out, Not(HasSubstr("generated")));
}

TEST_F(GenerateCacheTest, twoProcessesShareIt)
{
    for (unsigned i = 0; i < 8; ++i)
        mDirectory.write("in/" + std::to_string(i) + ".mesh", torusMesh(12 + i));
    generate("without", {});
    std::vector<pid_t> leaders;
    for (const char* output : {"one", "other"})
        leaders.push_back(test::startLodsmith(arguments(output, {"--cache", in("cache"), "-j", "2"})));
    for (const pid_t leader : leaders)
        EXPECT_EQ(test::waitForGroup(leader), 0);
    EXPECT_THAT(generate("third", {"--cache", in("cache")}), testing::AllOf(SizeIs(8), Each(true)));
    for (unsigned i = 0; i < 8; ++i)
        for (const char* output : {"one", "other", "third"}) {
            const std::string name = "/" + std::to_string(i) + ".mesh";
            EXPECT_EQ(contentOf(in(output + name)), contentOf(in("without" + name))) << output << name;
        }
    for (const auto& file : fs::directory_iterator(in("cache")))
        EXPECT_THAT(file.path().string(), EndsWith(".lodchain"));
}

TEST_F(GenerateCacheTest, whatCannotBeStoredIsNotedAndWrittenAllTheSame)
{
    mDirectory.write("in/a.mesh", torusMesh(12));
    const std::string notADirectory = mDirectory.write("cache", "");
    const Outcome outcome = runLodsmith(arguments("out", {"--cache", notADirectory}));
    EXPECT_EQ(outcome.exitCode, 0);
    EXPECT_THAT(outcome.out, HasSubstr("note: the levels could not be kept in the cache: "));
    EXPECT_TRUE(fs::exists(in("out/a.mesh")));
}

TEST_F(GenerateCacheTest, itNeedsAName)
{
    const Outcome outcome = runLodsmith(arguments("out", {"--cache", ""}));
    EXPECT_EQ(outcome.exitCode, 2);
    EXPECT_THAT(outcome.err, HasSubstr("--cache: "));
}

} // namespace lodsmith::cli
