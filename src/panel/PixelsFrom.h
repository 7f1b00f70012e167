#pragma once

#include <algorithm>

namespace lodsmith::lua {

/// A number of pixels as whoever takes it limits it: not below 0, and 0 for what is no number.
inline unsigned pixelsFrom(double number)
{
    return number > 0 ? static_cast<unsigned>(std::min(number, 1e6)) : 0;
}

} // namespace lodsmith::lua
