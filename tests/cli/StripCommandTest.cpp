#include "CommandLine.h"
#include "SampleFiles.h"

#include <gmock/gmock.h>

namespace lodsmith::cli {

namespace {

using lodsmith::test::contentOf;
using lodsmith::test::TestDirectory;
using test::runLodsmith;

} // namespace

TEST(StripCommand, takesOutWhatGeneratePutIn)
{
    const TestDirectory directory;
    const std::string mesh = directory.write("a.mesh", test::torusMesh(12));
    const std::string with = (directory / "b.mesh").string(), without = (directory / "c.mesh").string();
    ASSERT_EQ(runLodsmith({"generate", mesh, "-o", with, "--levels", "10:proportional:0.5"}).exitCode, 0);
    const test::Outcome outcome = runLodsmith({"strip", with, "-o", without});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_THAT(outcome.out, testing::HasSubstr("1 levels taken out"));
    EXPECT_EQ(contentOf(without), contentOf(mesh));
}

TEST(StripCommand, keepsTheInputUnlessForced)
{
    const TestDirectory directory;
    const std::string mesh = directory.write("a.mesh", test::torusMesh(12));
    EXPECT_EQ(runLodsmith({"strip", mesh, "-o", mesh}).exitCode, 1);
    EXPECT_EQ(runLodsmith({"strip", mesh, "-o", mesh, "--force"}).exitCode, 0);
}

TEST(StripCommand, writesTheFormatsThatHoldNoLevels)
{
    const TestDirectory directory;
    const std::string mesh = directory.write("a.mesh", test::torusMesh(12));
    EXPECT_EQ(runLodsmith({"strip", mesh, "-o", (directory / "old.mesh").string(), "--mesh-version", "1.4"}).exitCode,
              0);
    EXPECT_EQ(contentOf(directory / "old.mesh").substr(2, 23), "[MeshSerializer_v1.40]\n");
}

} // namespace lodsmith::cli
