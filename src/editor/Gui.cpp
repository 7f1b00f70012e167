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

void injectText(const char* text)
{
    const CEGUI::String characters(reinterpret_cast<const CEGUI::utf8*>(text));
    for (const CEGUI::String::value_type character : characters)
        context().injectChar(character);
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

void Gui::handle(const SDL_Event& event)
{
    switch (event.type) {
    case SDL_MOUSEMOTION: context().injectMousePosition(float(event.motion.x), float(event.motion.y)); break;
    case SDL_MOUSEBUTTONDOWN: context().injectMouseButtonDown(buttonFor(event.button.button)); break;
    case SDL_MOUSEBUTTONUP: context().injectMouseButtonUp(buttonFor(event.button.button)); break;
    case SDL_MOUSEWHEEL: context().injectMouseWheelChange(event.wheel.preciseY); break;
    case SDL_KEYDOWN: handleKey(event.key); break;
    case SDL_KEYUP: context().injectKeyUp(keyFor(event.key.keysym.sym)); break;
    case SDL_TEXTINPUT: injectText(event.text.text); break;
    case SDL_WINDOWEVENT:
        if (event.window.event == SDL_WINDOWEVENT_LEAVE)
            context().injectMouseLeaves();
        break;
    default: break;
    }
}

void Gui::handleKey(const SDL_KeyboardEvent& event)
{
    context().injectKeyDown(keyFor(event.keysym.sym));
    if (!(event.keysym.mod & KMOD_CTRL))
        return;
    switch (event.keysym.sym) {
    case SDLK_c: context().injectCopyRequest(); break;
    case SDLK_x: context().injectCutRequest(); break;
    case SDLK_v: context().injectPasteRequest(); break;
    default: break;
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
