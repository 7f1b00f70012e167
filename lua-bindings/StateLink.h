#pragma once

#include <lua.hpp>

#include <memory>

namespace lodsmith::lua {

/// The way back to a Lua state for what may outlive it.
struct StateLink {
    lua_State* state = nullptr; ///< null once it is closed
};

/// Makes the link of a state that has none. May raise a Lua error.
void makeStateLink(lua_State* state);

/// Null where makeStateLink() was not called. Raises nothing; also for coroutines of the state.
std::shared_ptr<StateLink> stateLink(lua_State* state);

} // namespace lodsmith::lua
