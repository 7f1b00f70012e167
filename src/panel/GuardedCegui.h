#pragma once

struct lua_State;

namespace lodsmith {

/// Makes what CEGUI throws in a function that Lua has called an error of Lua's: CEGUI's bindings let it through, over frames of
/// Lua's, which are broken from then on. For all functions of CEGUI's script module in the state, once. May raise a Lua error.
void guardCegui(lua_State* state);

} // namespace lodsmith
