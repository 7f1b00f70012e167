#include "Numbers.h"

#include <charconv>
#include <cmath>
#include <cstdio>

namespace lodsmith::cli {

namespace {

template <class T>
std::optional<T> parseWhole(std::string_view text)
{
    T value{};
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc() || stop != end)
        return std::nullopt;
    return value;
}

} // namespace

std::optional<double> parseNumber(std::string_view text)
{
    const std::optional<double> number = parseWhole<double>(text);
    return number && std::isfinite(*number) ? number : std::nullopt;
}

std::optional<std::uint64_t> parseCount(std::string_view text)
{
    return parseWhole<std::uint64_t>(text);
}

std::string formatNumber(double number, int digits)
{
    char text[64];
    std::snprintf(text, sizeof text, "%.*g", digits, number);
    return text;
}

} // namespace lodsmith::cli
