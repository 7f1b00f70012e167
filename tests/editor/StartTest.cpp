#include "EditorSession.h"

#include <gmock/gmock.h>

#include <cstdlib>
#include <fstream>

#include <sys/wait.h>

namespace fs = std::filesystem;

namespace lodsmith::test {
namespace {

using testing::HasSubstr;

/// What happens at the editor's start and end.
class StartTest : public testing::Test {
protected:
    void SetUp() override
    {
        if (!EditorSession::isAvailable())
            GTEST_SKIP() << "Xvfb or xdotool is not installed";
    }

    /// Runs it to its end. Its exit status.
    int run(const std::string& environment, const std::string& arguments)
    {
        const std::string home = (mDirectory / "home").string();
        const int status = std::system(("XDG_CONFIG_HOME='" + home + "' XDG_CACHE_HOME='" + home + "' " + environment
                                        + " timeout 60 '" LODSMITH_EDITOR "' " + arguments + " > '"
                                        + (mDirectory / "output").string() + "' 2>&1")
                                           .c_str());
        return WEXITSTATUS(status);
    }

    std::string output() const { return contentOf(mDirectory / "output"); }

    fs::path script(const std::string& text)
    {
        std::ofstream(mDirectory / "script.lua") << text;
        return mDirectory / "script.lua";
    }

    TestDirectory mDirectory;
};

TEST_F(StartTest, SaysSoWhenThereIsNoDisplay)
{
    EXPECT_EQ(run("DISPLAY=", ""), 1);
    EXPECT_THAT(output(), HasSubstr("lodsmith-editor: there is no X display"));
    EXPECT_EQ(run("DISPLAY=:987", ""), 1);
    EXPECT_THAT(output(), HasSubstr("lodsmith-editor: there is no X display"));
}

TEST_F(StartTest, EndsWithTheScriptThatAsksForIt)
{
    const VirtualDisplay display;
    EXPECT_EQ(run("", "--script '" + script("coroutine.yield() lodsmith.editor:quit(7)").string() + "'"), 7);
    EXPECT_EQ(run("", "--script '" + script("lodsmith.editor:quit()").string() + "'"), 0);
}

TEST_F(StartTest, EndsWithAScriptThatFails)
{
    const VirtualDisplay display;
    EXPECT_EQ(run("", "--script '" + script("coroutine.yield() error('no good')").string() + "'"), 1);
    EXPECT_THAT(output(), HasSubstr("script.lua:1: no good"));
    EXPECT_EQ(run("", "--script '" + script("this is no Lua").string() + "'"), 1);
    EXPECT_THAT(output(), HasSubstr("script.lua"));
    EXPECT_EQ(run("", "--script '" + (mDirectory / "missing.lua").string() + "'"), 1);
    EXPECT_THAT(output(), HasSubstr("missing.lua"));
}

TEST_F(StartTest, GoesOnWhenItsSettingsAreSpoilt)
{
    const VirtualDisplay display;
    fs::create_directories(mDirectory / "home/lodsmith");
    std::ofstream(mDirectory / "home/lodsmith/editor.json") << "spoilt";
    EXPECT_EQ(run("", "--script '" + script("lodsmith.editor:quit()").string() + "'"), 0);
    EXPECT_THAT(output(), HasSubstr("editor.json: not the editor's settings"));
}

} // namespace
} // namespace lodsmith::test
