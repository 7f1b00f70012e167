#pragma once

#include <lodsmith/core/Result.h>

#include <CEGUI/Logger.h>
#include <OgreRenderWindow.h>
#include <SDL.h>

#include <memory>
#include <string>

struct lua_State;
namespace CEGUI {
class LuaScriptModule;
class OgreRenderer;
class Window;
} // namespace CEGUI

namespace lodsmith::editor {

/// CEGUI, drawn into OGRE's window, with a skin, a font and a Lua state of its own. Its messages go to OGRE's log.
class Gui {
public:
    static constexpr const char* kSkin = "WindowsLook";

    /// Throws what CEGUI and OGRE throw.
    explicit Gui(Ogre::RenderWindow& window);
    ~Gui();
    Gui(const Gui&) = delete;
    Gui& operator=(const Gui&) = delete;

    lua_State* lua() const;
    CEGUI::Window& root() { return *mRoot; }

    /// Tells CEGUI what mouse or keyboard did. Throws CEGUI::Exception for an error in a handler.
    void handle(const SDL_Event& event);
    void resized(int width, int height);
    /// Lets time pass for tooltips, carets and repeated keys.
    void advance(double seconds);
    /// Whether something of it looks different from what was drawn last.
    bool hasChanged() const;

private:
    class Log;
    class Clipboard;

    void loadSkin();
    void handleKey(const SDL_KeyboardEvent& event);

    std::unique_ptr<CEGUI::Logger> mLog;
    std::unique_ptr<Clipboard> mClipboard;
    CEGUI::OgreRenderer* mRenderer = nullptr;
    CEGUI::LuaScriptModule* mScripts = nullptr;
    CEGUI::Window* mRoot = nullptr;
};

} // namespace lodsmith::editor
