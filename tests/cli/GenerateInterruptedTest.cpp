#include "CommandLine.h"
#include "SampleFiles.h"

#include "support/MeshBuilders.h"

#include <gmock/gmock.h>

#include <chrono>
#include <csignal>
#include <map>

#include <unistd.h>

namespace fs = std::filesystem;

namespace lodsmith::cli {

namespace {

using Clock = std::chrono::steady_clock;
using lodsmith::test::contentOf;
using lodsmith::test::TestDirectory;
using test::runLodsmith;
using testing::HasSubstr;

constexpr unsigned kMeshes = 14;
constexpr int kRounds = 4;
constexpr int kMostKills = 200;

/// A run over a directory that is ended again and again, and begun again.
class GenerateInterruptedTest : public testing::Test {
protected:
    GenerateInterruptedTest()
    {
        mDirectory.write("in/x.skeleton", "bones");
        for (unsigned i = 0; i < kMeshes; ++i)
            mDirectory.write("in/" + std::to_string(i % 4) + "/" + std::to_string(i) + ".mesh",
                             test::torusMesh(10 + i));
        mDirectory.write("in/0/skinned.mesh", test::torusMesh(12, "x.skeleton"));
        mDirectory.write("in/0/x.skeleton", "bones");
        const auto start = Clock::now();
        EXPECT_EQ(runLodsmith(arguments("clean")).exitCode, 0);
        mSeconds = std::chrono::duration<double>(Clock::now() - start).count();
    }

    std::vector<std::string> arguments(const std::string& output, std::vector<std::string> more = {}) const
    {
        more.insert(more.begin(),
                    {"generate", (mDirectory / "in").string(), "-o", (mDirectory / output).string(), "-j", "2"});
        return more;
    }

    /// The files below a directory, without what a killed process has left half-written.
    std::map<std::string, std::string> filesOf(const std::string& directory) const
    {
        std::map<std::string, std::string> files;
        for (const std::string& name : mDirectory.files())
            if (name.rfind(directory + "/", 0) == 0 && name.find("/.lodsmith-") == std::string::npos)
                files[name.substr(directory.size())] = contentOf(mDirectory / name);
        return files;
    }

    void expectClean(const std::string& directory) const { EXPECT_TRUE(filesOf(directory) == filesOf("clean")); }

    /// Starts the run and ends it some time later, until it comes to its end by itself. How often it was ended.
    int runWithEndings(const std::string& output, int signal)
    {
        for (int endings = 0; endings < kMostKills; ++endings) {
            const pid_t leader = test::startLodsmith(arguments(output));
            ::usleep(static_cast<useconds_t>(1e6 * mSeconds * mRandom.uniform(0.05, 0.5)));
            ::kill(signal == SIGKILL ? -leader : leader, signal);
            if (test::waitForGroup(leader) == 0)
                return endings;
        }
        ADD_FAILURE() << "no run came to its end";
        return 0;
    }

    TestDirectory mDirectory;
    lodsmith::test::TestRandom mRandom{5};
    double mSeconds = 0.0;
};

} // namespace

TEST_F(GenerateInterruptedTest, killedAtAnyMomentItContinuesAndComesToTheSameBytes)
{
    int kills = 0;
    for (int round = 0; round < kRounds; ++round) {
        kills += runWithEndings("out", SIGKILL);
        expectClean("out");
        EXPECT_THAT(runLodsmith(arguments("out")).err, HasSubstr("0 made, 15 up to date, 0 failed"));
        fs::remove_all(mDirectory / "out");
    }
    EXPECT_GT(kills, kRounds);
}

TEST_F(GenerateInterruptedTest, interruptedItContinuesAndLeavesNoRest)
{
    EXPECT_GT(runWithEndings("out", SIGINT), 0);
    expectClean("out");
    for (const std::string& name : mDirectory.files())
        EXPECT_EQ(name.find("/.lodsmith-"), std::string::npos) << name;
}

TEST_F(GenerateInterruptedTest, killedWhileItMakesThingsAgainItContinuesToo)
{
    ASSERT_EQ(runLodsmith(arguments("out", {"--levels", "10:proportional:0.3"})).exitCode, 0);
    EXPECT_GT(runWithEndings("out", SIGKILL), 0);
    expectClean("out");
}

TEST_F(GenerateInterruptedTest, nothingThatWasDoneIsDoneTwice)
{
    const pid_t leader = test::startLodsmith(arguments("out"));
    ::usleep(static_cast<useconds_t>(0.5e6 * mSeconds));
    ::kill(-leader, SIGKILL);
    test::waitForGroup(leader);
    std::size_t whole = 0;
    const auto clean = filesOf("clean"), out = filesOf("out");
    for (const auto& [name, content] : out)
        if (fs::path(name).extension() == ".mesh")
            whole += content == clean.at(name) ? 1 : 0;
    const std::string sum = std::to_string(kMeshes + 1 - whole) + " made, " + std::to_string(whole) + " up to date";
    EXPECT_THAT(runLodsmith(arguments("out")).err, HasSubstr(sum));
}

TEST_F(GenerateInterruptedTest, processesOverOneDirectoryDoNotHarmEachOther)
{
    for (int round = 0; round < kRounds; ++round) {
        const std::vector<pid_t> leaders{test::startLodsmith(arguments("out")), test::startLodsmith(arguments("out"))};
        for (const pid_t leader : leaders)
            EXPECT_EQ(test::waitForGroup(leader), 0);
        expectClean("out");
        fs::remove_all(mDirectory / "out");
    }
}

TEST_F(GenerateInterruptedTest, whatProcessesWithDifferentOptionsLeaveIsPutRight)
{
    std::vector<pid_t> leaders;
    for (const char* amount : {"0.3", "0.6"})
        leaders.push_back(
            test::startLodsmith(arguments("out", {"--levels", std::string("10:proportional:") + amount})));
    for (const pid_t leader : leaders)
        test::waitForGroup(leader);
    EXPECT_EQ(runLodsmith(arguments("out")).exitCode, 0);
    expectClean("out");
}

} // namespace lodsmith::cli
