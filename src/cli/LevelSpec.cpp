#include "LevelSpec.h"

#include "Numbers.h"

#include <limits>

namespace lodsmith::cli {

namespace {

// The distance strategies square their values, and a float has to hold the square.
constexpr double kLargestValue = 1e18;

struct Method {
    const char* word;
    LevelTarget::Kind kind;
    double largest;
    bool whole;
    const char* amount;
};

constexpr double kMost = std::numeric_limits<std::uint32_t>::max();
constexpr double kUnbounded = std::numeric_limits<double>::max();

constexpr Method kMethods[] = {
    {"proportional", LevelTarget::Kind::Proportional, 1.0, false, "the share of the vertices removed, 0 to 1"},
    {"constant", LevelTarget::Kind::Constant, kMost, true, "the number of vertices removed, 0 to 4294967295"},
    {"triangles", LevelTarget::Kind::Triangles, kMost, true, "the number of triangles kept, 0 to 4294967295"},
    {"deviation", LevelTarget::Kind::Deviation, kUnbounded, false, "a length in world units, 0 or more"},
    {"collapsecost", LevelTarget::Kind::CollapseCost, kUnbounded, false, "a length in world units, 0 or more"},
};

Error invalid(std::string message)
{
    return Error{ErrorCode::InvalidSetting, std::move(message)};
}

std::string quoted(std::string_view text)
{
    return "'" + std::string(text) + "'";
}

const Method* findMethod(std::string_view word)
{
    for (const Method& method : kMethods)
        if (word == method.word)
            return &method;
    return nullptr;
}

std::optional<double> parseAmount(const Method& method, std::string_view text)
{
    std::optional<double> amount;
    if (method.whole) {
        if (const auto count = parseCount(text))
            amount = static_cast<double>(*count);
    } else {
        amount = parseNumber(text);
    }
    return amount && *amount >= 0.0 && *amount <= method.largest ? amount : std::nullopt;
}

Result<LevelSpec> withTarget(LevelSpec level, std::string_view amountText, std::string_view whole)
{
    const Method* method = findMethod(level.method);
    if (!method)
        return invalid(
            quoted(level.method) + " in level " + quoted(whole)
            + " is no method; there are proportional, constant, triangles, deviation, collapsecost and mesh");
    const std::optional<double> amount = parseAmount(*method, amountText);
    if (!amount)
        return invalid(quoted(amountText) + " in level " + quoted(whole) + " is no amount for " + level.method
                       + ", which takes " + method->amount);
    level.target = {method->kind, *amount};
    return level;
}

std::vector<std::string_view> split(std::string_view text, char separator)
{
    std::vector<std::string_view> parts;
    for (std::size_t begin = 0;;) {
        const std::size_t end = text.find(separator, begin);
        parts.push_back(text.substr(begin, end - begin));
        if (end == std::string_view::npos)
            return parts;
        begin = end + 1;
    }
}

bool inOrder(float before, float after, LevelOrder order)
{
    return order == LevelOrder::Rising ? before < after : before > after;
}

} // namespace

Result<LevelSpec> parseLevelSpec(std::string_view text)
{
    const std::size_t first = text.find(':');
    const std::size_t second = first == std::string_view::npos ? first : text.find(':', first + 1);
    if (second == std::string_view::npos)
        return invalid("level " + quoted(text) + " is not of the form VALUE:METHOD:AMOUNT or VALUE:mesh:FILE");

    const std::optional<double> value = parseNumber(text.substr(0, first));
    if (!value || static_cast<float>(*value) <= 0.0f || *value > kLargestValue)
        return invalid(quoted(text.substr(0, first)) + " in level " + quoted(text)
                       + " is no strategy value; it takes a number above 0 and up to 1e18");

    LevelSpec level;
    level.value = static_cast<float>(*value);
    level.method = std::string(text.substr(first + 1, second - first - 1));
    const std::string_view rest = text.substr(second + 1);
    if (level.method != "mesh")
        return withTarget(std::move(level), rest, text);
    if (rest.empty())
        return invalid("level " + quoted(text) + " names no mesh file");
    level.meshFile = std::string(rest);
    return level;
}

Result<std::vector<LevelSpec>> parseLevelSpecs(std::string_view text, LevelOrder order)
{
    std::vector<LevelSpec> levels;
    for (const std::string_view part : split(text, ',')) {
        Result<LevelSpec> level = parseLevelSpec(part);
        if (!level)
            return level.error();
        if (!levels.empty() && !inOrder(levels.back().value, level.value().value, order))
            return invalid("level " + quoted(part) + " does not follow the one before: levels come nearest first, with "
                           + (order == LevelOrder::Rising ? "rising distances" : "falling pixel counts"));
        levels.push_back(std::move(level).value());
    }
    return levels;
}

} // namespace lodsmith::cli
