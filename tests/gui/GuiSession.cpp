#include "GuiSession.h"

// Its string derives from a class that C++17 has deprecated.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"
#include <CEGUI/CEGUI.h>
#include <CEGUI/RendererModules/Null/Renderer.h>
#include <CEGUI/ScriptModules/Lua/ScriptModule.h>
#pragma GCC diagnostic pop

#include <lua.hpp>

namespace lodsmith::test {

namespace {

constexpr const char* kWidgets[] = {
    "Button",      "Checkbox",   "Combobox",        "Editbox",     "FrameWindow", "HorizontalScrollbar",
    "Label",       "Listbox",    "MultiColumnList", "ProgressBar", "RadioButton", "ScrollablePane",
    "StaticImage", "StaticText", "TabControl",      "Tooltip"};

} // namespace

class RecordingLogger : public CEGUI::Logger {
public:
    void logEvent(const CEGUI::String& message, CEGUI::LoggingLevel level) override
    {
        if (level == CEGUI::Errors) {
            mErrors.emplace_back(message.c_str());
        }
    }
    void setLogFilename(const CEGUI::String&, bool) override {}
    const std::vector<std::string>& errors() const { return mErrors; }

private:
    std::vector<std::string> mErrors;
};

GuiSession::GuiSession(const std::string& skin)
    : mLogger(std::make_unique<RecordingLogger>()), mResources(std::make_unique<CEGUI::DefaultResourceProvider>())
{
    CEGUI::Exception::setStdErrEnabled(false);
    mRenderer = &CEGUI::NullRenderer::create();
    mRenderer->setDisplaySize(CEGUI::Sizef(1024.0f, 768.0f));
    mScripts = &CEGUI::LuaScriptModule::create();
    CEGUI::System::create(*mRenderer, mResources.get(), nullptr, nullptr, mScripts);
    findResources();
    takeSkin(skin);
    addModulePaths(lua());
}

GuiSession::~GuiSession()
{
    CEGUI::System::destroy();
    CEGUI::LuaScriptModule::destroy(*mScripts);
    CEGUI::NullRenderer::destroy(*mRenderer);
}

lua_State* GuiSession::lua() const
{
    return mScripts->getLuaState();
}

const std::vector<std::string>& GuiSession::errors() const
{
    return mLogger->errors();
}

void GuiSession::findResources()
{
    const std::string data = LODSMITH_CEGUI_DATA_DIR "/";
    for (const char* group : {"schemes", "imagesets", "fonts", "looknfeel"}) {
        mResources->setResourceGroupDirectory(group, data + group + "/");
    }
    mResources->setResourceGroupDirectory("layouts", LODSMITH_GUI_LAYOUTS "/");
    CEGUI::Scheme::setDefaultResourceGroup("schemes");
    CEGUI::ImageManager::setImagesetDefaultResourceGroup("imagesets");
    CEGUI::Font::setDefaultResourceGroup("fonts");
    CEGUI::WidgetLookManager::setDefaultResourceGroup("looknfeel");
    CEGUI::WindowManager::setDefaultResourceGroup("layouts");
}

void GuiSession::takeSkin(const std::string& skin)
{
    CEGUI::SchemeManager::getSingleton().createFromFile(skin + ".scheme");
    auto& context = CEGUI::System::getSingleton().getDefaultGUIContext();
    context.setDefaultFont(&CEGUI::FontManager::getSingleton().createFromFile("DejaVuSans-10-NoScale.font"));
    // Two quick clicks of a test are two clicks.
    context.setMouseButtonMultiClickTimeout(1e-7f);
    for (const char* widget : kWidgets) {
        CEGUI::WindowFactoryManager::getSingleton().addWindowTypeAlias(std::string("Lodsmith/") + widget,
                                                                       skin + "/" + widget);
    }
    context.setDefaultTooltipType("Lodsmith/Tooltip");
    context.setRootWindow(CEGUI::WindowManager::getSingleton().createWindow("DefaultWindow", "Root"));
}

std::vector<std::string> skins()
{
    return {"TaharezLook", "WindowsLook", "OgreTray"};
}

void addModulePaths(lua_State* lua)
{
    // As the panel does it when it opens.
    constexpr const char* kFind = R"(
        local panel, tests = ...
        package.path = tests .. "/?.lua"
        table.insert(package.loaders, function(name)
            local module = name:match("^lodsmith%.gui%.(%w+)$")
            return module and assert(loadfile(panel .. "/" .. module .. ".lua"))
        end))";
    luaL_loadstring(lua, kFind);
    lua_pushstring(lua, LODSMITH_GUI_LAYOUTS);
    lua_pushstring(lua, LODSMITH_GUI_TESTS);
    lua_call(lua, 2, 0);
}

} // namespace lodsmith::test
