#include "GameGui.h"

#include "../editor/KeyMap.h"

#include <CEGUI/CEGUI.h>
#include <CEGUI/RendererModules/Ogre/Renderer.h>
#include <CEGUI/ScriptModules/Lua/ScriptModule.h>
#include <OgreLogManager.h>
#include <OgreResourceGroupManager.h>

#include <stdexcept>

namespace lodsmith::samples {

namespace {

constexpr const char* kFont = "Jura-13";

CEGUI::GUIContext& context()
{
    return CEGUI::System::getSingleton().getDefaultGUIContext();
}

/// CEGUI's kinds of files are resource groups of OGRE's.
void addResources()
{
    auto& resources = Ogre::ResourceGroupManager::getSingleton();
    for (const std::string group : {"schemes", "imagesets", "fonts", "layouts", "looknfeel"})
        resources.addResourceLocation(LODSMITH_CEGUI_DATA_DIR "/" + group, "FileSystem", group);
    resources.addResourceLocation(LODSMITH_SCRIPT_DIR, "FileSystem", "scripts");
    CEGUI::ImageManager::setImagesetDefaultResourceGroup("imagesets");
    CEGUI::Font::setDefaultResourceGroup("fonts");
    CEGUI::Scheme::setDefaultResourceGroup("schemes");
    CEGUI::WidgetLookManager::setDefaultResourceGroup("looknfeel");
    CEGUI::WindowManager::setDefaultResourceGroup("layouts");
}

lua_State* makeLua()
{
    lua_State* const state = luaL_newstate();
    if (!state)
        throw std::bad_alloc();
    luaL_openlibs(state);
    return state;
}

void handleKey(const SDL_Keysym& key)
{
    context().injectKeyDown(editor::keyFor(key.sym));
    if (!(key.mod & KMOD_CTRL))
        return;
    switch (key.sym) {
    case SDLK_c: context().injectCopyRequest(); break;
    case SDLK_x: context().injectCutRequest(); break;
    case SDLK_v: context().injectPasteRequest(); break;
    default: break;
    }
}

} // namespace

/// CEGUI's warnings and errors go to OGRE's log.
class GameGui::Log : public CEGUI::Logger {
    void logEvent(const CEGUI::String& message, CEGUI::LoggingLevel level) override
    {
        if (level <= CEGUI::Warnings)
            Ogre::LogManager::getSingleton().logWarning(message.c_str());
    }
    void setLogFilename(const CEGUI::String&, bool) override {}
};

GameGui::GameGui(Ogre::RenderWindow& window) : mLog(std::make_unique<Log>()), mLua(makeLua(), &lua_close)
{
    CEGUI::OgreRenderer::bootstrapSystem(window);
    addResources();
    mScripts = &CEGUI::LuaScriptModule::create(mLua.get());
    CEGUI::System::getSingleton().setScriptingModule(mScripts);
    loadSkin();
    mScripts->executeScriptFile("hud.lua", "scripts");
}

GameGui::~GameGui()
{
    CEGUI::OgreRenderer::destroySystem();
    CEGUI::LuaScriptModule::destroy(*mScripts);
}

void GameGui::loadSkin()
{
    const std::string skin = kSkin;
    CEGUI::SchemeManager::getSingleton().createFromFile(skin + ".scheme");
    auto& fonts = CEGUI::FontManager::getSingleton();
    context().setDefaultFont(&fonts.createFromFile(std::string(kFont) + ".font"));
    context().setDefaultTooltipType(skin + "/Tooltip");
    mRoot = CEGUI::WindowManager::getSingleton().createWindow("DefaultWindow", "Game");
    context().setRootWindow(mRoot);
}

void GameGui::handle(const SDL_Event& event)
{
    switch (event.type) {
    case SDL_MOUSEMOTION: context().injectMousePosition(float(event.motion.x), float(event.motion.y)); break;
    case SDL_MOUSEBUTTONDOWN: context().injectMouseButtonDown(editor::buttonFor(event.button.button)); break;
    case SDL_MOUSEBUTTONUP: context().injectMouseButtonUp(editor::buttonFor(event.button.button)); break;
    case SDL_MOUSEWHEEL: context().injectMouseWheelChange(event.wheel.preciseY); break;
    case SDL_KEYDOWN: handleKey(event.key.keysym); break;
    case SDL_KEYUP: context().injectKeyUp(editor::keyFor(event.key.keysym.sym)); break;
    case SDL_TEXTINPUT:
        for (const auto character : CEGUI::String(reinterpret_cast<const CEGUI::utf8*>(event.text.text)))
            context().injectChar(character);
        break;
    default: break;
    }
}

void GameGui::advance(float seconds)
{
    context().injectTimePulse(seconds);
    CEGUI::System::getSingleton().injectTimePulse(seconds);
}

void GameGui::showFigures(double framesPerSecond, std::size_t triangles)
{
    lua_State* const state = mLua.get();
    lua_getglobal(state, "showFigures");
    lua_pushnumber(state, framesPerSecond);
    lua_pushnumber(state, double(triangles));
    if (lua_pcall(state, 2, 0, 0) == 0)
        return;
    const std::string message = lua_tostring(state, -1);
    lua_pop(state, 1);
    throw std::runtime_error(message);
}

} // namespace lodsmith::samples
