#pragma once

#include <memory>
#include <string>
#include <vector>

struct lua_State;

namespace CEGUI {
class DefaultResourceProvider;
class LuaScriptModule;
class NullRenderer;
class Window;
} // namespace CEGUI

namespace lodsmith::test {

class RecordingLogger;

/// CEGUI without a display, with a skin and the panel's layouts, for as long as this object lives; one at a time.
class GuiSession {
public:
    /// @param skin the name of a scheme of CEGUI's ("TaharezLook")
    explicit GuiSession(const std::string& skin);
    ~GuiSession();
    GuiSession(const GuiSession&) = delete;
    GuiSession& operator=(const GuiSession&) = delete;

    /// CEGUI's Lua, which finds the modules of gui-layouts/ and of these tests.
    lua_State* lua() const;
    /// What was logged as an error.
    const std::vector<std::string>& errors() const;

private:
    void findResources();
    void takeSkin(const std::string& skin);

    std::unique_ptr<RecordingLogger> mLogger;
    std::unique_ptr<CEGUI::DefaultResourceProvider> mResources;
    CEGUI::NullRenderer* mRenderer = nullptr;
    CEGUI::LuaScriptModule* mScripts = nullptr;
};

/// The skins of CEGUI's that the panel is tested with.
std::vector<std::string> skins();

/// Lets a state find the modules of gui-layouts/ and of these tests.
void addModulePaths(lua_State* lua);

} // namespace lodsmith::test
