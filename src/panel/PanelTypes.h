#pragma once

#include <lodsmith/core/Result.h>
#include <lodsmith/lua/Binding.h>
#include <lodsmith/panel/Graph.h>

#include <optional>
#include <vector>

namespace lodsmith::lua {

/// A string or nil.
using OptionalText = std::optional<Text>;

/// A table argument: where it is on the stack. Read without metamethods, and so that nothing raises a Lua error.
struct Items {
    lua_State* state = nullptr;
    int index = 0;

    /// An array of numbers. Errors: InvalidSetting for anything else in it.
    Result<std::vector<float>> numbers() const;
    /// An array of `{x, y}` or `{x = ..., y = ...}`, each with `selected = true` or without. Errors: InvalidSetting.
    Result<std::vector<GraphMarker>> markers() const;
};

} // namespace lodsmith::lua

inline int tolua_isoptionaltext(lua_State* state, int index, int isOptional, tolua_Error* error)
{
    return lua_isnil(state, index) || tolua_isstring(state, index, isOptional, error);
}

inline lodsmith::lua::OptionalText tolua_tooptionaltext(lua_State* state, int index, int)
{
    return lua_isnoneornil(state, index) ? std::nullopt
                                         : lodsmith::lua::OptionalText(tolua_totext(state, index, nullptr));
}

inline int tolua_isitems(lua_State* state, int index, int isOptional, tolua_Error* error)
{
    return tolua_istable(state, index, isOptional, error);
}

inline lodsmith::lua::Items tolua_toitems(lua_State* state, int index, int)
{
    return {state, index};
}

using lodsmith::lua::Items;
using lodsmith::lua::OptionalText;
