#include "Numbers.h"

#include "../loddef/NumberText.h"

#include <cstdio>

namespace lodsmith::cli {

std::optional<double> parseNumber(std::string_view text)
{
    return plainNumberFromText<double>(text);
}

std::optional<std::uint64_t> parseCount(std::string_view text)
{
    return plainNumberFromText<std::uint64_t>(text);
}

std::string formatNumber(double number, int digits)
{
    char text[64];
    std::snprintf(text, sizeof text, "%.*g", digits, number);
    return text;
}

} // namespace lodsmith::cli
