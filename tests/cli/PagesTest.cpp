#include "CommandLine.h"
#include "support/TestDirectory.h"

#include <gmock/gmock.h>

#include <regex>
#include <set>

namespace lodsmith::cli {

namespace {

using lodsmith::test::contentOf;
using test::runLodsmith;

constexpr const char* kCommands[] = {"generate", "inspect", "measure", "cost",    "render",
                                     "report",   "import",  "strip",   "validate"};

std::set<std::string> longOptions(const std::string& text)
{
    const std::regex option("--[a-z][a-z-]+");
    return {std::sregex_token_iterator(text.begin(), text.end(), option), {}};
}

std::set<std::string> optionsOfHelp()
{
    std::set<std::string> all = longOptions(runLodsmith({"--help"}).out);
    for (const char* command : kCommands)
        all.merge(longOptions(runLodsmith({command, "--help"}).out));
    return all;
}

/// A manual page as plain text needs no such care as roff does: hyphens are escaped there.
std::string withoutEscapes(const std::string& roff)
{
    return std::regex_replace(roff, std::regex("\\\\-"), "-");
}

std::string source(const std::string& name)
{
    return contentOf(std::string(LODSMITH_CLI_SOURCES) + "/" + name);
}

} // namespace

TEST(Pages, theManualPageHasEveryOptionAndNoOther)
{
    EXPECT_EQ(longOptions(withoutEscapes(source("lodsmith.1"))), optionsOfHelp());
}

TEST(Pages, completionKnowsEveryOptionAndNoOther)
{
    EXPECT_EQ(longOptions(source("lodsmith.bash")), optionsOfHelp());
}

TEST(Pages, completionOffersWhatFitsTheWord)
{
    const std::string script = std::string(LODSMITH_CLI_SOURCES) + "/lodsmith.bash";
    const auto complete = [&](const std::string& words) {
        return test::runProgram({"bash", "-c",
                                 "source '" + script + "'; COMP_WORDS=(" + words
                                     + "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _lodsmith; echo ${COMPREPLY[@]}"})
            .out;
    };
    EXPECT_EQ(complete("lodsmith gen"), "generate\n");
    EXPECT_EQ(complete("lodsmith generate --metric ''"), "quadric curvature\n");
    EXPECT_EQ(complete("lodsmith generate x.mesh --lock-b"), "--lock-borders\n");
    EXPECT_EQ(complete("lodsmith strip --lev"), "\n");
    EXPECT_EQ(complete("lodsmith generate x.mesh --no-l"), "--no-loddef\n");
    EXPECT_EQ(complete("lodsmith validate --"), "--json --help\n");
}

} // namespace lodsmith::cli
