#include <lodsmith/lua/Returned.h>

#include <lodsmith/lua/Binding.h>

#include <charconv>
#include <cmath>

namespace lodsmith::lua {

Value::Value() = default;
Value::~Value() = default;
Value::Value(Value&& other) noexcept = default;
Value& Value::operator=(Value&& other) noexcept = default;

Value::Value(std::string text) : mValue(std::move(text)) {}

Value::Value(Table table) : mValue(std::make_unique<Table>(std::move(table))) {}

double Value::asDouble(float number)
{
    char text[32];
    const auto written = std::to_chars(std::begin(text), std::end(text), number);
    double result = number;
    if (std::isfinite(number))
        std::from_chars(text, written.ptr, result);
    return result;
}

void Value::push(lua_State* state)
{
    if (const auto* flag = std::get_if<bool>(&mValue))
        lua_pushboolean(state, *flag);
    else if (const auto* number = std::get_if<double>(&mValue))
        lua_pushnumber(state, *number);
    else if (const auto* text = std::get_if<std::string>(&mValue))
        lua_pushlstring(state, text->data(), text->size());
    else if (const auto* table = std::get_if<std::unique_ptr<Table>>(&mValue))
        (*table)->push(state);
    else if (auto* handle = std::get_if<std::unique_ptr<Handle>>(&mValue); handle && *handle)
        pushHandle(state, *handle);
    else
        lua_pushnil(state);
}

void Table::push(lua_State* state)
{
    luaL_checkstack(state, 8, "too many nested tables");
    lua_createtable(state, static_cast<int>(mItems.size()), static_cast<int>(mFields.size()));
    int index = 0;
    for (Value& item : mItems) {
        item.push(state);
        lua_rawseti(state, -2, ++index);
    }
    for (auto& [name, value] : mFields) {
        value.push(state);
        lua_setfield(state, -2, name);
    }
}

Returned::Returned(const Error& error) : Returned(failure(describe(error))) {}

Returned::Returned(const Result<Done>& result)
{
    if (result)
        mValues.emplace_back(true);
    else
        *this = failure(describe(result.error()));
}

Returned Returned::failure(std::string_view message)
{
    Returned returned;
    returned.mValues.emplace_back();
    returned.mValues.emplace_back(message);
    return returned;
}

Returned Returned::failures(const std::vector<Error>& errors)
{
    std::string lines;
    for (const Error& error : errors)
        lines += (lines.empty() ? "" : "\n") + describe(error);
    return failure(lines);
}

void Returned::push(lua_State* state)
{
    luaL_checkstack(state, static_cast<int>(mValues.size()) + 8, "too many results");
    for (Value& value : mValues)
        value.push(state);
}

} // namespace lodsmith::lua
