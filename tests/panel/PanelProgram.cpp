#include "PanelProgram.h"

#include <CEGUI/CEGUI.h>
#include <CEGUI/ScriptModules/Lua/ScriptModule.h>

#include <lua.hpp>

namespace lodsmith::test {

PanelProgram::PanelProgram()
    : mManager(mDefinitions, mQueue), mGui(std::make_unique<NullGui>()), mScripts(&CEGUI::LuaScriptModule::create())
{
    CEGUI::System::getSingleton().setScriptingModule(mScripts);
    mRoot = CEGUI::WindowManager::getSingleton().createWindow("DefaultWindow", "root");
    CEGUI::System::getSingleton().getDefaultGUIContext().setRootWindow(mRoot);
}

PanelProgram::~PanelProgram()
{
    mGui.reset();
    CEGUI::LuaScriptModule::destroy(*mScripts);
}

lua_State* PanelProgram::lua()
{
    return mScripts->getLuaState();
}

PanelHost PanelProgram::host()
{
    return PanelHost{lua(), mRoot, mDefinitions, mManager, mQueue};
}

std::string PanelProgram::run(const std::string& code)
{
    if (luaL_dostring(lua(), code.c_str()) == 0)
        return "";
    std::string message = lua_tostring(lua(), -1);
    lua_pop(lua(), 1);
    return message;
}

std::string PanelProgram::evaluate(const std::string& expression)
{
    const std::string error = run("evaluated = tostring(" + expression + ")");
    if (!error.empty())
        return "error: " + error;
    lua_getglobal(lua(), "evaluated");
    std::string text = lua_tostring(lua(), -1);
    lua_pop(lua(), 1);
    return text;
}

} // namespace lodsmith::test
