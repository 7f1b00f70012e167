#include "CommandLine.h"
#include "SampleFiles.h"

#include <gmock/gmock.h>

namespace lodsmith::cli {

namespace {

using lodsmith::test::TestDirectory;
using test::Outcome;
using test::runLodsmith;
using testing::HasSubstr;
using testing::StartsWith;

/// Arguments that come before an input and an output that are in order.
struct WrongOptions {
    std::vector<std::string> options;
    std::string complaint;
};

} // namespace

TEST(Usage, helpOfEveryCommandHasAnExample)
{
    const Outcome all = runLodsmith({"--help"});
    EXPECT_EQ(all.exitCode, 0);
    for (const std::string command :
         {"generate", "inspect", "measure", "cost", "render", "report", "import", "strip", "validate"}) {
        EXPECT_THAT(all.out, HasSubstr(command));
        const Outcome help = runLodsmith({command, "--help"});
        EXPECT_EQ(help.exitCode, 0);
        EXPECT_THAT(help.out, HasSubstr("\n  lodsmith " + command + " "));
        EXPECT_EQ(help.err, "");
    }
}

TEST(Usage, versionIsOneLine)
{
    const Outcome version = runLodsmith({"--version"});
    EXPECT_EQ(version.exitCode, 0);
    EXPECT_THAT(version.out, testing::MatchesRegex("lodsmith [0-9]+\\.[0-9]+\\.[0-9]+\n"));
}

TEST(Usage, commandLinesWithoutWhatIsNeededAreRefused)
{
    const std::vector<std::vector<std::string>> lines{{},
                                                      {"dance"},
                                                      {"generate"},
                                                      {"generate", "x.mesh"},
                                                      {"generate", "x.mesh", "-o"},
                                                      {"generate", "x.mesh", "-o", ""},
                                                      {"generate", "-o", "y.mesh"},
                                                      {"strip", "x.mesh"},
                                                      {"inspect"},
                                                      {"inspect", "x.mesh", "y.mesh"},
                                                      {"measure"},
                                                      {"cost"},
                                                      {"import"},
                                                      {"validate"},
                                                      {"validate", "x.loddef", "-o", "y"}};
    for (const auto& line : lines) {
        const Outcome outcome = runLodsmith(line);
        EXPECT_EQ(outcome.exitCode, 2) << testing::PrintToString(line);
        EXPECT_EQ(outcome.out, "");
        EXPECT_THAT(outcome.err, StartsWith("lodsmith: "));
    }
}

TEST(Usage, wrongOptionsAreNamedAndNothingIsDone)
{
    const WrongOptions wrong[] = {
        {{"--levels", "20:proportional:1.5"}, "0 to 1"},
        {{"--levels", "20:proportional:0.5x"}, "'0.5x'"},
        {{"--levels", "1e400:proportional:0.5"}, "'1e400'"},
        {{"--levels", "20:constant:99999999999999999999"}, "'99999999999999999999'"},
        {{"--levels", ""}, "VALUE:METHOD:AMOUNT"},
        {{"--levels", "20:constant:1,10:constant:2"}, "rising distances"},
        {{"--levels", "10:constant:1,20:constant:2", "--strategy", "pixelcount"}, "falling pixel counts"},
        {{"--strategy", "distance"}, "--levels"},
        {{"--strategy", "far", "--levels", "1:constant:1"}, "'far'"},
        {{"--metric", "fast"}, "'fast'"},
        {{"--repeat", "0"}, "1 to 100000"},
        {{"--repeat", "1.5"}, "'1.5'"},
        {{"-j", "0"}, "'0'"},
        {{"-j", "-1"}, "'-1'"},
        {{"--uv-weight", "nan"}, "'nan'"},
        {{"--normal-weight", "-1"}, "'-1'"},
        {{"--uv-weight", "1", "--automatic", "classic"}, "--metric quadric"},
        {{"--pixels", "2", "--levels", "1:constant:1"}, "do not go with --levels"},
        {{"--automatic", "best"}, "balanced or classic"},
        {{"--pixels", "0"}, "--pixels"},
        {{"--bone-weight", "1", "--metric", "curvature", "--levels", "1:constant:1"}, "--metric quadric"},
        {{"--time-limit", "soon"}, "'soon'"},
        {{"--mesh-version", "1.9"}, "'1.9'"},
        {{"--mesh-version", "1.4"}, "no levels of detail"},
        {{"--endian", "middle"}, "'middle'"},
        {{"--levels", "10:mesh:a/x.mesh,20:mesh:b/x.mesh"}, "no other level"},
        {{"--levels", "10:mesh:elsewhere/out.mesh"}, "file name of the output"},
        {{"--loddef", ""}, "--loddef: the file has no name"},
        {{"--loddef", "a.loddef", "--no-loddef"}, "exclude each other"},
        {{"--loddef", "a.loddef", "--levels", "20:constant:1"}, "--loddef says what levels there are"},
        {{"--loddef", "a.loddef", "--strategy", "distance"}, "--loddef says what levels there are"},
        {{"--loddef", "a.loddef", "--metric", "quadric"}, "--loddef says what levels there are"},
        {{"--loddef", "a.loddef", "--uv-weight", "1"}, "--loddef says what levels there are"},
        {{"--loddef", "a.loddef", "--lock-borders"}, "--loddef says what levels there are"},
        {{"--loddef", "a.loddef", "--lock-seams"}, "--loddef says what levels there are"},
        {{"--no-such-option"}, "--no-such-option"},
    };
    const TestDirectory directory;
    const std::string mesh = directory.write("torus.mesh", test::torusMesh(8));
    for (const WrongOptions& options : wrong) {
        std::vector<std::string> line{"generate", mesh, "-o", (directory / "out.mesh").string()};
        line.insert(line.end(), options.options.begin(), options.options.end());
        const Outcome outcome = runLodsmith(line);
        EXPECT_EQ(outcome.exitCode, 2) << testing::PrintToString(options.options);
        EXPECT_THAT(outcome.err, HasSubstr(options.complaint)) << testing::PrintToString(options.options);
        EXPECT_EQ(outcome.out, "");
    }
    EXPECT_THAT(directory.files(), testing::ElementsAre("torus.mesh"));
}

TEST(Usage, helpThatCannotBeWrittenIsAFailure)
{
    EXPECT_EQ(test::runProgram({"sh", "-c", "\"$0\" --help > /dev/full", LODSMITH_PROGRAM}).exitCode, 1);
}

} // namespace lodsmith::cli
