#include "CommandLine.h"
#include "SampleFiles.h"

#include <gmock/gmock.h>

namespace lodsmith::cli {

namespace {

using lodsmith::test::TestDirectory;
using test::Outcome;
using test::runLodsmith;

class MeasureCommandTest : public testing::Test {
protected:
    MeasureCommandTest()
    {
        const std::string mesh = mDirectory.write("a.mesh", test::torusMesh(24));
        mBox = mDirectory.write("box.mesh", test::torusMesh(8));
        EXPECT_EQ(runLodsmith({"generate", mesh, "-o", in("out/a.mesh"), "--levels",
                               "10:proportional:0.5,20:proportional:0.75,30:mesh:" + mBox})
                      .exitCode,
                  0);
    }

    std::string in(const std::string& name) const { return (mDirectory / name).string(); }

    nlohmann::json measure(std::vector<std::string> arguments) const
    {
        arguments.insert(arguments.begin(), {"measure", "--json", "--samples", "2000"});
        const Outcome outcome = runLodsmith(arguments);
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
        return outcome.records().at(0);
    }

    TestDirectory mDirectory;
    std::string mBox;
};

double mean(const nlohmann::json& level)
{
    return level["surface"]["mean"].get<double>();
}

} // namespace

TEST_F(MeasureCommandTest, levelsGetFartherFromTheOriginal)
{
    const nlohmann::json levels = measure({in("out/a.mesh")})["levels"];
    ASSERT_EQ(levels.size(), 4u);
    EXPECT_NEAR(mean(levels[0]), 0.0, 1e-6);
    EXPECT_GT(mean(levels[1]), 1e-4);
    EXPECT_GT(mean(levels[2]), mean(levels[1]));
    for (const auto& level : levels) {
        EXPECT_EQ(level["new_border_edges"], 0);
        EXPECT_EQ(level["flipped_triangles"], 0);
        EXPECT_LE(level["surface"]["mean"], level["surface"]["max"]);
    }
}

TEST_F(MeasureCommandTest, handMadeLevelsAreMeasuredToo)
{
    const nlohmann::json against = measure({mBox, "--against", in("a.mesh")})["levels"][0];
    const nlohmann::json level = measure({in("out/a.mesh")})["levels"][3];
    EXPECT_EQ(level["triangles"], test::torusTriangles(8));
    EXPECT_EQ(level["surface"], against["surface"]);
}

TEST_F(MeasureCommandTest, anotherOriginalGivesOtherFigures)
{
    const nlohmann::json levels = measure({in("out/a.mesh"), "--against", mBox})["levels"];
    EXPECT_GT(mean(levels[0]), 0.01);
    EXPECT_NEAR(mean(levels[3]), 0.0, 1e-6);
}

TEST_F(MeasureCommandTest, aMissingOriginalIsNamed)
{
    const Outcome outcome = runLodsmith({"measure", in("out/a.mesh"), "--against", in("gone.mesh")});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_THAT(outcome.err, testing::HasSubstr("lodsmith: " + in("gone.mesh") + ": no such file"));
}

TEST_F(MeasureCommandTest, aMissingHandMadeLevelIsNamed)
{
    std::filesystem::remove(in("out/box.mesh"));
    const Outcome outcome = runLodsmith({"measure", in("out/a.mesh")});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_THAT(outcome.err, testing::HasSubstr("box.mesh"));
}

} // namespace lodsmith::cli
