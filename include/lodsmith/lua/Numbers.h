#pragma once

#include <lodsmith/core/Result.h>

#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>

namespace lodsmith::lua {

/// As Lua prints it.
inline std::string numberText(double number)
{
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text.precision(14);
    text << number;
    return text.str();
}

/// One of the constants 0..last, or InvalidSetting. @param table where they are in Lua ("Strategy")
template <class Constant>
Result<Constant> constantFrom(double number, Constant last, const char* table)
{
    if (number >= 0 && number <= static_cast<double>(last) && number == std::floor(number))
        return static_cast<Constant>(static_cast<int>(number));
    return Error{ErrorCode::InvalidSetting, numberText(number) + " is none of lodsmith." + table};
}

/// The position of what Lua calls number `index` among `count`, or NotFound.
inline Result<std::size_t> positionFrom(double index, std::size_t count, const char* what)
{
    if (index >= 1 && index <= static_cast<double>(count) && index == std::floor(index))
        return static_cast<std::size_t>(index) - 1;
    return Error{ErrorCode::NotFound,
                 std::string("there is no ") + what + " " + numberText(index) + ", there are " + std::to_string(count)};
}

} // namespace lodsmith::lua
