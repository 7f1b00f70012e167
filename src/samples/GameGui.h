#pragma once

#include <CEGUI/Logger.h>
#include <OgreRenderWindow.h>
#include <SDL.h>
#include <lua.hpp>

#include <memory>
#include <string>

namespace CEGUI {
class LuaScriptModule;
class Window;
} // namespace CEGUI

namespace lodsmith::samples {

/// What a game has before Lodsmith's panel comes into it: CEGUI with a skin and a font, a Lua state with scripts of its own, and
/// mouse and keyboard. Throws what CEGUI throws.
class GameGui {
public:
    static constexpr const char* kSkin = "TaharezLook";

    explicit GameGui(Ogre::RenderWindow& window);
    ~GameGui();
    GameGui(const GameGui&) = delete;
    GameGui& operator=(const GameGui&) = delete;

    lua_State& lua() { return *mLua; }
    CEGUI::Window& root() { return *mRoot; }

    /// Tells CEGUI what mouse or keyboard did.
    void handle(const SDL_Event& event);
    /// Lets time pass for tooltips, carets and repeated keys.
    void advance(float seconds);
    /// Has the game's script hud.lua show them.
    void showFigures(double framesPerSecond, std::size_t triangles);

private:
    class Log;

    void loadSkin();

    std::unique_ptr<CEGUI::Logger> mLog;
    std::unique_ptr<lua_State, decltype(&lua_close)> mLua;
    CEGUI::LuaScriptModule* mScripts = nullptr;
    CEGUI::Window* mRoot = nullptr;
};

} // namespace lodsmith::samples
