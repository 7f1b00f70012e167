#include "OutputPlan.h"

#include "support/TestDirectory.h"

#include <gmock/gmock.h>

namespace fs = std::filesystem;

namespace lodsmith::cli {

namespace {

using lodsmith::test::TestDirectory;
using testing::ElementsAre;
using testing::HasSubstr;

class OutputPlanTest : public testing::Test {
protected:
    std::string in(const std::string& name) const { return (mDirectory / name).string(); }

    /// Outputs relative to the test's directory.
    std::vector<std::string> outputs(const std::vector<std::string>& inputs, const std::string& output) const
    {
        std::vector<std::string> names;
        const auto plan = planOutputs(inputs, output);
        for (const PlannedFile& file : plan.value())
            names.push_back(file.error ? "error" : file.output.lexically_relative(mDirectory.path()).string());
        return names;
    }

    TestDirectory mDirectory;
};

} // namespace

TEST_F(OutputPlanTest, oneFileBecomesAFileOrGoesIntoADirectory)
{
    mDirectory.write("a.mesh", "");
    fs::create_directory(mDirectory / "there");
    EXPECT_THAT(outputs({in("a.mesh")}, in("b.mesh")), ElementsAre("b.mesh"));
    EXPECT_THAT(outputs({in("a.mesh")}, in("there")), ElementsAre("there/a.mesh"));
    EXPECT_THAT(outputs({in("a.mesh")}, in("new/")), ElementsAre("new/a.mesh"));
}

TEST_F(OutputPlanTest, severalFilesNeedADirectory)
{
    mDirectory.write("a.mesh", "");
    mDirectory.write("b.mesh", "");
    mDirectory.write("file", "");
    EXPECT_THAT(outputs({in("a.mesh"), in("b.mesh")}, in("out")), ElementsAre("out/a.mesh", "out/b.mesh"));
    EXPECT_FALSE(planOutputs({in("a.mesh"), in("b.mesh")}, in("file")));
}

TEST_F(OutputPlanTest, directoriesKeepRelativePaths)
{
    mDirectory.write("in/b/x.mesh", "");
    mDirectory.write("in/a/x.MESH", "");
    mDirectory.write("in/a/x.skeleton", "");
    mDirectory.write("in/y.mesh", "");
    fs::create_directory(mDirectory / "in/dir.mesh");
    EXPECT_THAT(outputs({in("in")}, in("out")), ElementsAre("out/a/x.MESH", "out/b/x.mesh", "out/y.mesh"));
}

TEST_F(OutputPlanTest, anOutputDirectoryInsideTheInputIsNoInput)
{
    mDirectory.write("in/x.mesh", "");
    mDirectory.write("in/out/x.mesh", "");
    EXPECT_THAT(outputs({in("in")}, in("in/out")), ElementsAre("in/out/x.mesh"));
}

TEST_F(OutputPlanTest, collisionsAreRefused)
{
    mDirectory.write("a/x.mesh", "");
    mDirectory.write("b/x.mesh", "");
    const auto plan = planOutputs({in("a/x.mesh"), in("b/x.mesh")}, in("out"));
    ASSERT_FALSE(plan);
    EXPECT_THAT(plan.error().message, testing::AllOf(HasSubstr(in("a/x.mesh")), HasSubstr(in("b/x.mesh"))));
    EXPECT_FALSE(planOutputs({in("a/x.mesh"), in("b/../a/x.mesh")}, in("out")));
}

TEST_F(OutputPlanTest, anOutputThatIsAnotherInputIsRefused)
{
    mDirectory.write("in/sub/x.mesh", "");
    mDirectory.write("out/sub/x.mesh", "");
    EXPECT_FALSE(planOutputs({in("in"), in("out/sub/x.mesh")}, in("out")));
}

TEST_F(OutputPlanTest, whatIsNotThereDoesNotStopTheOthers)
{
    mDirectory.write("a.mesh", "");
    fs::create_directory(mDirectory / "empty");
    EXPECT_THAT(outputs({in("nothing.mesh"), in("a.mesh"), in("empty")}, in("out")),
                ElementsAre("error", "out/a.mesh", "error"));
}

TEST_F(OutputPlanTest, anOutputNeedsAName)
{
    EXPECT_FALSE(planOutputs({in("a.mesh")}, ""));
}

} // namespace lodsmith::cli
