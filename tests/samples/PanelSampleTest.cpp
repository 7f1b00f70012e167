#include "Game.h"
#include "GameWindow.h"

#include <support/TestDirectory.h>
#include <support/VirtualDisplay.h>

#include <CEGUI/CEGUI.h>
#include <OgreMeshManager.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <functional>
#include <optional>
#include <vector>

#include <sys/wait.h>

namespace fs = std::filesystem;

namespace lodsmith::test {
namespace {

using samples::Engine;
using samples::Game;
using samples::GameOptions;
using samples::GameWindow;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr const char* kPanel = "AssetsManagerFrame";
constexpr const char* kQuestion = "Question";

// One level that every tree shows at any distance.
constexpr const char* kReduceTrees = R"(
    local panel = lodsmith.panel
    for _, mesh in ipairs(lodsmith.meshes()) do
        if mesh:name() == "tree.mesh" then
            assert(panel:chooseMesh(mesh))
        end
    end
    assert(panel.state:setAutomatic(false))
    assert(panel.state:setStrategy(lodsmith.Strategy.PixelCount))
    assert(panel.state:addLevel("1000000000"))
    assert(panel.state:setMethod(lodsmith.Method.Proportional))
    assert(panel.state:setAmount("0.95"))
)";

using Pixels = std::vector<Ogre::uint8>;

/// The game with a window on a screen of its own.
struct Session {
    explicit Session(const GameOptions& options) : window(options.width, options.height)
    {
        engine.start(LODSMITH_PLUGINS_DIR "/plugins.cfg");
        target = &window.attach(engine.root());
        game.emplace(engine, *target, options);
    }

    VirtualDisplay display;
    GameWindow window;
    Engine engine;
    Ogre::RenderWindow* target = nullptr;
    std::optional<Game> game;
};

class PanelInGameTest : public testing::Test {
protected:
    void SetUp() override
    {
        if (!VirtualDisplay::isAvailable())
            GTEST_SKIP() << "Xvfb is not installed";
        GameOptions options;
        options.objects = 20;
        options.width = 1024;
        options.height = 768;
        mSession.emplace(options);
        press(SDLK_F2); // so that the panel is all that changes the picture
        frames(2);
    }

    Game& game() { return *mSession->game; }
    CEGUI::Window& root() { return game().gui().root(); }
    CEGUI::FrameWindow& panelWindow() { return dynamic_cast<CEGUI::FrameWindow&>(*root().getChild(kPanel)); }

    /// With the next frame.
    static void press(SDL_Keycode key)
    {
        SDL_Event event = {};
        event.type = SDL_KEYDOWN;
        event.key.keysym.sym = key;
        SDL_PushEvent(&event);
        event.type = SDL_KEYUP;
        SDL_PushEvent(&event);
    }

    static void mouse(Uint32 type, int x, int y)
    {
        SDL_Event event = {};
        event.type = type;
        if (type == SDL_MOUSEMOTION) {
            event.motion.x = x;
            event.motion.y = y;
        } else {
            event.button.button = SDL_BUTTON_LEFT;
        }
        SDL_PushEvent(&event);
    }

    /// False when the game has ended.
    bool frames(int count)
    {
        bool isGoing = true;
        for (int i = 0; i < count; ++i)
            isGoing = game().drawFrame();
        return isGoing;
    }

    bool drawUntil(const std::function<bool()>& condition)
    {
        for (const auto start = std::chrono::steady_clock::now();
             std::chrono::steady_clock::now() - start < std::chrono::seconds(60);) {
            if (condition())
                return true;
            frames(1);
        }
        return false;
    }

    /// Empty when all went well, else the message.
    std::string run(const std::string& code)
    {
        lua_State* const state = &game().gui().lua();
        if (luaL_dostring(state, code.c_str()) == 0)
            return "";
        std::string message = lua_tostring(state, -1);
        lua_pop(state, 1);
        return message;
    }

    Pixels picture()
    {
        Ogre::RenderWindow& target = *mSession->target;
        Pixels pixels(std::size_t(3) * target.getWidth() * target.getHeight());
        const Ogre::Box all(0, 0, target.getWidth(), target.getHeight());
        target.copyContentsToMemory(all, Ogre::PixelBox(all, Ogre::PF_BYTE_RGB, pixels.data()));
        return pixels;
    }

    std::size_t triangles() { return mSession->target->getStatistics().triangleCount; }

    std::optional<Session> mSession;
};

/// Whether it has the level of kReduceTrees, and that alone.
bool isReduced(const Ogre::Mesh& mesh)
{
    return mesh.getNumLodLevels() == 2 && mesh.getLodLevel(1).userValue > 1e8f;
}

/// The share of numbers that are not the same.
double difference(const Pixels& a, const Pixels& b)
{
    std::size_t different = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        different += a[i] != b[i] ? 1 : 0;
    return double(different) / double(a.size());
}

TEST_F(PanelInGameTest, OpensOverTheSceneAndLeavesIt)
{
    const Pixels without = picture();
    press(SDLK_F1);
    frames(3);
    ASSERT_TRUE(game().panel().isOpen());
    ASSERT_TRUE(root().isChild(kPanel));
    EXPECT_TRUE(panelWindow().isEffectiveVisible());
    EXPECT_GT(difference(without, picture()), 0.5);
    press(SDLK_F1);
    frames(3);
    EXPECT_FALSE(game().panel().isOpen());
    EXPECT_FALSE(root().isChild(kPanel));
    // The figures in the corner, and models that move.
    EXPECT_LT(difference(without, picture()), 0.1);
}

TEST_F(PanelInGameTest, OpensAgainAndAgain)
{
    for (int time = 0; time < 10; ++time) {
        press(SDLK_F1);
        frames(2);
        ASSERT_TRUE(root().isChild(kPanel)) << "time " << time;
        EXPECT_EQ(run("assert(lodsmith.panel.window and lodsmith.preview)"), "");
        EXPECT_EQ(run("assert(lodsmith.panel:chooseMesh(lodsmith.meshes()[1]))"), "");
        frames(1);
        press(SDLK_F1);
        frames(2);
        ASSERT_FALSE(root().isChild(kPanel)) << "time " << time;
        EXPECT_EQ(run("assert(lodsmith.panel == nil and lodsmith.preview == nil)"), "");
    }
    EXPECT_FALSE(root().isChild(kQuestion));
}

TEST_F(PanelInGameTest, TheGamesOwnScriptGoesOn)
{
    press(SDLK_F1);
    frames(1);
    game().gui().showFigures(12, 345678);
    EXPECT_THAT(root().getChild("Hud")->getText().c_str(), HasSubstr("345678 triangles"));
    press(SDLK_F1);
    frames(1);
    game().gui().showFigures(12, 876543);
    EXPECT_THAT(root().getChild("Hud")->getText().c_str(), HasSubstr("876543 triangles"));
}

TEST_F(PanelInGameTest, IsMovedByItsTitle)
{
    press(SDLK_F1);
    frames(2);
    const auto corner = [&] { return panelWindow().getUnclippedOuterRect().get().getPosition(); };
    const auto before = corner();
    const CEGUI::Rectf title = panelWindow().getTitlebar()->getUnclippedOuterRect().get();
    const int x = int(title.left() + 60), y = int((title.top() + title.bottom()) / 2);
    mouse(SDL_MOUSEMOTION, x, y);
    mouse(SDL_MOUSEBUTTONDOWN, x, y);
    mouse(SDL_MOUSEMOTION, x + 25, y + 40);
    mouse(SDL_MOUSEBUTTONUP, x + 25, y + 40);
    frames(2);
    const auto moved = corner() - before;
    EXPECT_NEAR(moved.d_x, 25, 1);
    EXPECT_NEAR(moved.d_y, 40, 1);
}

TEST_F(PanelInGameTest, IsClosedByItsButton)
{
    press(SDLK_F1);
    frames(2);
    const CEGUI::Rectf button = panelWindow().getCloseButton()->getUnclippedOuterRect().get();
    const int x = int((button.left() + button.right()) / 2), y = int((button.top() + button.bottom()) / 2);
    mouse(SDL_MOUSEMOTION, x, y);
    mouse(SDL_MOUSEBUTTONDOWN, x, y);
    mouse(SDL_MOUSEBUTTONUP, x, y);
    frames(2);
    EXPECT_FALSE(game().panel().isOpen());
    press(SDLK_F1);
    frames(1);
    EXPECT_TRUE(game().panel().isOpen());
}

TEST_F(PanelInGameTest, EditedLevelsAreSeenInTheScene)
{
    const auto tree = Ogre::MeshManager::getSingleton().getByName("tree.mesh", Ogre::RGN_DEFAULT);
    ASSERT_TRUE(drawUntil([&] { return tree->getNumLodLevels() > 1; })) << "the game's own levels";
    // With the panel, which is made of triangles too.
    press(SDLK_F1);
    frames(2);
    const std::size_t before = triangles();
    ASSERT_EQ(run(kReduceTrees), "");
    EXPECT_TRUE(drawUntil([&] { return isReduced(*tree); }));
    frames(2);
    EXPECT_LT(triangles(), before);
}

TEST_F(PanelInGameTest, LevelsThatAreNotSavedGoWithThePanel)
{
    const auto tree = Ogre::MeshManager::getSingleton().getByName("tree.mesh", Ogre::RGN_DEFAULT);
    press(SDLK_F1);
    frames(1);
    ASSERT_EQ(run(kReduceTrees), "");
    ASSERT_TRUE(drawUntil([&] { return isReduced(*tree); }));
    ASSERT_EQ(run("lodsmith.panel:close()"), "");
    EXPECT_TRUE(drawUntil([&] { return !isReduced(*tree) && tree->getNumLodLevels() > 1; })) << "automatic ones";
}

TEST_F(PanelInGameTest, AsksAboutUnsavedChanges)
{
    press(SDLK_F1);
    frames(1);
    ASSERT_EQ(run(kReduceTrees), "");
    press(SDLK_F1);
    frames(1);
    EXPECT_TRUE(game().panel().isOpen());
    ASSERT_TRUE(root().isChild(kQuestion));
    EXPECT_TRUE(root().getChild(kQuestion)->isVisible());
    SDL_Event quit = {};
    quit.type = SDL_QUIT;
    SDL_PushEvent(&quit);
    EXPECT_TRUE(frames(1)) << "the answer is waited for";
    press(SDLK_ESCAPE);
    EXPECT_TRUE(frames(2));
    EXPECT_TRUE(game().panel().isOpen());
    EXPECT_FALSE(root().getChild(kQuestion)->isVisible());
    press(SDLK_F1);
    frames(1);
    EXPECT_EQ(run("lodsmith.panel.question:answer('discard')"), "");
    frames(1);
    EXPECT_FALSE(game().panel().isOpen());
    SDL_PushEvent(&quit);
    EXPECT_FALSE(frames(1));
}

/// The program, from its command line to its end.
class PanelSampleTest : public testing::Test {
protected:
    void SetUp() override
    {
        if (!VirtualDisplay::isAvailable())
            GTEST_SKIP() << "Xvfb is not installed";
    }

    /// Its exit status.
    int run(const std::string& arguments, const std::string& environment = "")
    {
        const int status = std::system((environment + " timeout 120 '" LODSMITH_PANEL_SAMPLE "' --objects 20 "
                                        + arguments + " > '" + (mDirectory / "output").string() + "' 2>&1")
                                           .c_str());
        return WEXITSTATUS(status);
    }

    std::string output() const { return contentOf(mDirectory / "output"); }

    TestDirectory mDirectory;
};

TEST_F(PanelSampleTest, DrawsItsFramesAndAPictureOfTheLast)
{
    const VirtualDisplay display;
    const fs::path with = mDirectory / "with.png", without = mDirectory / "without.png";
    const std::string size = "--width 1024 --height 768 --frames 5 --screenshot ";
    EXPECT_EQ(run(size + "'" + without.string() + "'"), 0);
    EXPECT_THAT(output(), IsEmpty());
    EXPECT_EQ(run(size + "'" + with.string() + "' --open-panel"), 0);
    EXPECT_THAT(output(), IsEmpty());
    EXPECT_THAT(contentOf(with), HasSubstr("PNG"));
    EXPECT_THAT(contentOf(without), HasSubstr("PNG"));
    EXPECT_NE(contentOf(with), contentOf(without));
}

TEST_F(PanelSampleTest, SaysWhatIsWrong)
{
    EXPECT_EQ(run("--frames 2", "DISPLAY="), 1);
    EXPECT_THAT(output(), HasSubstr("lodsmith_panel_sample: there is no X display"));
    const VirtualDisplay display;
    EXPECT_EQ(run("--frames 2 --open-panel", "LODSMITH_GUI_DIR=" + mDirectory.path().string()), 0)
        << "the game goes on without the panel";
    EXPECT_THAT(output(), HasSubstr("the panel's scripts are not there"));
    EXPECT_EQ(run("--frames 2 --screenshot '" + (mDirectory / "missing/picture.png").string() + "'"), 1);
    EXPECT_THAT(output(), HasSubstr("lodsmith_panel_sample: "));
}

} // namespace
} // namespace lodsmith::test
