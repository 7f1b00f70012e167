#include "Callback.h"

#include <OgreLogManager.h>

#include <new>
#include <string>

namespace lodsmith::lua {

namespace {

// Its address is the key of takeReference() in the registry.
char takeReferenceKey;

/// What is called in protected mode.
struct PendingCall {
    int reference;
    Returned* arguments;
};

int takeReference(lua_State* state)
{
    lua_pushinteger(state, luaL_ref(state, LUA_REGISTRYINDEX));
    return 1;
}

/// Does so in protected mode; whoever calls this has objects with destructors around it.
int referenceTo(const Function& function)
{
    lua_State* state = function.state;
    lua_pushlightuserdata(state, &takeReferenceKey);
    lua_rawget(state, LUA_REGISTRYINDEX);
    lua_pushvalue(state, function.index);
    const bool taken = lua_pcall(state, 1, 1, 0) == 0;
    const int reference = taken ? static_cast<int>(lua_tointeger(state, -1)) : LUA_NOREF;
    lua_pop(state, 1);
    if (!taken)
        throw std::bad_alloc();
    return reference;
}

int callFunction(lua_State* state)
{
    const auto* pending = static_cast<const PendingCall*>(lua_touserdata(state, 1));
    lua_settop(state, 0);
    lua_rawgeti(state, LUA_REGISTRYINDEX, pending->reference);
    pending->arguments->push(state);
    lua_call(state, lua_gettop(state) - 1, 0);
    return 0;
}

int callOnError(lua_State* state)
{
    const auto* message = static_cast<const std::string*>(lua_touserdata(state, 1));
    lua_getglobal(state, "lodsmith");
    if (!lua_istable(state, -1))
        return 0;
    lua_getfield(state, -1, "onError");
    if (!lua_isfunction(state, -1))
        return 0;
    lua_pushlstring(state, message->data(), message->size());
    lua_call(state, 1, 0);
    return 0;
}

/// Takes the error object from the stack.
std::string takeMessage(lua_State* state)
{
    std::string message = "an error without a message";
    if (lua_type(state, -1) == LUA_TSTRING)
        message.assign(lua_tostring(state, -1), lua_objlen(state, -1));
    lua_pop(state, 1);
    return message;
}

void logError(const std::string& message)
{
    if (auto* log = Ogre::LogManager::getSingletonPtr(); log && log->getDefaultLog())
        log->logError("Lua: " + message);
}

void report(lua_State* state)
{
    std::string message = takeMessage(state);
    logError(message);
    if (lua_cpcall(state, callOnError, &message) != 0)
        logError("in lodsmith.onError: " + takeMessage(state));
}

} // namespace

void prepareCallbacks(lua_State* state)
{
    lua_pushlightuserdata(state, &takeReferenceKey);
    lua_pushcfunction(state, takeReference);
    lua_rawset(state, LUA_REGISTRYINDEX);
}

Callback::Callback(const Function& function) : mLink(stateLink(function.state)), mReference(referenceTo(function)) {}

Callback::~Callback()
{
    if (mLink->state)
        luaL_unref(mLink->state, LUA_REGISTRYINDEX, mReference);
}

void Callback::operator()(Returned arguments) const noexcept
{
    // The function may destroy this object.
    const std::shared_ptr<StateLink> link = mLink;
    if (!link->state)
        return;
    PendingCall pending{mReference, &arguments};
    if (lua_cpcall(link->state, callFunction, &pending) == 0)
        return;
    try {
        report(link->state);
    } catch (...) { // no memory for the message: nobody is left to tell
        return;
    }
}

} // namespace lodsmith::lua
