#include "Gui.h"

#include "KeyMap.h"

#include <CEGUI/CEGUI.h>
#include <CEGUI/RendererModules/Ogre/Renderer.h>
#include <CEGUI/ScriptModules/Lua/ScriptModule.h>
#include <OgreLogManager.h>
#include <OgreResourceGroupManager.h>

#include <cstring>

namespace lodsmith::editor {

namespace {

/// CEGUI's kinds of files, each a resource group of OGRE's, named as the folder of CEGUI's data it is in.
constexpr const char* kGroups[] = {"schemes", "imagesets", "fonts", "layouts", "looknfeel"};
constexpr const char* kFont = "DejaVuSans-10-NoScale";

void addResources()
{
    auto& resources = Ogre::ResourceGroupManager::getSingleton();
    for (const std::string group : kGroups)
        resources.addResourceLocation(LODSMITH_CEGUI_DATA_DIR "/" + group, "FileSystem", group);
    resources.addResourceLocation(LODSMITH_FONT_DIR, "FileSystem", "fonts");
    CEGUI::ImageManager::setImagesetDefaultResourceGroup("imagesets");
    CEGUI::Font::setDefaultResourceGroup("fonts");
    CEGUI::Scheme::setDefaultResourceGroup("schemes");
    CEGUI::WidgetLookManager::setDefaultResourceGroup("looknfeel");
    CEGUI::WindowManager::setDefaultResourceGroup("layouts");
}

CEGUI::GUIContext& context()
{
    return CEGUI::System::getSingleton().getDefaultGUIContext();
}

bool injectText(const char* text)
{
    bool used = false;
    const CEGUI::String characters(reinterpret_cast<const CEGUI::utf8*>(text));
    for (const CEGUI::String::value_type character : characters)
        used = context().injectChar(character) || used;
    return used;
}

} // namespace

class Gui::Log : public CEGUI::Logger {
    void logEvent(const CEGUI::String& message, CEGUI::LoggingLevel level) override
    {
        if (level > getLoggingLevel())
            return;
        const auto importance = level == CEGUI::Errors     ? Ogre::LML_CRITICAL
                                : level == CEGUI::Warnings ? Ogre::LML_WARNING
                                                           : Ogre::LML_TRIVIAL;
        Ogre::LogManager::getSingleton().logMessage(message.c_str(), importance);
    }
    void setLogFilename(const CEGUI::String&, bool) override {}
};

/// Copies text to other programs, and from them.
class Gui::Clipboard : public CEGUI::NativeClipboardProvider {
    void sendToClipboard(const CEGUI::String&, void* buffer, std::size_t size) override
    {
        SDL_SetClipboardText(std::string(static_cast<const char*>(buffer), size).c_str());
    }

    void retrieveFromClipboard(CEGUI::String& mimeType, void*& buffer, std::size_t& size) override
    {
        char* const text = SDL_GetClipboardText();
        mText = text ? text : "";
        SDL_free(text);
        mimeType = "text/plain";
        buffer = mText.data();
        size = mText.size();
    }

    std::string mText;
};

Gui::Gui(Ogre::RenderWindow& window) : mLog(std::make_unique<Log>()), mClipboard(std::make_unique<Clipboard>())
{
    mRenderer = &CEGUI::OgreRenderer::bootstrapSystem(window);
    addResources();
    mScripts = &CEGUI::LuaScriptModule::create();
    // Before the first layout: its <Event> elements need it.
    CEGUI::System::getSingleton().setScriptingModule(mScripts);
    CEGUI::System::getSingleton().getClipboard()->setNativeProvider(mClipboard.get());
    loadSkin();
}

Gui::~Gui()
{
    CEGUI::System::getSingleton().getClipboard()->setNativeProvider(nullptr);
    CEGUI::OgreRenderer::destroySystem();
    CEGUI::LuaScriptModule::destroy(*mScripts);
}

void Gui::loadSkin()
{
    const std::string skin = kSkin;
    CEGUI::SchemeManager::getSingleton().createFromFile(skin + ".scheme");
    CEGUI::Font& font = CEGUI::FontManager::getSingleton().createFromFile(std::string(kFont) + ".font");
    context().setDefaultFont(&font);
    context().setDefaultTooltipType(skin + "/Tooltip");
    mRoot = CEGUI::WindowManager::getSingleton().createWindow("DefaultWindow", "LodsmithEditor");
    context().setRootWindow(mRoot);
}

lua_State* Gui::lua() const
{
    return mScripts->getLuaState();
}

bool Gui::handle(const SDL_Event& event)
{
    switch (event.type) {
    case SDL_MOUSEMOTION: context().injectMousePosition(float(event.motion.x), float(event.motion.y)); return true;
    case SDL_MOUSEBUTTONDOWN: return context().injectMouseButtonDown(buttonFor(event.button.button));
    case SDL_MOUSEBUTTONUP: return context().injectMouseButtonUp(buttonFor(event.button.button));
    case SDL_MOUSEWHEEL: return context().injectMouseWheelChange(event.wheel.preciseY);
    case SDL_KEYDOWN: return handleKey(event.key);
    case SDL_KEYUP: return context().injectKeyUp(keyFor(event.key.keysym.sym));
    case SDL_TEXTINPUT: return injectText(event.text.text);
    case SDL_WINDOWEVENT: return event.window.event == SDL_WINDOWEVENT_LEAVE ? context().injectMouseLeaves() : true;
    default: return false;
    }
}

bool Gui::handleKey(const SDL_KeyboardEvent& event)
{
    const bool used = context().injectKeyDown(keyFor(event.keysym.sym));
    if (!(event.keysym.mod & KMOD_CTRL))
        return used;
    switch (event.keysym.sym) {
    case SDLK_c: return context().injectCopyRequest() || used;
    case SDLK_x: return context().injectCutRequest() || used;
    case SDLK_v: return context().injectPasteRequest() || used;
    default: return used;
    }
}

void Gui::resized(int width, int height)
{
    CEGUI::System::getSingleton().notifyDisplaySizeChanged(CEGUI::Sizef(float(width), float(height)));
}

void Gui::advance(double seconds)
{
    context().injectTimePulse(float(seconds));
    CEGUI::System::getSingleton().injectTimePulse(float(seconds));
}

bool Gui::hasChanged() const
{
    return context().isDirty();
}

} // namespace lodsmith::editor
