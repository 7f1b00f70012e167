#include "Script.h"

#include <lua.hpp>

namespace lodsmith::editor {

namespace {

/// What is on top of the stack, as text.
std::string messageOn(lua_State* lua)
{
    const char* const text = lua_tostring(lua, -1);
    return text ? text : std::string("an error object of type ") + luaL_typename(lua, -1);
}

} // namespace

Result<Done> runLua(lua_State* lua, const char* code, const std::string& argument)
{
    const int before = lua_gettop(lua);
    int failed = luaL_loadstring(lua, code);
    if (failed == 0) {
        lua_pushlstring(lua, argument.data(), argument.size());
        failed = lua_pcall(lua, 1, 0, 0);
    }
    if (failed == 0)
        return Done{};
    Error error{ErrorCode::BadFile, messageOn(lua)};
    lua_settop(lua, before);
    return error;
}

Script::Script(lua_State* lua, lua_State* thread, int reference) : mLua(lua), mThread(thread), mReference(reference) {}

Script::~Script()
{
    luaL_unref(mLua, LUA_REGISTRYINDEX, mReference);
}

Result<std::unique_ptr<Script>> Script::load(lua_State* lua, const std::filesystem::path& file)
{
    lua_State* const thread = lua_newthread(lua);
    std::unique_ptr<Script> script(new Script(lua, thread, luaL_ref(lua, LUA_REGISTRYINDEX)));
    switch (luaL_loadfile(thread, file.c_str())) {
    case 0: return script;
    case LUA_ERRFILE: return Error{ErrorCode::NotFound, messageOn(thread), file.string()};
    default: return Error{ErrorCode::BadFile, messageOn(thread), file.string()};
    }
}

Result<bool> Script::resume()
{
    switch (lua_resume(mThread, 0)) {
    case 0: return false;
    case LUA_YIELD: lua_settop(mThread, 0); return true;
    default: return Error{ErrorCode::BadFile, messageOn(mThread)};
    }
}

} // namespace lodsmith::editor
