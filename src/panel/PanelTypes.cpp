#include "PanelTypes.h"

#include <cstring>
#include <string>

namespace lodsmith::lua {

namespace {

/// Takes the number on top of the stack; none for another value.
std::optional<float> takeNumber(lua_State* state)
{
    std::optional<float> number;
    if (lua_type(state, -1) == LUA_TNUMBER)
        number = static_cast<float>(lua_tonumber(state, -1));
    lua_pop(state, 1);
    return number;
}

/// Whether the value at an index is this string.
bool isWord(lua_State* state, int index, const char* word)
{
    return lua_type(state, index) == LUA_TSTRING && std::strcmp(lua_tostring(state, index), word) == 0;
}

/// The marker in the table on top of the stack, which stays there.
std::optional<GraphMarker> markerAt(lua_State* state)
{
    std::optional<float> x, y;
    bool isSelected = false;
    lua_rawgeti(state, -1, 1);
    x = takeNumber(state);
    lua_rawgeti(state, -1, 2);
    y = takeNumber(state);
    lua_pushnil(state);
    while (lua_next(state, -2) != 0) {
        if (isWord(state, -2, "selected"))
            isSelected = lua_toboolean(state, -1) != 0;
        else if (isWord(state, -2, "x") && lua_type(state, -1) == LUA_TNUMBER)
            x = static_cast<float>(lua_tonumber(state, -1));
        else if (isWord(state, -2, "y") && lua_type(state, -1) == LUA_TNUMBER)
            y = static_cast<float>(lua_tonumber(state, -1));
        lua_pop(state, 1);
    }
    if (!x || !y)
        return std::nullopt;
    return GraphMarker{{*x, *y}, isSelected};
}

/// All items of an array, read one by one from the top of the stack.
template <class Item, class Read>
Result<std::vector<Item>> readArray(const Items& array, const char* what, Read read)
{
    std::vector<Item> items;
    const int count = static_cast<int>(lua_objlen(array.state, array.index));
    for (int i = 1; i <= count; ++i) {
        lua_rawgeti(array.state, array.index, i);
        const std::optional<Item> item = read(array.state);
        if (!item)
            return Error{ErrorCode::InvalidSetting, "item " + std::to_string(i) + " is no " + what};
        items.push_back(*item);
    }
    return items;
}

} // namespace

Result<std::vector<float>> Items::numbers() const
{
    return readArray<float>(*this, "number", takeNumber);
}

Result<std::vector<GraphMarker>> Items::markers() const
{
    return readArray<GraphMarker>(*this, "pair of numbers", [](lua_State* lua) {
        const auto marker = lua_istable(lua, -1) ? markerAt(lua) : std::nullopt;
        lua_pop(lua, 1);
        return marker;
    });
}

} // namespace lodsmith::lua
