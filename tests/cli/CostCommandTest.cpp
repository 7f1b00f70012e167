#include "CommandLine.h"
#include "SampleFiles.h"

#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>

namespace lodsmith::cli {

namespace {

namespace fs = std::filesystem;
using lodsmith::test::contentOf;
using lodsmith::test::TestDirectory;
using test::Outcome;
using test::runLodsmith;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

class CostCommandTest : public testing::Test {
protected:
    CostCommandTest() { mDirectory.write("plain.mesh", test::torusMesh(24)); }

    std::string in(const std::string& name) const { return (mDirectory / name).string(); }

    void generate(const std::string& name, const std::vector<std::string>& options)
    {
        std::vector<std::string> arguments = {"generate", in("plain.mesh"), "-o", in(name)};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const Outcome outcome = runLodsmith(arguments);
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    }

    nlohmann::json cost(std::vector<std::string> arguments) const
    {
        arguments.insert(arguments.begin(), {"cost", "--json"});
        const Outcome outcome = runLodsmith(arguments);
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
        EXPECT_EQ(outcome.err, "");
        return outcome.records().at(0);
    }

    TestDirectory mDirectory;
};

double sum(const nlohmann::json& record, const char* member)
{
    double result = 0;
    for (const auto& level : record["levels"])
        result += level[member].get<double>();
    return result;
}

double number(const nlohmann::json& value)
{
    return value.get<double>();
}

} // namespace

TEST_F(CostCommandTest, aMeshWithoutLevelsCostsWhatItsBytesCountAs)
{
    const nlohmann::json record = cost({in("plain.mesh")});
    const double bytes = static_cast<double>(fs::file_size(in("plain.mesh")));
    EXPECT_NEAR(number(record["cost"]), (bytes - 384) / 16 * 15000 / 250000, 1e-9 * bytes);
    EXPECT_EQ(record["bytes"], bytes);
    ASSERT_THAT(record["levels"], SizeIs(1));
    EXPECT_EQ(record["levels"][0]["share"], 1);
    EXPECT_EQ(record["levels"][0]["triangles"], test::torusTriangles(24));
    EXPECT_EQ(record["preset"], "seed");
    EXPECT_TRUE(record["optimised"].is_null());
    EXPECT_TRUE(record["error"].is_null());
    EXPECT_THAT(record["seen"], IsEmpty());
}

TEST_F(CostCommandTest, levelsSumToTheFilesAndAppearWhereTheStrategySays)
{
    mDirectory.write("box.mesh", test::torusMesh(6));
    generate("out/a.mesh", {"--levels", "10:proportional:0.5,20:proportional:0.75,40:mesh:" + in("box.mesh")});
    const nlohmann::json record = cost({in("out/a.mesh"), "--at", "0,25,1000", "--metres", "0.5"});
    const double files = static_cast<double>(fs::file_size(in("out/a.mesh")) + fs::file_size(in("out/box.mesh")));
    EXPECT_EQ(sum(record, "bytes"), files);
    EXPECT_EQ(record["bytes"], files);
    EXPECT_NEAR(sum(record, "share"), 1, 1e-12);
    EXPECT_NEAR(sum(record, "cost"), number(record["cost"]), 1e-9 * number(record["cost"]));
    ASSERT_THAT(record["levels"], SizeIs(4));
    // The torus' radii are 2 and 1: OGRE's sphere has a radius of 3, the box a half diagonal of sqrt(19).
    EXPECT_NEAR(number(record["levels"][1]["distance"]), 0.5 * std::hypot(10, 3), 1e-3);
    EXPECT_NEAR(number(record["levels"][3]["distance"]), 0.5 * std::hypot(40, 3), 1e-3);
    EXPECT_NEAR(number(record["radius"]), 0.5 * std::sqrt(19), 1e-3);
    EXPECT_EQ(record["levels"][3]["manual"], "box.mesh");
    EXPECT_EQ(record["levels"][3]["triangles"], test::torusTriangles(6));
    EXPECT_EQ(record["seen"][0]["level"], 0);
    EXPECT_EQ(record["seen"][1]["level"], 3);
    EXPECT_EQ(record["seen"][2]["bytes"], record["levels"][3]["bytes"]);
    EXPECT_THAT(record["files"], SizeIs(2));
    EXPECT_EQ(record["files"][1]["level"], 3);
}

TEST_F(CostCommandTest, pixelCountsDependOnTheView)
{
    generate("a.mesh", {"--strategy", "pixelcount", "--levels", "10000:proportional:0.5"});
    const double pi = 3.14159265358979;
    const nlohmann::json usual = cost({in("a.mesh")});
    EXPECT_NEAR(number(usual["levels"][1]["distance"]), 3 * 540 / std::tan(pi / 8) * std::sqrt(pi / 10000), 1e-2);
    const nlohmann::json half = cost({in("a.mesh"), "--viewport", "960x540"});
    EXPECT_NEAR(number(half["levels"][1]["distance"]), number(usual["levels"][1]["distance"]) / 2, 1e-6);
    const nlohmann::json wide = cost({in("a.mesh"), "--fov", "90"});
    EXPECT_NEAR(number(wide["levels"][1]["distance"]), 3 * 540 * std::sqrt(pi / 10000), 1e-2);
}

TEST_F(CostCommandTest, theFormulasRatiosTakeThePlaceOfTheStrategy)
{
    generate("a.mesh", {"--levels", "10:proportional:0.5,20:proportional:0.75"});
    const nlohmann::json record = cost({in("a.mesh"), "--preset-distances"});
    EXPECT_TRUE(record["strategy"].is_null());
    EXPECT_NEAR(number(record["levels"][1]["distance"]), number(record["radius"]) / 0.24, 1e-9);
    EXPECT_NEAR(number(record["levels"][2]["distance"]), number(record["radius"]) / 0.06, 1e-9);
}

TEST_F(CostCommandTest, aCopyAsALevelIsChargedByTheHonestPresetAlone)
{
    mDirectory.write("copy.mesh", contentOf(in("plain.mesh")));
    generate("out/a.mesh", {"--levels", "10:mesh:" + in("copy.mesh")});
    const double one = number(cost({in("plain.mesh"), "--preset", "viewer"})["cost"]);
    EXPECT_NEAR(number(cost({in("out/a.mesh"), "--preset", "viewer"})["cost"]), one, 0.02 * one);
    EXPECT_NEAR(number(cost({in("out/a.mesh"), "--preset", "honest"})["cost"]), 2 * one, 0.04 * one);
}

TEST_F(CostCommandTest, zlibSizesAreChargedOnDemand)
{
    const nlohmann::json record = cost({in("plain.mesh"), "--sizes", "zlib"});
    const double bytes = number(record["zlib_bytes"]);
    EXPECT_LT(bytes, number(record["bytes"]));
    EXPECT_NEAR(number(record["cost"]), (bytes - 384) / 16 * 0.06, 1e-9 * bytes);
}

TEST_F(CostCommandTest, constantsAreSettings)
{
    const double usual = number(cost({in("plain.mesh")})["cost"]);
    const nlohmann::json doubled = cost({in("plain.mesh"), "--constants", "budget_cost=30000"});
    EXPECT_NEAR(number(doubled["cost"]), 2 * usual, 1e-9 * usual);
}

TEST_F(CostCommandTest, theCheapestLevelsCanBeGenerated)
{
    const nlohmann::json before = cost({in("plain.mesh"), "--optimise", "1"});
    const nlohmann::json chain = before["optimised"];
    ASSERT_FALSE(chain["option"].is_null());
    EXPECT_LT(number(chain["cost"]), number(before["cost"]));
    for (const auto& level : chain["levels"])
        EXPECT_LE(number(level["deviation"]) / number(level["distance"]) * 540 / std::tan(3.14159265358979 / 8),
                  1 + 1e-9);
    generate("a.mesh", {"--strategy", "pixelcount", "--levels", chain["option"].get<std::string>()});
    const nlohmann::json after = cost({in("a.mesh")});
    ASSERT_EQ(after["levels"].size(), chain["levels"].size() + 1);
    EXPECT_NEAR(number(after["cost"]), number(chain["cost"]), 0.01 * number(chain["cost"]));
    for (std::size_t i = 0; i < chain["levels"].size(); ++i) {
        EXPECT_EQ(after["levels"][i + 1]["bytes"], chain["levels"][i]["bytes"]);
        EXPECT_NEAR(number(after["levels"][i + 1]["distance"]), number(chain["levels"][i]["distance"]),
                    1e-4 * number(chain["levels"][i]["distance"]));
    }
}

TEST_F(CostCommandTest, directoriesAreSearchedAndFailuresDoNotStopTheOthers)
{
    mDirectory.write("models/b/good.mesh", contentOf(in("plain.mesh")));
    mDirectory.write("models/a.mesh", contentOf(in("plain.mesh")).substr(0, 900));
    const Outcome outcome = runLodsmith({"cost", "--json", in("models"), in("gone.mesh")});
    EXPECT_EQ(outcome.exitCode, 1);
    const auto records = outcome.records();
    ASSERT_THAT(records, SizeIs(3));
    EXPECT_EQ(records[0]["input"], in("models/a.mesh"));
    EXPECT_EQ(records[0]["error_code"], "bad_file");
    EXPECT_TRUE(records[1]["error"].is_null());
    EXPECT_EQ(records[2]["error_code"], "not_found");
}

TEST_F(CostCommandTest, aMissingHandMadeLevelIsNamed)
{
    generate("out/a.mesh", {"--levels", "10:mesh:" + mDirectory.write("box.mesh", test::torusMesh(6))});
    fs::remove(in("out/box.mesh"));
    const Outcome outcome = runLodsmith({"cost", in("out/a.mesh")});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_THAT(outcome.err, HasSubstr("box.mesh: no such file"));
    EXPECT_EQ(outcome.out, "");
}

TEST_F(CostCommandTest, peopleGetATable)
{
    generate("a.mesh", {"--levels", "10:proportional:0.5,20:proportional:0.75"});
    const Outcome outcome = runLodsmith({"cost", in("a.mesh"), "--at", "15", "--optimise", "2"});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    for (const std::string word : {"level", "zlib", "share", "  all", "shrink first: level ", "at m",
                                   "cheapest within 2 pixels", "generate them with --strategy pixelcount --levels "})
        EXPECT_THAT(outcome.out, HasSubstr(word));
}

TEST_F(CostCommandTest, twoRunsSayTheSame)
{
    generate("a.mesh", {"--levels", "10:proportional:0.5"});
    const std::vector<std::string> arguments = {"cost", "--json", in("a.mesh"), "--optimise", "1"};
    EXPECT_EQ(runLodsmith(arguments).out, runLodsmith(arguments).out);
}

TEST_F(CostCommandTest, oddOptionsAreRefused)
{
    const std::vector<std::vector<std::string>> wrong = {{"--preset", "cheap"},
                                                         {"--constants", "budget_cost=0"},
                                                         {"--sizes", "gzip"},
                                                         {"--metres", "0"},
                                                         {"--viewport", "1920"},
                                                         {"--viewport", "0x1080"},
                                                         {"--fov", "0"},
                                                         {"--fov", "180"},
                                                         {"--at", "5,"},
                                                         {"--at", "-1"},
                                                         {"--optimise", "0"},
                                                         {"--optimise", "one"},
                                                         {"--optimise", "1", "--sizes", "zlib"},
                                                         {"--constants", "a=1"}};
    for (std::vector<std::string> arguments : wrong) {
        const std::string option = arguments[0];
        arguments.insert(arguments.begin(), {"cost", in("plain.mesh")});
        const Outcome outcome = runLodsmith(arguments);
        EXPECT_EQ(outcome.exitCode, 2) << option;
        EXPECT_THAT(outcome.err, HasSubstr(option));
        EXPECT_EQ(outcome.out, "");
    }
}

} // namespace lodsmith::cli
