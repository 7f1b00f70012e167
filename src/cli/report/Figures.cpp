#include "Figures.h"

#include "../Numbers.h"

#include <array>
#include <cmath>
#include <cstdio>

namespace lodsmith::cli {

namespace {

constexpr const char* kNarrowSpace = "\u202F";
constexpr const char* kDash = "–";
constexpr const char* kMinus = "−";

std::string decimals(double number, int count)
{
    char text[400];
    std::snprintf(text, sizeof text, "%.*f", count, number);
    return text;
}

/// A number in digits, with its minus sign and its groups of three.
std::string grouped(const std::string& digits)
{
    const bool negative = digits[0] == '-';
    const std::string plain = digits.substr(negative ? 1 : 0);
    const std::size_t whole = plain.find('.') == std::string::npos ? plain.size() : plain.find('.');
    std::string text = negative ? kMinus : "";
    for (std::size_t i = 0; i < plain.size(); ++i) {
        if (i > 0 && i < whole && (whole - i) % 3 == 0)
            text += kNarrowSpace;
        text += plain[i];
    }
    return text;
}

/// Decimals that give a number three significant digits.
int decimalsFor(double number)
{
    const int magnitude = static_cast<int>(std::floor(std::log10(std::fabs(number))));
    return magnitude >= 2 ? 0 : 2 - magnitude;
}

std::string withoutTrailingZeros(std::string text)
{
    if (text.find('.') == std::string::npos)
        return text;
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.')
        text.pop_back();
    return text;
}

} // namespace

std::string wholeNumber(double number)
{
    if (!std::isfinite(number))
        return kDash;
    return grouped(decimals(std::round(number) + 0.0, 0));
}

std::string shortNumber(double number)
{
    if (!std::isfinite(number))
        return kDash;
    if (number == 0.0)
        return "0";
    const double size = std::fabs(number);
    if (size < 1e-4 || size >= 1e9)
        return formatNumber(number, 2);
    return grouped(withoutTrailingZeros(decimals(number, decimalsFor(number))));
}

std::string percentage(double share)
{
    if (!std::isfinite(share))
        return kDash;
    return shortNumber(100.0 * share) + kNarrowSpace + "%";
}

std::string byteCount(double bytes)
{
    constexpr std::array<const char*, 4> units = {"B", "kB", "MB", "GB"};
    if (!std::isfinite(bytes))
        return kDash;
    std::size_t unit = 0;
    // What rounds to a thousand belongs to the next unit.
    for (; unit + 1 < units.size() && bytes >= 999.5; ++unit)
        bytes /= 1000.0;
    return shortNumber(unit == 0 ? std::round(bytes) : bytes) + kNarrowSpace + units[unit];
}

std::string tickLabel(double number)
{
    const double size = std::fabs(number);
    if (number != 0.0 && (size < 1e-4 || size >= 1e9))
        return formatNumber(number, 2);
    if (size >= 1e6)
        return formatNumber(number / 1e6, 4) + kNarrowSpace + "M";
    if (size >= 1e3)
        return formatNumber(number / 1e3, 4) + kNarrowSpace + "k";
    return formatNumber(number, 4);
}

std::string coordinate(double number)
{
    const std::string text = withoutTrailingZeros(decimals(number, 2));
    return text == "-0" ? "0" : text;
}

} // namespace lodsmith::cli
