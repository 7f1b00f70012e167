#include "CostConstants.h"

#include "Numbers.h"

#include <optional>
#include <set>
#include <vector>

namespace lodsmith::cli {

namespace {

struct NumberName {
    const char* name;
    double StreamingCostSettings::*member;
};

struct ChoiceName {
    const char* name;
    bool StreamingCostSettings::*member;
};

constexpr NumberName kNumbers[] = {
    {"metadata_discount", &StreamingCostSettings::metadataDiscount},
    {"minimum_bytes", &StreamingCostSettings::minimumBytes},
    {"bytes_per_triangle", &StreamingCostSettings::bytesPerTriangle},
    {"triangle_budget", &StreamingCostSettings::triangleBudget},
    {"budget_cost", &StreamingCostSettings::budgetCost},
    {"largest_area", &StreamingCostSettings::largestArea},
    {"smallest_area", &StreamingCostSettings::smallestArea},
    {"largest_distance", &StreamingCostSettings::largestDistance},
};

constexpr ChoiceName kChoices[] = {
    {"free_without_lowest", &StreamingCostSettings::freeWithoutLowest},
    {"charge_duplicates", &StreamingCostSettings::chargeDuplicates},
};

constexpr const char* kRatios = "switch_ratios";

Error invalid(std::string message)
{
    return Error{ErrorCode::InvalidSetting, std::move(message)};
}

std::vector<std::string> split(const std::string& text, char separator)
{
    std::vector<std::string> parts(1);
    for (const char c : text)
        if (c == separator)
            parts.emplace_back();
        else
            parts.back() += c;
    return parts;
}

Result<Done> setNumber(const std::string& text, double& target)
{
    const std::optional<double> number = parseNumber(text);
    if (!number)
        return invalid("'" + text + "' is no number");
    target = *number;
    return Done{};
}

Result<Done> setChoice(const std::string& text, bool& target)
{
    if (text != "yes" && text != "no")
        return invalid("'" + text + "' is neither yes nor no");
    target = text == "yes";
    return Done{};
}

Result<Done> setRatios(const std::string& text, std::vector<double>& ratios)
{
    ratios.clear();
    for (const std::string& part : split(text, '/'))
        if (Result<Done> set = setNumber(part, ratios.emplace_back()); !set)
            return set;
    return Done{};
}

Result<Done> setConstant(const std::string& name, const std::string& value, StreamingCostSettings& settings)
{
    for (const NumberName& number : kNumbers)
        if (name == number.name)
            return setNumber(value, settings.*number.member);
    for (const ChoiceName& choice : kChoices)
        if (name == choice.name)
            return setChoice(value, settings.*choice.member);
    if (name == kRatios)
        return setRatios(value, settings.switchRatios);
    std::string names = kRatios;
    for (const NumberName& number : kNumbers)
        names += std::string(", ") + number.name;
    for (const ChoiceName& choice : kChoices)
        names += std::string(", ") + choice.name;
    return invalid("'" + name + "' is no constant; there are " + names);
}

} // namespace

Result<Done> setCostConstants(const std::string& text, StreamingCostSettings& settings)
{
    std::set<std::string> seen;
    for (const std::string& part : split(text, ',')) {
        const std::size_t equals = part.find('=');
        if (equals == std::string::npos)
            return invalid("'" + part + "' is not NAME=VALUE");
        const std::string name = part.substr(0, equals);
        if (!seen.insert(name).second)
            return invalid("'" + name + "' is there twice");
        if (Result<Done> set = setConstant(name, part.substr(equals + 1), settings); !set)
            return set;
    }
    if (const std::string trouble = troubleWith(settings); !trouble.empty())
        return invalid(trouble);
    return Done{};
}

} // namespace lodsmith::cli
