#include "GuardedCegui.h"

#include <lua.hpp>

#include <cstdio>
#include <cstring>
#include <exception>

namespace lodsmith {

namespace {

constexpr int kThrew = -1;
constexpr const char* kPrefix = "CEGUI::";

// Its address is the key of the table of tables that have been seen to.
char guardedKey;

/// The number of results, or kThrew with the message on the stack.
int runCatching(lua_State* state, lua_CFunction function)
{
    char message[1024] = "an unknown exception";
    try {
        return function(state);
    } catch (const std::exception& exception) { // CEGUI::Exception too
        std::snprintf(message, sizeof message, "%s", exception.what());
    } catch (...) { // the message is there
    }
    lua_pushstring(state, message);
    return kThrew;
}

/// Upvalue: the function. Nothing with a destructor is alive when the error jumps.
int callGuarded(lua_State* state)
{
    const int results = runCatching(state, lua_tocfunction(state, lua_upvalueindex(1)));
    return results == kThrew ? lua_error(state) : results;
}

/// Whether the value on top is a function of C's that does not mind being called by another: it has no upvalues.
bool isPlainFunction(lua_State* state)
{
    if (!lua_iscfunction(state, -1) || lua_tocfunction(state, -1) == callGuarded)
        return false;
    if (!lua_getupvalue(state, -1, 1))
        return true;
    lua_pop(state, 1);
    return false;
}

/// Metamethods are tolua++'s own.
bool isMethodName(lua_State* state, int index)
{
    return lua_type(state, index) == LUA_TSTRING && std::strncmp(lua_tostring(state, index), "__", 2) != 0;
}

/// The table on top, and those in it that hold the getters and setters of properties, or other parts of the module.
void guardTable(lua_State* state, int seen)
{
    luaL_checkstack(state, 8, "nested tables");
    lua_pushvalue(state, -1);
    lua_rawget(state, seen);
    const bool isDone = lua_toboolean(state, -1) != 0;
    lua_pop(state, 1);
    if (isDone)
        return;
    lua_pushvalue(state, -1);
    lua_pushboolean(state, 1);
    lua_rawset(state, seen);
    for (lua_pushnil(state); lua_next(state, -2) != 0; lua_pop(state, 1)) {
        if (!isMethodName(state, -2))
            continue;
        if (lua_istable(state, -1)) {
            guardTable(state, seen);
        } else if (isPlainFunction(state)) {
            // To assign to a field that is there is allowed while the table is walked.
            lua_pushvalue(state, -2);
            lua_pushvalue(state, -2);
            lua_pushcclosure(state, callGuarded, 1);
            lua_rawset(state, -5);
        }
    }
}

bool isOfCegui(lua_State* state, int name)
{
    return lua_type(state, name) == LUA_TSTRING
           && std::strncmp(lua_tostring(state, name), kPrefix, std::strlen(kPrefix)) == 0;
}

} // namespace

void guardCegui(lua_State* state)
{
    lua_pushlightuserdata(state, &guardedKey);
    lua_rawget(state, LUA_REGISTRYINDEX);
    const bool isDone = !lua_isnil(state, -1);
    lua_pop(state, 1);
    if (isDone)
        return;
    lua_newtable(state);
    const int seen = lua_gettop(state);
    lua_getglobal(state, "CEGUI");
    guardTable(state, seen);
    lua_pop(state, 1);
    // Classes are their metatables, which tolua++ keeps by their names.
    for (lua_pushnil(state); lua_next(state, LUA_REGISTRYINDEX) != 0; lua_pop(state, 1))
        if (isOfCegui(state, -2) && lua_istable(state, -1))
            guardTable(state, seen);
    lua_pushlightuserdata(state, &guardedKey);
    lua_insert(state, -2);
    lua_rawset(state, LUA_REGISTRYINDEX);
}

} // namespace lodsmith
