#include <lodsmith/lua/LuaBindings.h>
#include <lodsmith/panel/AssetsManagerPanel.h>

#include <lua.hpp>

#include <cstdio>
#include <filesystem>

/// A program with Lua that finds the panel's layouts and scripts where they were installed.
int main(int, char** argv)
{
    lua_State* const state = luaL_newstate();
    luaL_openlibs(state);
    lodsmith::openLuaBindings(state);
    const bool works =
        luaL_dostring(state, "local definition = lodsmith.newDefinition() definition:setAutomatic(false) "
                             "assert(definition:addLevel(20))")
        == 0;
    if (!works)
        std::fprintf(stderr, "%s\n", lua_tostring(state, -1));
    lua_close(state);
    const std::filesystem::path directory = lodsmith::guiDirectory();
    const bool isInstalled = directory.string().find("share/lodsmith/gui-layouts") != std::string::npos
                             && std::filesystem::exists(directory / "AssetsManager.lua");
    if (!isInstalled)
        std::fprintf(stderr, "%s: the panel's scripts are in %s\n", argv[0], directory.c_str());
    return works && isInstalled ? 0 : 1;
}
