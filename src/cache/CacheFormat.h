#pragma once

#include <cstdint>

namespace lodsmith {

/// In every key and every entry. To be raised with every change of either, and with every change of simplify() that gives other
/// chains within one version of the library.
constexpr std::uint32_t kCacheFormat = 2;

} // namespace lodsmith
