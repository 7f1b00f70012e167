#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace lodsmith::cli {

/// A whole text as a finite decimal number ("0.5", "-1e3"), whatever the locale. Nothing else passes: no blanks, no
/// leading plus, no hexadecimal, no "inf" or "nan", nothing behind the number, nothing beyond the range of a double.
std::optional<double> parseNumber(std::string_view text);

/// A whole text as a decimal whole number of digits alone, 0 .. 2^64-1.
std::optional<std::uint64_t> parseCount(std::string_view text);

/// A number for people: `digits` significant digits, no trailing zeros.
std::string formatNumber(double number, int digits);

} // namespace lodsmith::cli
