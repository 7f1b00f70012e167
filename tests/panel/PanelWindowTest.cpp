#include "PreviewFixture.h"

#include <lodsmith/ogre/LodDefinitionManager.h>
#include <lodsmith/ogre/LodManager.h>
#include <lodsmith/ogre/QueuedProgressiveMeshGenerator.h>
#include <lodsmith/panel/AssetsManagerPanel.h>

#include <CEGUI/CEGUI.h>
#include <CEGUI/RendererModules/Ogre/Renderer.h>
#include <CEGUI/ScriptModules/Lua/ScriptModule.h>

#include <OgreRenderTarget.h>
#include <OgreResourceGroupManager.h>
#include <OgreViewport.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <lua.hpp>

#include <utility>

namespace lodsmith::test {
namespace {

/// The panel in a program with a window.
class PanelWindowTest : public testing::Test {
protected:
    void SetUp() override
    {
        if (!VirtualDisplay::isAvailable())
            GTEST_SKIP() << "Xvfb is not installed";
        mSession = std::make_unique<RenderSession>(1024, 768);
        mDefinitions = std::make_unique<LodDefinitionManager>();
        mQueue = std::make_unique<QueuedProgressiveMeshGenerator>();
        mManager = std::make_unique<LodManager>(*mDefinitions, *mQueue);
        startGui();
    }

    void TearDown() override
    {
        mPanel.reset();
        if (mScripts) {
            CEGUI::OgreRenderer::destroySystem();
            CEGUI::LuaScriptModule::destroy(*mScripts);
        }
        mManager.reset();
        mQueue.reset();
        mDefinitions.reset();
    }

    void startGui()
    {
        CEGUI::OgreRenderer::bootstrapSystem(*mSession->viewport().getTarget());
        mScripts = &CEGUI::LuaScriptModule::create();
        CEGUI::System::getSingleton().setScriptingModule(mScripts);
        for (const std::string group : {"schemes", "imagesets", "fonts", "looknfeel"})
            Ogre::ResourceGroupManager::getSingleton().addResourceLocation(LODSMITH_CEGUI_DATA_DIR "/" + group,
                                                                           "FileSystem", group);
        CEGUI::ImageManager::setImagesetDefaultResourceGroup("imagesets");
        CEGUI::Font::setDefaultResourceGroup("fonts");
        CEGUI::WidgetLookManager::setDefaultResourceGroup("looknfeel");
        CEGUI::SchemeManager::getSingleton().createFromFile("TaharezLook.scheme", "schemes");
        CEGUI::FontManager::getSingleton().createFromFile("DejaVuSans-10-NoScale.font", "fonts");
        auto& context = CEGUI::System::getSingleton().getDefaultGUIContext();
        context.setDefaultFont("DejaVuSans-10-NoScale");
        context.setRootWindow(CEGUI::WindowManager::getSingleton().createWindow("DefaultWindow", "root"));
    }

    void open()
    {
        PanelHost host{mScripts->getLuaState(), nullptr, *mDefinitions, *mManager, *mQueue};
        host.fillsParent = host.canOpen = true;
        auto panel = AssetsManagerPanel::open(host);
        ASSERT_TRUE(panel) << describe(panel.error());
        mPanel = std::move(panel).value();
        ASSERT_TRUE(mPanel->preview());
    }

    void frames(int count)
    {
        for (int i = 0; i < count; ++i) {
            mPanel->update(0.1f);
            mSession->frame();
        }
    }

    /// Runs Lua. Empty when all went well, else the message.
    std::string run(const std::string& code)
    {
        lua_State* state = mScripts->getLuaState();
        if (luaL_dostring(state, code.c_str()) == 0)
            return "";
        std::string message = lua_tostring(state, -1);
        lua_pop(state, 1);
        return message;
    }

    std::unique_ptr<RenderSession> mSession;
    std::unique_ptr<LodDefinitionManager> mDefinitions;
    std::unique_ptr<QueuedProgressiveMeshGenerator> mQueue;
    std::unique_ptr<LodManager> mManager;
    CEGUI::LuaScriptModule* mScripts = nullptr;
    std::unique_ptr<AssetsManagerPanel> mPanel;
};

TEST_F(PanelWindowTest, ShowsTheMeshThatIsOpened)
{
    open();
    frames(2);
    const Picture before = mSession->picture();
    ASSERT_EQ(run("assert(lodsmith.panel:openMesh('" LODSMITH_MEDIA_DIR "/cottage/cottage.mesh'))"), "");
    frames(3);
    mQueue->injector().finishAll();
    frames(3);
    const Picture shown = mSession->picture();
    keep(shown, "panel");
    EXPECT_GT(differences(before, shown), 10000u);
    ASSERT_TRUE(mPanel->preview()->mesh());
    EXPECT_EQ(mPanel->preview()->mesh()->getName(), "cottage.mesh");
    EXPECT_GT(mPanel->preview()->triangles(), 1000u);
    EXPECT_TRUE(mPanel->isOpen());
}

TEST_F(PanelWindowTest, PreviewBelongsToThePanel)
{
    open();
    EXPECT_EQ(run("kept = lodsmith.preview; assert(kept:image())"), "");
    const std::string image = mPanel->preview()->texture()->getName();
    EXPECT_TRUE(CEGUI::ImageManager::getSingleton().isDefined(image));
    mPanel.reset();
    EXPECT_FALSE(CEGUI::ImageManager::getSingleton().isDefined(image));
    EXPECT_EQ(run(R"(
        assert(lodsmith.preview == nil)
        for _, name in ipairs({"clear", "mesh", "image", "legend", "distance", "animations", "redraw"}) do
            local none, message = kept[name](kept)
            assert(none == nil and message == "the preview is gone", name)
        end
        assert(select(2, kept:resize(1, 1)) == "the preview is gone")
    )"),
              "");
    open();
    EXPECT_EQ(run("assert(lodsmith.preview:image()) assert(not kept:image())"), "");
}

TEST_F(PanelWindowTest, ScriptsHaveAllOfThePreview)
{
    open();
    EXPECT_EQ(run(R"(
        local preview, View, Compare = lodsmith.preview, lodsmith.ViewMode, lodsmith.CompareMode
        local function refused(word, value, message)
            assert(value == nil and message:find(word, 1, true), message)
        end
        assert(preview:mesh() == nil and #preview:animations() == 0)
        local mesh = assert(lodsmith.openMesh(")" LODSMITH_MEDIA_DIR R"(/drake/drake.mesh"))
        assert(preview:show(mesh) and preview:mesh():equals(mesh))
        assert(not pcall(preview.show, preview, "drake"))
        assert(preview:setMode(View.Flat) and preview:mode() == View.Flat)
        refused("ViewMode", preview:setMode(17))
        refused("ViewMode", preview:setMode(0.5))
        assert(preview:setLevel(2) and preview:setLevel(nil) and preview:setLevel())
        refused("no level", preview:setLevel(-1))
        refused("no level", preview:setLevel(0/0))
        assert(preview:compare(Compare.Wipe, 0, 1, 0.25) and preview:compareMode() == Compare.Wipe)
        refused("share", preview:compare(Compare.Wipe, 0, 1, 2))
        refused("CompareMode", preview:compare(9, 0, 1))
        refused("no level", preview:compare(Compare.Wipe, 0.5, 1))
        assert(preview:compare(Compare.Off))
        local distance = preview:distance()
        assert(preview:zoom(-3) and preview:distance() > distance)
        assert(preview:orbit(5, 6) and preview:pan(7, 8) and preview:resetCamera())
        assert(math.abs(preview:distance() - distance) < 1e-3)
        assert(preview:viewAt(lodsmith.Strategy.DistanceSphere, 100) and preview:distance() > 90)
        refused("Strategy", preview:viewAt(4, 100))
        refused("above 0", preview:viewAt(lodsmith.Strategy.PixelCount, 0))
        local name = preview:animations()[1]
        assert(preview:play(name) and preview:animation() == name and preview:setSpeed(2))
        refused("no animation", preview:play("none"))
        assert(preview:play(nil) and preview:animation() == nil and preview:play(name) and preview:play())
        assert(preview:resize(300, 200) and preview:resize(-1, 0/0))
        assert(preview:note() == "" and preview:deviationScale() == nil)
        assert(type(preview:legend()) == "string" and preview:triangles() == 0 and preview:shownLevel() == 0)
        assert(preview:redraw() and preview:clear() and preview:mesh() == nil)
    )"),
              "");
    frames(1);
}

TEST_F(PanelWindowTest, IsBusyWhileSomethingMovesOrIsMeasured)
{
    open();
    ASSERT_EQ(
        run("mesh = assert(lodsmith.openMesh('" LODSMITH_MEDIA_DIR "/drake/drake.mesh')) lodsmith.preview:show(mesh)"),
        "");
    MeshPreview& preview = *mPanel->preview();
    EXPECT_FALSE(mPanel->isBusy());
    ASSERT_TRUE(preview.play(preview.animations().front()));
    EXPECT_TRUE(mPanel->isBusy());
    preview.setSpeed(0);
    EXPECT_FALSE(mPanel->isBusy());
}

} // namespace
} // namespace lodsmith::test
