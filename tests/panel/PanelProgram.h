#pragma once

#include "NullGui.h"

#include <support/OgreSession.h>
#include <support/TestDirectory.h>

#include <lodsmith/ogre/LodDefinitionManager.h>
#include <lodsmith/ogre/LodManager.h>
#include <lodsmith/ogre/QueuedProgressiveMeshGenerator.h>
#include <lodsmith/panel/AssetsManagerPanel.h>

#include <memory>
#include <string>

namespace CEGUI {
class LuaScriptModule;
class Window;
} // namespace CEGUI

namespace lodsmith::test {

/// A program without a window that has CEGUI, its Lua, and what the panel works on.
class PanelProgram {
public:
    PanelProgram();
    ~PanelProgram();
    PanelProgram(const PanelProgram&) = delete;
    PanelProgram& operator=(const PanelProgram&) = delete;

    /// A window over all of the screen.
    CEGUI::Window& root() { return *mRoot; }
    lua_State* lua();
    /// For the panel in guiDirectory(), within root().
    PanelHost host();

    /// Runs Lua. Empty when all went well, else the message.
    std::string run(const std::string& code);
    /// What an expression gives, as tostring() shows it.
    std::string evaluate(const std::string& expression);

    OgreSession& session() { return mSession; }

private:
    OgreSession mSession;
    LodDefinitionManager mDefinitions;
    QueuedProgressiveMeshGenerator mQueue;
    LodManager mManager;
    std::unique_ptr<NullGui> mGui;
    CEGUI::LuaScriptModule* mScripts;
    CEGUI::Window* mRoot;
};

} // namespace lodsmith::test
