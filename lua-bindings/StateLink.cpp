#include "StateLink.h"

#include <new>

namespace lodsmith::lua {

namespace {

using SharedLink = std::shared_ptr<StateLink>;

// Its address is the key.
char linkKey;

SharedLink* findLink(lua_State* state)
{
    lua_pushlightuserdata(state, &linkKey);
    lua_rawget(state, LUA_REGISTRYINDEX);
    auto* link = static_cast<SharedLink*>(lua_touserdata(state, -1));
    lua_pop(state, 1);
    return link;
}

int closeLink(lua_State* state)
{
    auto* link = static_cast<SharedLink*>(lua_touserdata(state, 1));
    if (*link)
        (*link)->state = nullptr;
    link->~SharedLink();
    new (link) SharedLink;
    return 0;
}

bool fillLink(SharedLink& link, lua_State* state) noexcept
{
    try {
        link = std::make_shared<StateLink>(StateLink{state});
        return true;
    } catch (...) {
        return false;
    }
}

} // namespace

void makeStateLink(lua_State* state)
{
    if (findLink(state))
        return;
    auto* link = new (lua_newuserdata(state, sizeof(SharedLink))) SharedLink;
    lua_createtable(state, 0, 1);
    lua_pushcfunction(state, closeLink);
    lua_setfield(state, -2, "__gc");
    lua_setmetatable(state, -2);
    if (!fillLink(*link, state))
        luaL_error(state, "out of memory");
    lua_pushlightuserdata(state, &linkKey);
    lua_insert(state, -2);
    lua_rawset(state, LUA_REGISTRYINDEX);
}

SharedLink stateLink(lua_State* state)
{
    const SharedLink* link = findLink(state);
    return link ? *link : nullptr;
}

} // namespace lodsmith::lua
