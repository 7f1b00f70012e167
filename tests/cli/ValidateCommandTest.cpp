#include "CommandLine.h"
#include "support/TestDirectory.h"

#include <gmock/gmock.h>

namespace lodsmith::cli {

namespace {

using lodsmith::test::TestDirectory;
using test::Outcome;
using test::runLodsmith;
using testing::HasSubstr;

constexpr const char* kRight = "<lod><automatic enabled='false'/><manual><level distance='20'/></manual></lod>";
constexpr const char* kWrong = "<lod>\n<automatic enabled='no'/>\n<manual><level/></manual></lod>";
constexpr const char* kStrange = "<lod>\n<history/></lod>";

} // namespace

TEST(ValidateCommand, saysWhatIsInValidFiles)
{
    const TestDirectory directory;
    const std::string one = directory.write("one.loddef", kRight), two = directory.write("two.loddef", "<lod/>");
    const Outcome outcome = runLodsmith({"validate", one, two});
    EXPECT_EQ(outcome.exitCode, 0);
    EXPECT_EQ(outcome.out, one + ": valid, 1 level by distance_sphere\n" + two + ": valid, automatic levels\n");
    EXPECT_EQ(outcome.err, "");
}

TEST(ValidateCommand, reportsEveryErrorAndGoesOn)
{
    const TestDirectory directory;
    const std::string wrong = directory.write("wrong.loddef", kWrong), right = directory.write("right.loddef", kRight);
    const Outcome outcome = runLodsmith({"validate", wrong, (directory / "none.loddef").string(), right});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_EQ(outcome.out, right + ": valid, 1 level by distance_sphere\n");
    EXPECT_THAT(outcome.err, HasSubstr("lodsmith: " + wrong + ":2: enabled is 'no'; allowed: "));
    EXPECT_THAT(outcome.err, HasSubstr("lodsmith: " + wrong + ":3: <level> has no attribute 'distance'"));
    EXPECT_THAT(outcome.err, HasSubstr("none.loddef: no such file\n"));
}

TEST(ValidateCommand, warningsAreNoFailure)
{
    const TestDirectory directory;
    const std::string file = directory.write("strange.loddef", kStrange);
    const Outcome outcome = runLodsmith({"validate", file});
    EXPECT_EQ(outcome.exitCode, 0);
    EXPECT_THAT(outcome.err, HasSubstr("lodsmith: warning: " + file + ":2: <history> in <lod> is unknown"));
}

TEST(ValidateCommand, givesOneJsonObjectAFile)
{
    const TestDirectory directory;
    const std::string right = directory.write("right.loddef", kRight), wrong = directory.write("wrong.loddef", kWrong),
                      strange = directory.write("strange.loddef", kStrange);
    const Outcome outcome = runLodsmith({"validate", right, wrong, strange, "--json"});
    EXPECT_EQ(outcome.exitCode, 1);
    const auto records = outcome.records();
    ASSERT_EQ(records.size(), 3u);
    EXPECT_EQ(records[0]["input"], right);
    EXPECT_EQ(records[0]["valid"], true);
    EXPECT_EQ(records[0]["automatic"], false);
    EXPECT_EQ(records[0]["strategy"], "distance_sphere");
    EXPECT_EQ(records[0]["levels"], 1);
    EXPECT_TRUE(records[0]["errors"].empty());
    EXPECT_EQ(records[1]["valid"], false);
    EXPECT_TRUE(records[1]["levels"].is_null());
    ASSERT_EQ(records[1]["errors"].size(), 2u);
    EXPECT_EQ(records[1]["errors"][0]["line"], 2);
    EXPECT_EQ(records[1]["errors"][0]["code"], "bad_file");
    EXPECT_EQ(records[2]["valid"], true);
    EXPECT_EQ(records[2]["warnings"].at(0)["line"], 2);
}

TEST(ValidateCommand, jsonHasNoLineWhereThereIsNone)
{
    const Outcome outcome = runLodsmith({"validate", "/nowhere/a.loddef", "--json"});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_TRUE(outcome.records().at(0)["errors"].at(0)["line"].is_null());
    EXPECT_EQ(outcome.records().at(0)["errors"].at(0)["code"], "not_found");
}

TEST(ValidateCommand, changesNothing)
{
    const TestDirectory directory;
    const std::string file = directory.write("strange.loddef", kStrange);
    runLodsmith({"validate", file});
    EXPECT_EQ(lodsmith::test::contentOf(file), kStrange);
    EXPECT_THAT(directory.files(), testing::ElementsAre("strange.loddef"));
}

TEST(ValidateCommand, resultsThatCannotBeWrittenAreAFailure)
{
    const TestDirectory directory;
    const std::string file = directory.write("right.loddef", kRight);
    EXPECT_EQ(test::runProgram({"sh", "-c", "\"$0\" validate \"$1\" > /dev/full", LODSMITH_PROGRAM, file}).exitCode, 1);
}

} // namespace lodsmith::cli
