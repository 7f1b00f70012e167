#include <lodsmith/lua/Binding.h>

#include <exception>
#include <new>

namespace lodsmith::lua {

namespace {

constexpr const char* kOutOfMemory = "out of memory";
// What is expected where an object only looks right.
constexpr const char* kLivingObject = "object that is alive";

/// On the stack: what prepareToPush() has left, and a Returned.
int pushReturned(lua_State* state)
{
    auto* returned = static_cast<Returned*>(lua_touserdata(state, 1));
    lua_settop(state, 0);
    returned->push(state);
    return lua_gettop(state);
}

Returned describeException()
{
    try {
        throw;
    } catch (const std::bad_alloc&) {
        return Returned::failure(kOutOfMemory);
    } catch (const std::exception& exception) { // Ogre::Exception too
        return Returned::failure(exception.what());
    } catch (...) {
        return Returned::failure("unknown exception");
    }
}

/// Leaves a table on the stack: for each object that Lua owns, the metatable of its class, by its address.
void pushOwned(lua_State* state)
{
    lua_pushliteral(state, "tolua_gc");
    lua_rawget(state, LUA_REGISTRYINDEX);
}

/// Leaves a table on the stack: the userdata of each object of the class whose metatable is on top, by its address.
void pushUserdataOf(lua_State* state)
{
    lua_pushliteral(state, "tolua_ubox");
    lua_rawget(state, -2);
    if (lua_istable(state, -1))
        return;
    lua_pop(state, 1);
    lua_pushliteral(state, "tolua_ubox");
    lua_rawget(state, LUA_REGISTRYINDEX);
}

/// Whether the object at an address is one of this class that Lua owns and has not collected. Nothing at the address is read.
bool isAlive(lua_State* state, void* address, const char* type)
{
    pushOwned(state);
    lua_pushlightuserdata(state, address);
    lua_rawget(state, -2);
    luaL_getmetatable(state, type);
    const bool isAlive = lua_rawequal(state, -1, -2) != 0;
    lua_pop(state, 3);
    return isAlive;
}

} // namespace

namespace detail {

Returned failureFromException() noexcept
{
    try {
        return describeException();
    } catch (...) { // no memory for the message either
        return Returned::nothing();
    }
}

void prepareToPush(lua_State* state)
{
    luaL_checkstack(state, 4, "no room for results");
    lua_pushcfunction(state, pushReturned);
}

bool pushInProtectedMode(lua_State* state, Returned& returned) noexcept
{
    lua_pushlightuserdata(state, &returned);
    return lua_pcall(state, 1, LUA_MULTRET, 0) == 0;
}

} // namespace detail

int isHandle(lua_State* state, int index, const char* type, int isOptional, tolua_Error* error)
{
    if (!tolua_isusertype(state, index, type, isOptional, error))
        return 0;
    const void* box = lua_touserdata(state, index);
    if (!box || isAlive(state, *static_cast<void* const*>(box), type))
        return 1;
    error->index = index;
    error->array = 0;
    error->type = kLivingObject;
    return 0;
}

void pushHandle(lua_State* state, std::unique_ptr<Handle>& handle)
{
    // What tolua_pushusertype_and_takeownership() does, in an order in which any step may run out of memory.
    auto* box = static_cast<void**>(lua_newuserdata(state, sizeof(void*)));
    *box = nullptr;
    lua_pushvalue(state, TOLUA_NOPEER);
    lua_setfenv(state, -2);
    luaL_getmetatable(state, handle->typeName());
    lua_pushvalue(state, -1);
    lua_setmetatable(state, -3);
    pushUserdataOf(state);
    lua_pushlightuserdata(state, handle.get());
    lua_pushvalue(state, -4);
    lua_rawset(state, -3);
    lua_pop(state, 1);
    pushOwned(state);
    lua_pushlightuserdata(state, handle.get());
    lua_pushvalue(state, -3);
    lua_rawset(state, -3);
    *box = handle.release();
    lua_pop(state, 2);
}

void collect(lua_State* state, Handle* handle)
{
    if (!handle)
        return;
    *static_cast<void**>(lua_touserdata(state, 1)) = nullptr;
    // Another object may get the address.
    lua_getmetatable(state, 1);
    pushUserdataOf(state);
    lua_pushlightuserdata(state, handle);
    lua_pushnil(state);
    lua_rawset(state, -3);
    lua_pop(state, 2);
    delete handle;
}

} // namespace lodsmith::lua
