#include "CommandLine.h"
#include "SampleFiles.h"

#include <gmock/gmock.h>

#include <csignal>
#include <random>

#include <unistd.h>

namespace fs = std::filesystem;

namespace lodsmith::cli {

namespace {

using lodsmith::test::contentOf;
using lodsmith::test::TestDirectory;
using test::Outcome;
using test::runLodsmith;
using test::torusMesh;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr const char* kHalf = "10:proportional:0.5";
// OGRE's own chunks end in the last bytes: cut there, a file may have lost nothing that matters.
constexpr std::size_t kTail = 200;

class BadInputTest : public testing::Test {
protected:
    std::string in(const std::string& name) const { return (mDirectory / name).string(); }

    /// Runs generate over the test's directory "in", which ends in order whatever lies there.
    Outcome generateAll() const
    {
        return runLodsmith(
            {"generate", in("in"), "-o", in("out"), "--levels", kHalf, "--json", "-j", "4", "--time-limit", "20"});
    }

    TestDirectory mDirectory;
};

/// Every failed record names its file, has no levels, and left no output; every other one did.
void expectWholeOrNothing(const Outcome& outcome)
{
    for (const auto& record : outcome.records()) {
        const bool failed = !record["error"].is_null();
        EXPECT_EQ(fs::exists(record["output"].get<std::string>()), !failed) << record;
        if (failed) {
            EXPECT_THAT(record["error"].get<std::string>(), HasSubstr(record["input"].get<std::string>()));
            EXPECT_TRUE(record["levels"].empty());
        }
    }
}

} // namespace

TEST_F(BadInputTest, badFilesDoNotStopTheOthers)
{
    mDirectory.write("text.mesh", "hello");
    mDirectory.write("empty.mesh", "");
    mDirectory.write("good.mesh", torusMesh(12));
    fs::create_directory(mDirectory / "empty-directory");
    const Outcome outcome =
        runLodsmith({"generate", in("text.mesh"), in("empty.mesh"), in("gone.mesh"), in("empty-directory"),
                     "/proc/self/mem", in("good.mesh"), "-o", in("out"), "--levels", kHalf, "--json"});
    EXPECT_EQ(outcome.exitCode, 1);
    const auto records = outcome.records();
    ASSERT_EQ(records.size(), 6u);
    const char* const complaints[] = {"no OGRE mesh", "is empty", "no such file", "holds no .mesh file",
                                      "cannot be read"};
    for (std::size_t i = 0; i < 5; ++i) {
        EXPECT_THAT(records[i]["error"].get<std::string>(), HasSubstr(complaints[i]));
        EXPECT_THAT(outcome.err, HasSubstr("lodsmith: " + records[i]["error"].get<std::string>()));
    }
    EXPECT_TRUE(records[5]["error"].is_null());
    EXPECT_TRUE(fs::exists(in("out/good.mesh")));
}

TEST_F(BadInputTest, aFileThatMayNotBeReadIsNamed)
{
    if (::geteuid() == 0)
        GTEST_SKIP() << "root may read everything";
    const std::string mesh = mDirectory.write("secret.mesh", torusMesh(8));
    fs::permissions(mesh, fs::perms::none);
    const Outcome outcome = runLodsmith({"inspect", mesh});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_THAT(outcome.err, HasSubstr("lodsmith: " + mesh + ": cannot be opened"));
}

TEST_F(BadInputTest, everyCutOffFileFails)
{
    const std::string whole = torusMesh(12);
    std::size_t files = 0;
    for (std::size_t size = 1; size < whole.size() - kTail; size += 211, ++files)
        mDirectory.write("in/" + std::to_string(size) + ".mesh", whole.substr(0, size));
    const Outcome outcome = generateAll();
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_EQ(outcome.records().size(), files);
    for (const auto& record : outcome.records())
        EXPECT_FALSE(record["error"].is_null()) << record["input"];
    expectWholeOrNothing(outcome);
}

TEST_F(BadInputTest, flippedBitsEndInOrder)
{
    const std::string whole = torusMesh(12);
    std::mt19937 random(1);
    constexpr std::size_t kFiles = 150;
    for (std::size_t file = 0; file < kFiles; ++file) {
        std::string broken = whole;
        // The structure is at both ends; the middle is vertices and indices.
        const std::size_t range = file % 3 == 0 ? whole.size() : 200;
        for (int flips = 0; flips < 3; ++flips) {
            const std::size_t place = random() % range;
            broken[file % 3 == 1 ? place : whole.size() - 1 - place] ^= static_cast<char>(1u << random() % 8);
        }
        mDirectory.write("in/" + std::to_string(file) + ".mesh", broken);
    }
    const Outcome outcome = generateAll();
    EXPECT_GE(outcome.exitCode, 0);
    EXPECT_EQ(outcome.records().size(), kFiles);
    expectWholeOrNothing(outcome);
}

TEST_F(BadInputTest, aFullDiskLeavesNothingBehind)
{
    const std::string mesh = mDirectory.write("a.mesh", torusMesh(24));
    const std::string before = contentOf(mesh);
    // A limit on file sizes looks like a full disk; it is large enough for the program's output, which the tests keep
    // in files.
    const Outcome outcome = runLodsmith({"generate", mesh, "-o", in("out/"), "--levels", kHalf}, before.size());
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_THAT(outcome.err, HasSubstr("lodsmith: " + in("out/a.mesh") + ": cannot be written"));
    EXPECT_THAT(mDirectory.files(), ElementsAre("a.mesh"));
    const Outcome forced = runLodsmith({"generate", mesh, "-o", mesh, "--force", "--levels", kHalf}, before.size());
    EXPECT_EQ(forced.exitCode, 1);
    EXPECT_EQ(contentOf(mesh), before);
    EXPECT_THAT(mDirectory.files(), ElementsAre("a.mesh"));
}

TEST_F(BadInputTest, anInterruptEndsEverythingAndLeavesNothing)
{
    const std::string mesh = mDirectory.write("a.mesh", torusMesh(24));
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) {
        const Outcome outcome =
            test::runProgram({"timeout", "--preserve-status", "--signal=" + std::to_string(signal), "1",
                              LODSMITH_PROGRAM, "generate", mesh, "-o", in("b.mesh"), "--repeat", "100000"});
        EXPECT_EQ(outcome.exitCode, 128 + signal);
        EXPECT_THAT(mDirectory.files(), ElementsAre("a.mesh"));
    }
}

TEST_F(BadInputTest, devicesAreNoOutputs)
{
    const std::string mesh = mDirectory.write("a.mesh", torusMesh(8));
    const Outcome outcome = runLodsmith({"generate", mesh, "-o", "/dev/full", "--force", "--levels", kHalf});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

TEST_F(BadInputTest, anOutputDirectoryThatIsAFileIsAUsageError)
{
    const std::string mesh = mDirectory.write("a.mesh", torusMesh(8));
    const std::string file = mDirectory.write("file", "x");
    EXPECT_EQ(runLodsmith({"generate", mesh, "-o", file + "/", "--levels", kHalf}).exitCode, 2);
    EXPECT_EQ(runLodsmith({"generate", mesh, "-o", file + "/x.mesh", "--levels", kHalf}).exitCode, 1);
}

TEST_F(BadInputTest, namesWithOddCharactersWork)
{
    const std::string name = "b\xc3\xa4um \"x\" \xff\n.mesh";
    const std::string mesh = mDirectory.write(name, torusMesh(8));
    const Outcome outcome = runLodsmith({"generate", mesh, "-o", in("out/"), "--levels", kHalf, "--json"});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_EQ(outcome.records().size(), 1u);
    EXPECT_TRUE(fs::exists(mDirectory / ("out/" + name)));
}

} // namespace lodsmith::cli
