#include "PanelProgram.h"

#include <CEGUI/CEGUI.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>
#include <utility>
#include <vector>

namespace lodsmith::test {
namespace {

using testing::HasSubstr;

constexpr const char* kLayout = R"(<?xml version="1.0" encoding="UTF-8"?>
<GUILayout version="4"><Window type="Lodsmith/Button" name="Stub"/></GUILayout>)";

// A panel of one button.
constexpr const char* kScript = R"(
closed, told = 0, {}
return {open = function(options)
    local panel = {window = CEGUI.WindowManager:getSingleton():loadLayoutFromFile("Stub.layout"), options = options, updates = 0}
    options.parent:addChild(panel.window)
    function panel:update(seconds)
        if isBroken then error("broken update") end
        self.updates, self.seconds = self.updates + 1, seconds
    end
    function panel:close()
        if self.window then CEGUI.WindowManager:getSingleton():destroyWindow(self.window) end
        self.window, closed = nil, closed + 1
    end
    lodsmith.panel = panel
    lodsmith.onError = function(message) table.insert(told, message) end
    return panel
end})";

class AssetsManagerPanelTest : public testing::Test {
protected:
    AssetsManagerPanelTest()
    {
        mDirectory.write("AssetsManager.lua", kScript);
        mDirectory.write("Stub.layout", kLayout);
    }

    PanelHost host()
    {
        PanelHost host = mProgram.host();
        host.directory = mDirectory.path();
        return host;
    }

    std::unique_ptr<AssetsManagerPanel> open(const PanelHost& where)
    {
        auto panel = AssetsManagerPanel::open(where);
        EXPECT_TRUE(panel) << describe(panel.error());
        return panel ? std::move(panel).value() : nullptr;
    }

    Error errorOf(const PanelHost& where)
    {
        const auto panel = AssetsManagerPanel::open(where);
        EXPECT_FALSE(panel);
        return panel ? Error{} : panel.error();
    }

    PanelProgram mProgram;
    TestDirectory mDirectory;
};

TEST_F(AssetsManagerPanelTest, OpensInItsParentWithItsSkin)
{
    const auto panel = open(host());
    ASSERT_TRUE(panel);
    EXPECT_TRUE(panel->isOpen());
    EXPECT_EQ(panel->preview(), nullptr) << "nothing can be drawn here";
    EXPECT_EQ(mProgram.root().getChild("Stub")->getType(), "Lodsmith/Button");
    EXPECT_EQ(mProgram.root().getChild("Stub")->getLookNFeel(), "TaharezLook/Button");
    EXPECT_EQ(mProgram.evaluate("lodsmith.panel.options.fill"), "false");
    EXPECT_EQ(mProgram.evaluate("lodsmith.panel.options.preview"), "nil");
    EXPECT_EQ(mProgram.evaluate("lodsmith.panel.options.host.canOpen"), "false");
    EXPECT_EQ(mProgram.evaluate("lodsmith.manager:automatic()"), "true");
    EXPECT_EQ(mProgram.evaluate("lodsmith.ViewMode.Deviation"), "4");
    EXPECT_EQ(mProgram.evaluate("lodsmith.CompareMode.Wipe"), "2");
}

TEST_F(AssetsManagerPanelTest, OtherSkin)
{
    CEGUI::SchemeManager::getSingleton().createFromFile("WindowsLook.scheme");
    PanelHost where = host();
    where.skin = "WindowsLook";
    const auto panel = open(where);
    ASSERT_TRUE(panel);
    EXPECT_EQ(mProgram.root().getChild("Stub")->getLookNFeel(), "WindowsLook/Button");
}

TEST_F(AssetsManagerPanelTest, ScriptsReachTheHost)
{
    std::vector<std::string> opened;
    PanelHost where = host();
    where.fillsParent = where.canOpen = true;
    where.recentFiles = [] { return std::vector<std::string>{"/a/b.mesh", "/c.mesh"}; };
    where.opened = [&](const std::string& path) { opened.push_back(path); };
    const auto panel = open(where);
    ASSERT_TRUE(panel);
    EXPECT_EQ(mProgram.evaluate("lodsmith.panel.options.fill"), "true");
    EXPECT_EQ(mProgram.run("host = lodsmith.panel.options.host"), "");
    EXPECT_EQ(mProgram.evaluate("host.canOpen"), "true");
    EXPECT_EQ(mProgram.evaluate("table.concat(host.recentFiles(), ' ')"), "/a/b.mesh /c.mesh");
    EXPECT_EQ(mProgram.run("host.opened('/d.mesh')"), "");
    EXPECT_THAT(opened, testing::ElementsAre("/d.mesh"));
    EXPECT_THAT(mProgram.run("host.opened()"), HasSubstr("string expected"));
}

TEST_F(AssetsManagerPanelTest, HostThatThrowsIsAnErrorInLua)
{
    PanelHost where = host();
    where.recentFiles = []() -> std::vector<std::string> { throw std::runtime_error("no list"); };
    const auto panel = open(where);
    ASSERT_TRUE(panel);
    EXPECT_EQ(mProgram.evaluate("select(2, lodsmith.panel.options.host.recentFiles())"), "no list");
}

TEST_F(AssetsManagerPanelTest, UpdatesReachTheScript)
{
    const auto panel = open(host());
    ASSERT_TRUE(panel);
    panel->update(0.25f);
    panel->update(0.5f);
    EXPECT_EQ(mProgram.evaluate("lodsmith.panel.updates"), "2");
    EXPECT_EQ(mProgram.evaluate("lodsmith.panel.seconds"), "0.5");
    EXPECT_FALSE(panel->isBusy());
}

TEST_F(AssetsManagerPanelTest, ErrorInAScriptIsToldOnceAndThePanelLivesOn)
{
    const auto panel = open(host());
    ASSERT_TRUE(panel);
    EXPECT_EQ(mProgram.run("isBroken = true"), "");
    panel->update(0);
    panel->update(0);
    EXPECT_EQ(mProgram.evaluate("#told"), "1");
    EXPECT_THAT(mProgram.evaluate("told[1]"), HasSubstr("broken update"));
    EXPECT_EQ(mProgram.run("isBroken = false"), "");
    panel->update(0);
    EXPECT_EQ(mProgram.evaluate("lodsmith.panel.updates"), "1");
}

TEST_F(AssetsManagerPanelTest, LeavesNothingBehind)
{
    const std::string loaders = mProgram.evaluate("#package.loaders");
    const CEGUI::String group = CEGUI::WindowManager::getDefaultResourceGroup();
    auto panel = open(host());
    ASSERT_TRUE(panel);
    EXPECT_EQ(mProgram.evaluate("#package.loaders"), loaders);
    EXPECT_EQ(CEGUI::WindowManager::getDefaultResourceGroup(), group);
    EXPECT_EQ(mProgram.run("host = lodsmith.panel.options.host; kept = lodsmith.manager"), "");
    panel.reset();
    EXPECT_EQ(mProgram.evaluate("closed"), "1");
    EXPECT_EQ(mProgram.evaluate("lodsmith.panel"), "nil");
    EXPECT_FALSE(mProgram.root().isChild("Stub"));
    EXPECT_EQ(mProgram.evaluate("#host.recentFiles()"), "0");
    EXPECT_EQ(mProgram.run("host.opened('/a.mesh')"), "");
    EXPECT_THAT(mProgram.evaluate("select(2, kept:automatic())"), HasSubstr("gone"));
    panel = open(host());
    ASSERT_TRUE(panel);
    EXPECT_TRUE(panel->isOpen());
}

TEST_F(AssetsManagerPanelTest, ClosedByTheArtist)
{
    auto panel = open(host());
    ASSERT_TRUE(panel);
    EXPECT_EQ(mProgram.run("lodsmith.panel:close()"), "");
    EXPECT_FALSE(panel->isOpen());
    panel->update(0);
    panel.reset();
    EXPECT_EQ(mProgram.evaluate("closed"), "2");
}

TEST_F(AssetsManagerPanelTest, WhatTheHostLacksIsSaid)
{
    PanelHost noLua = host();
    noLua.lua = nullptr;
    EXPECT_EQ(errorOf(noLua).code, ErrorCode::InvalidSetting);
    PanelHost noSkin = host();
    noSkin.skin = "NoSuchLook";
    EXPECT_EQ(errorOf(noSkin).code, ErrorCode::NotFound);
    EXPECT_THAT(errorOf(noSkin).message, HasSubstr("NoSuchLook"));
    PanelHost noScripts = host();
    noScripts.directory = mDirectory.path() / "nowhere";
    EXPECT_EQ(errorOf(noScripts).code, ErrorCode::NotFound);
    EXPECT_EQ(mProgram.run("keptCEGUI, CEGUI = CEGUI, nil"), "");
    EXPECT_THAT(describe(errorOf(host())), HasSubstr("script module"));
    EXPECT_EQ(mProgram.run("CEGUI = keptCEGUI"), "");
    CEGUI::System::getSingleton().getDefaultGUIContext().setRootWindow(nullptr);
    PanelHost noWindow = host();
    noWindow.parent = nullptr;
    EXPECT_EQ(errorOf(noWindow).code, ErrorCode::NotFound);
    EXPECT_TRUE(AssetsManagerPanel::open(host()));
}

TEST_F(AssetsManagerPanelTest, BrokenScriptsAreErrors)
{
    const std::pair<const char*, const char*> scripts[] = {
        {"return {open = ", "unexpected symbol"},
        {"error('on loading')", "on loading"},
        {"return {open = function() error('on opening') end}", "on opening"},
        {"return {open = function() return 7 end}", "table expected"},
        {"return {}", "call"},
        {"return {open = function() CEGUI.WindowManager:getSingleton():loadLayoutFromFile('none.layout') end}",
         "none.layout"},
    };
    for (const auto& [script, message] : scripts) {
        EXPECT_EQ(mProgram.run("package.loaded['lodsmith.gui.AssetsManager'] = nil"), "");
        mDirectory.write("AssetsManager.lua", script);
        const Error error = errorOf(host());
        EXPECT_EQ(error.code, ErrorCode::BadFile) << script;
        EXPECT_THAT(error.message, HasSubstr(message));
        EXPECT_EQ(mProgram.evaluate("lodsmith.panel"), "nil");
    }
}

TEST_F(AssetsManagerPanelTest, GraphsBelongToLua)
{
    const auto panel = open(host());
    ASSERT_TRUE(panel);
    EXPECT_EQ(mProgram.run(R"(
        local graph = assert(lodsmith.newGraph("scripted"))
        assert(graph:image() == "scripted" and graph:margin() > 0)
        assert(graph:resize(120, 40))
        assert(graph:setCurve({{0, 0}, {x = 0.5, y = 0.7}, {1, 1}}))
        assert(graph:setMarkers({{0.5, 0.7, selected = true}, {1, 1}}))
        assert(graph:setTicks({0.25, 0.5}, {}))
        assert(graph:draw())
        local none, message = graph:setCurve({{0, 0}, {1}})
        assert(none == nil and message:find("item 2"), message)
        none, message = graph:setTicks({"x"}, {})
        assert(none == nil and message:find("item 1"), message)
        assert(not pcall(graph.setCurve, graph, "no table"))
        assert(not pcall(graph.resize, graph, "wide", 1))
        none, message = lodsmith.newGraph("scripted")
        assert(none == nil and message:find("already"), message)
        assert(graph:resize(-5, 0/0) and graph:draw())
    )"),
              "");
    EXPECT_TRUE(CEGUI::ImageManager::getSingleton().isDefined("scripted"));
    EXPECT_EQ(mProgram.run("collectgarbage() collectgarbage()"), "");
    EXPECT_FALSE(CEGUI::ImageManager::getSingleton().isDefined("scripted"));
}

TEST_F(AssetsManagerPanelTest, ASecondOneIsRefusedAndTheFirstGoesOn)
{
    const auto panel = open(host());
    ASSERT_TRUE(panel);
    EXPECT_THAT(errorOf(host()).message, HasSubstr("open panel"));
    EXPECT_TRUE(panel->isOpen());
    EXPECT_EQ(mProgram.evaluate("lodsmith.queue:queued()"), "0");
    EXPECT_EQ(mProgram.run("assert(lodsmith.manager:automatic() ~= nil)"), "");
}

TEST_F(AssetsManagerPanelTest, WhatCeguiThrowsIsAnErrorOfLuas)
{
    const auto panel = open(host());
    ASSERT_TRUE(panel);
    // As often as would fill Lua's stack of calls if each left something on it.
    EXPECT_EQ(mProgram.run(R"(
        local root = CEGUI.System:getSingleton():getDefaultGUIContext():getRootWindow()
        for _ = 1, 300 do
            local ok, message = pcall(root.setProperty, root, "NoSuchProperty", "x")
            assert(not ok and message:find("NoSuchProperty"), message)
            assert(not pcall(function() CEGUI.FontManager:getSingleton():get("NoSuchFont") end))
        end
        root:setText("as before")
        assert(root:getText() == "as before")
    )"),
              "");
    panel->update(0.1f);
    EXPECT_TRUE(panel->isOpen());
    // An error in a handler that a call from Lua has set off is that call's.
    EXPECT_EQ(mProgram.run(R"(
        local root = CEGUI.System:getSingleton():getDefaultGUIContext():getRootWindow()
        root:subscribeEvent("TextChanged", function() error("in the handler") end)
        local ok, message = pcall(root.setText, root, "other")
        assert(not ok and message:find("in the handler"), message)
    )"),
              "");
}

TEST_F(AssetsManagerPanelTest, TheRealOneOpensAndRuns)
{
    PanelHost where = mProgram.host();
    where.canOpen = true;
    const auto panel = open(where);
    ASSERT_TRUE(panel);
    EXPECT_TRUE(panel->isOpen());
    // Without its materials, which OGRE cannot load here.
    std::filesystem::copy(LODSMITH_MEDIA_DIR "/cottage/cottage.mesh", mDirectory.path());
    EXPECT_EQ(mProgram.run("assert(lodsmith.panel:openMesh('" + (mDirectory / "cottage.mesh").string() + "'))"), "");
    for (int i = 0; i < 5; ++i)
        panel->update(0.1f);
    EXPECT_TRUE(panel->isOpen());
}

} // namespace
} // namespace lodsmith::test
