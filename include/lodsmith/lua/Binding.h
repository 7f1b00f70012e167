#pragma once

#include <lodsmith/core/Export.h>
#include <lodsmith/lua/Handle.h>
#include <lodsmith/lua/Returned.h>

#include <tolua++.h>

#include <memory>
#include <optional>
#include <string_view>
#include <type_traits>

/// What the code that tolua++ generates from a `.pkg` stands on. Each of them begins with
///
///     $#include <lodsmith/lua/Binding.h>
///
/// and is made part of a library with lodsmith_add_package() (cmake/LodsmithTolua.cmake). A bound function takes `bool`, `double`,
/// `Text`, `Function`, `OptionalNumber` and references to handles, and returns `Returned`; it may throw anything.
namespace lodsmith::lua {

/// A string argument, with all its bytes; valid during the call.
using Text = std::string_view;

/// A number or nil.
using OptionalNumber = std::optional<double>;

/// A function argument: where it is on the stack. Callback keeps it for later.
struct Function {
    lua_State* state = nullptr;
    int index = 0;
};

namespace detail {

/// What `work` returns, or nil and what it threw.
LODSMITH_API Returned failureFromException() noexcept;
/// Leaves the function that pushes on the stack. May raise a Lua error.
LODSMITH_API void prepareToPush(lua_State* state);
/// Replaces the function of prepareToPush() by the values, or by an error message and returns false. Raises nothing.
LODSMITH_API bool pushInProtectedMode(lua_State* state, Returned& returned) noexcept;

template <class Work>
Returned runCatching(const Work& work) noexcept
{
    try {
        return work();
    } catch (...) {
        return failureFromException();
    }
}

template <class Work>
bool runAndPush(lua_State* state, const Work& work)
{
    Returned returned = runCatching(work);
    return pushInProtectedMode(state, returned);
}

} // namespace detail

/// The one way from Lua into a bound function and back: what `work` throws becomes nil and a message, and its result is pushed
/// where a Lua error, which is a jump over all destructors, finds nothing to jump over.
template <class Work>
int call(lua_State* state, const Work& work)
{
    const int before = lua_gettop(state);
    detail::prepareToPush(state);
    if (!detail::runAndPush(state, work))
        return lua_error(state);
    return lua_gettop(state) - before;
}

/// As tolua_isusertype(), for handles. That believes what a userdata says it is; this one asks what it was when Lua got it, so that
/// an object that a script has disguised with tolua.cast() is an error, and nothing is read as what it is not.
LODSMITH_API int isHandle(lua_State* state, int index, const char* type, int isOptional, tolua_Error* error);

/// Leaves a handle on the stack and gives it to Lua. May raise a Lua error, and then has not taken it.
LODSMITH_API void pushHandle(lua_State* state, std::unique_ptr<Handle>& handle);

/// Destroys the handle in the userdata at index 1, which is empty from then on.
LODSMITH_API void collect(lua_State* state, Handle* handle);

namespace detail {

template <class Bound, class... Others>
constexpr bool isNoBaseOf()
{
    return (!std::is_base_of_v<Bound, Others> && ...) && (!std::is_base_of_v<Others, Bound> && ...);
}

template <class... Bound>
struct BoundClasses;
template <>
struct BoundClasses<> {
    static constexpr bool areUnrelated = true;
};
template <class First, class... Rest>
struct BoundClasses<First, Rest...> {
    static constexpr bool areUnrelated =
        std::is_base_of_v<Handle, First> && isNoBaseOf<First, Rest...>() && BoundClasses<Rest...>::areUnrelated;
};

} // namespace detail
} // namespace lodsmith::lua

/// Asserts that the classes are handles, and none a base of another: tolua++ knows no offsets, and a base that does not lie
/// at the beginning of its derived class would be read from the wrong place.
#define LODSMITH_BOUND_CLASSES(...)                                                                                    \
    static_assert(::lodsmith::lua::detail::BoundClasses<__VA_ARGS__>::areUnrelated,                                    \
                  "a bound class derives from lodsmith::lua::Handle and from no bound class")

// Names that tolua++ makes up from the types in a `.pkg`.

inline int tolua_istext(lua_State* state, int index, int isOptional, tolua_Error* error)
{
    return tolua_isstring(state, index, isOptional, error);
}

inline lodsmith::lua::Text tolua_totext(lua_State* state, int index, const char* otherwise)
{
    std::size_t length = 0;
    const char* text = lua_tolstring(state, index, &length);
    return text ? lodsmith::lua::Text(text, length) : lodsmith::lua::Text(otherwise ? otherwise : "");
}

inline int tolua_isoptionalnumber(lua_State* state, int index, int isOptional, tolua_Error* error)
{
    return lua_isnil(state, index) || tolua_isnumber(state, index, isOptional, error);
}

inline lodsmith::lua::OptionalNumber tolua_tooptionalnumber(lua_State* state, int index, int)
{
    return lua_isnoneornil(state, index) ? std::nullopt : lodsmith::lua::OptionalNumber(lua_tonumber(state, index));
}

inline int tolua_isfunction(lua_State* state, int index, int, tolua_Error* error)
{
    if (lua_isfunction(state, index))
        return 1;
    error->index = index;
    error->array = 0;
    error->type = "function";
    return 0;
}

inline lodsmith::lua::Function tolua_tofunction(lua_State* state, int index, int)
{
    return {state, index};
}

/// Constants are those of the library: enum class.
template <class Enum, std::enable_if_t<std::is_enum_v<Enum>, int> = 0>
void tolua_constant(lua_State* state, const char* name, Enum value)
{
    tolua_constant(state, name, static_cast<lua_Number>(value));
}

// The generated function ends with this; the hooks have put it into a lambda.
#define tolua_pushreturned(state, returned) return returned

#undef Mtolua_delete
#define Mtolua_delete(handle) ::lodsmith::lua::collect(tolua_S, handle)

namespace lodsmith {
// In Lua all is in one table.
using namespace lua;
} // namespace lodsmith

using lodsmith::lua::Function;
using lodsmith::lua::OptionalNumber;
using lodsmith::lua::Returned;
using lodsmith::lua::Text;
