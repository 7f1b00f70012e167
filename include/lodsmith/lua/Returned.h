#pragma once

#include <lodsmith/core/Export.h>
#include <lodsmith/core/Result.h>
#include <lodsmith/lua/Handle.h>

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

struct lua_State;

namespace lodsmith::lua {

class Table;

/// A value on its way to Lua: nil, a boolean, a number, a string, a table or a handle, which Lua owns from then on.
class LODSMITH_API Value {
public:
    Value(); ///< nil
    ~Value();
    Value(Value&& other) noexcept;
    Value& operator=(Value&& other) noexcept;

    Value(std::nullptr_t) : Value() {}
    Value(std::string text);
    Value(std::string_view text) : Value(std::string(text)) {}
    Value(const char* text) : Value(std::string(text)) {}
    Value(Table table);
    template <class T, std::enable_if_t<std::is_arithmetic_v<T>, int> = 0>
    Value(T number)
    {
        if constexpr (std::is_same_v<T, bool>)
            mValue = number;
        else
            mValue = asDouble(number);
    }
    /// A constant, as its number.
    template <class T, std::enable_if_t<std::is_enum_v<T>, int> = 0>
    Value(T constant) : Value(static_cast<int>(constant))
    {
    }
    template <class T, std::enable_if_t<std::is_base_of_v<Handle, T>, int> = 0>
    Value(std::unique_ptr<T> handle) : mValue(std::unique_ptr<Handle>(std::move(handle)))
    {
    }
    template <class T>
    Value(const std::optional<T>& value) : Value(value ? Value(*value) : Value())
    {
    }

    /// Leaves it on Lua's stack. Raises a Lua error when memory runs out, so that nothing may be alive around it that has a
    /// destructor; a handle is Lua's by then, or still this object's.
    void push(lua_State* state);

private:
    /// A float becomes the number that is written like it: 0.1f is 0.1.
    static double asDouble(float number);
    template <class T>
    static double asDouble(T number)
    {
        return static_cast<double>(number);
    }

    std::variant<std::monostate, bool, double, std::string, std::unique_ptr<Table>, std::unique_ptr<Handle>> mValue;
};

/// A Lua table: an array from 1, and fields.
class LODSMITH_API Table {
public:
    Table() = default;
    /// An array of what can be a Value.
    template <class T>
    explicit Table(const std::vector<T>& items)
    {
        for (const T& item : items)
            add(item);
    }

    Table& add(Value item)
    {
        mItems.push_back(std::move(item));
        return *this;
    }
    Table& set(const char* name, Value value)
    {
        mFields.emplace_back(name, std::move(value));
        return *this;
    }

    /// As Value::push().
    void push(lua_State* state);

private:
    std::vector<Value> mItems;
    std::vector<std::pair<const char*, Value>> mFields;
};

/// What a bound function returns: any number of values.
class LODSMITH_API Returned {
public:
    /// One value.
    template <class T, std::enable_if_t<
                           std::is_constructible_v<Value, T&&> && !std::is_same_v<std::decay_t<T>, Returned>, int> = 0>
    Returned(T&& value)
    {
        mValues.emplace_back(std::forward<T>(value));
    }
    /// nil and describe(error).
    Returned(const Error& error);
    /// true, or nil and a message.
    Returned(const Result<Done>& result);

    Returned(Returned&&) = default;
    Returned& operator=(Returned&&) = default;

    /// nil and all errors, one a line.
    static Returned failures(const std::vector<Error>& errors);
    /// No value at all.
    static Returned nothing() { return Returned(); }
    /// nil and a message of one sentence.
    static Returned failure(std::string_view message);
    /// One more value behind the others.
    Returned&& with(Value value) &&
    {
        mValues.push_back(std::move(value));
        return std::move(*this);
    }

    std::size_t count() const { return mValues.size(); }
    /// As Value::push().
    void push(lua_State* state);

private:
    Returned() = default;

    std::vector<Value> mValues;
};

} // namespace lodsmith::lua
