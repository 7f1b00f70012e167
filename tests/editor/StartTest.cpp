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

TEST_F(StartTest, SaysSoWhenItsLogCannotBeWritten)
{
    EXPECT_EQ(run("", "--log '" + (mDirectory / "none" / "log").string() + "'"), 1);
    EXPECT_THAT(output(), HasSubstr("none/log: cannot be written"));
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

TEST_F(StartTest, SaysSoWhenThereIsNoOpenGl)
{
    // Xvfb finds a free display and prints its number.
    const std::string command = "Xvfb -displayfd 1 -extension GLX -nolisten tcp > '" + (mDirectory / "display").string()
                                + "' 2> /dev/null & server=$!; for i in $(seq 100); do [ -s '"
                                + (mDirectory / "display").string() + "' ] && break; sleep 0.1; done; ";
    const int status = std::system((command + "DISPLAY=:$(cat '" + (mDirectory / "display").string()
                                    + "') timeout 60 '" LODSMITH_EDITOR "' > '" + (mDirectory / "output").string()
                                    + "' 2>&1; status=$?; kill $server; exit $status")
                                       .c_str());
    EXPECT_EQ(WEXITSTATUS(status), 1);
    EXPECT_THAT(output(), HasSubstr("lodsmith-editor: the display has no OpenGL"));
}

TEST_F(StartTest, OpensADirectoryAndRemembersTheMesh)
{
    const VirtualDisplay display;
    const fs::path models = mDirectory / "models";
    fs::create_directories(models / "below");
    fs::copy(LODSMITH_MEDIA_DIR "/lantern", models / "below", fs::copy_options::recursive);
    fs::copy(LODSMITH_MEDIA_DIR "/cottage", models, fs::copy_options::recursive);
    const std::string check = "assert(lodsmith.panel.state.mesh:name() == 'lantern.mesh') "
                              "assert(#lodsmith.meshes() == 2) lodsmith.editor:quit()";
    EXPECT_EQ(run("", "--script '" + script(check).string() + "' '" + models.string() + "'"), 0) << output();
    const std::string again =
        "assert(lodsmith.editor:recentFiles()[1]:match('/below/lantern.mesh$')) lodsmith.editor:quit()";
    EXPECT_EQ(run("", "--script '" + script(again).string() + "'"), 0) << output();
}

TEST_F(StartTest, RemembersItsPlace)
{
    const VirtualDisplay display;
    fs::create_directories(mDirectory / "home/lodsmith");
    std::ofstream(mDirectory / "home/lodsmith/editor.json")
        << R"({"recentFiles": [], "window": {"x": 20, "y": 30, "width": 1100, "height": 800, "maximised": false}})";
    const fs::path picture = mDirectory / "picture.png";
    const std::string shoot = "for i = 1, 3 do coroutine.yield() end local size = "
                              "CEGUI.System:getSingleton():getRenderer():getDisplaySize() "
                              "assert(size.width == 1100 and size.height == 800) "
                              "assert(lodsmith.editor:screenshot('"
                              + picture.string() + "')) lodsmith.editor:quit()";
    EXPECT_EQ(run("", "--script '" + script(shoot).string() + "'"), 0) << output();
    EXPECT_THAT(contentOf(picture).substr(0, 8), HasSubstr("PNG"));
    EXPECT_THAT(contentOf(mDirectory / "home/lodsmith/editor.json"), HasSubstr("\"width\": 1100"));
}

TEST_F(StartTest, SurvivesABrokenSkeleton)
{
    const VirtualDisplay display;
    const fs::path models = mDirectory / "models";
    fs::copy(LODSMITH_MEDIA_DIR "/drake", models, fs::copy_options::recursive);
    // The first bone's number, its rest position and what follows.
    std::string skeleton = contentOf(models / "drake.skeleton");
    for (std::size_t at = 60; at < 400; ++at)
        skeleton[at] = char(skeleton[at] ^ 0xff);
    std::ofstream(models / "drake.skeleton", std::ios::binary) << skeleton;
    const std::string check = "assert(lodsmith.panel.state.mesh == nil) "
                              "assert(lodsmith.panel.state.message.text:find('drake.mesh')) lodsmith.editor:quit()";
    EXPECT_EQ(run("", "--script '" + script(check).string() + "' '" + (models / "drake.mesh").string() + "'"), 0)
        << output();
}

TEST_F(StartTest, EndsAtOnceWhenItIsTold)
{
    const VirtualDisplay display;
    const std::string circle = "lodsmith.panel.state.isDirty = function() return true end while true do end";
    EXPECT_EQ(run("timeout -s TERM 5", "--script '" + script(circle).string() + "'"), 124);
}

TEST_F(StartTest, TellsWhatCannotBeOpenedInThePanel)
{
    const VirtualDisplay display;
    std::ofstream(mDirectory / "text.mesh") << "no mesh";
    const std::string check = "assert(lodsmith.panel.state.message.kind == 'error') "
                              "assert(lodsmith.panel.state.message.text:find('text.mesh')) lodsmith.editor:quit()";
    EXPECT_EQ(run("", "--script '" + script(check).string() + "' '" + (mDirectory / "text.mesh").string() + "'"), 0)
        << output();
}

} // namespace
} // namespace lodsmith::test
