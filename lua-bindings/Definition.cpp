#include "Definition.h"

#include "Level.h"
#include <lodsmith/lua/Numbers.h>

#include <lodsmith/loddef/LoddefXml.h>

#include <algorithm>
#include <limits>
#include <numeric>

namespace lodsmith::lua {

namespace {

struct Attribute {
    const char* name;
    std::optional<float> GivenAttributeWeights::*member;
};

constexpr Attribute kAttributes[] = {
    {"normal", &GivenAttributeWeights::normal},
    {"uv", &GivenAttributeWeights::uv},
    {"colour", &GivenAttributeWeights::colour},
    {"bone", &GivenAttributeWeights::bone},
};

Result<const Attribute*> findAttribute(Text name)
{
    for (const Attribute& attribute : kAttributes)
        if (name == attribute.name)
            return &attribute;
    return Error{ErrorCode::InvalidSetting,
                 "there is no weight for \"" + std::string(name) + "\"; there are normal, uv, colour and bone"};
}

/// Puts a constant into its place.
template <class Constant>
Returned setConstant(Constant& place, double number, Constant last, const char* table)
{
    const Result<Constant> constant = constantFrom(number, last, table);
    if (!constant)
        return constant.error();
    place = constant.value();
    return true;
}

} // namespace

EditedDefinition::EditedDefinition(LodDefinition definition)
    : data(std::move(definition)), numbers(data.levels.size()), nextNumber(data.levels.size())
{
    std::iota(numbers.begin(), numbers.end(), std::uint64_t(0));
}

std::size_t EditedDefinition::find(std::uint64_t number) const
{
    const auto place = std::find(numbers.begin(), numbers.end(), number);
    return place == numbers.end() ? kNoLevel : static_cast<std::size_t>(place - numbers.begin());
}

Definition::Definition(LodDefinition definition)
    : Handle("lodsmith::Definition"), mEdited(std::make_shared<EditedDefinition>(std::move(definition)))
{
}

Returned Definition::setAutomatic(bool automatic)
{
    mEdited->data.automatic = automatic;
    return true;
}

Returned Definition::setType(double type)
{
    return setConstant(mEdited->data.type, type, LodDefinitionType::User, "Type");
}

Returned Definition::setStrategy(double strategy)
{
    return setConstant(mEdited->data.strategy, strategy, LodStrategy::ScreenRatioPixelCount, "Strategy");
}

Returned Definition::setMetric(OptionalNumber metric)
{
    if (!metric) {
        mEdited->data.metric.reset();
        return true;
    }
    const Result<Metric> constant = constantFrom(*metric, Metric::Curvature, "Metric");
    if (!constant)
        return constant.error();
    mEdited->data.metric = constant.value();
    return true;
}

Returned Definition::setLockBorders(bool lock)
{
    mEdited->data.lockBorders = lock;
    return true;
}

Returned Definition::weight(Text attribute) const
{
    const Result<const Attribute*> found = findAttribute(attribute);
    if (!found)
        return found.error();
    return data().weights.*found.value()->member;
}

Returned Definition::setWeight(Text attribute, OptionalNumber weight)
{
    const Result<const Attribute*> found = findAttribute(attribute);
    if (!found)
        return found.error();
    if (weight && !(*weight >= 0 && *weight <= double(std::numeric_limits<float>::max())))
        return Returned::failure("the weight " + numberText(*weight) + " is not a number of 0 or more");
    auto& place = mEdited->data.weights.*found.value()->member;
    place = weight ? std::optional<float>(static_cast<float>(*weight)) : std::nullopt;
    return true;
}

Returned Definition::level(double index) const
{
    const Result<std::size_t> position = positionFrom(index, data().levels.size(), "level");
    if (!position)
        return position.error();
    return std::make_unique<Level>(mEdited, mEdited->numbers[position.value()]);
}

Returned Definition::addLevel(double value)
{
    LodDefinition& definition = mEdited->data;
    if (definition.levels.size() >= kMaxLoddefLevels)
        return Returned::failure("there are " + std::to_string(kMaxLoddefLevels) + " levels, and no more are possible");
    if (const Result<Done> checked = checkLevelValue(definition, value); !checked)
        return checked;
    LodLevelDefinition level;
    level.value = static_cast<float>(value);
    mEdited->numbers.push_back(mEdited->nextNumber);
    definition.levels.push_back(std::move(level));
    return std::make_unique<Level>(mEdited, mEdited->nextNumber++);
}

Returned Definition::removeLevel(double index)
{
    const Result<std::size_t> position = positionFrom(index, data().levels.size(), "level");
    if (!position)
        return position.error();
    const auto offset = static_cast<std::ptrdiff_t>(position.value());
    mEdited->data.levels.erase(mEdited->data.levels.begin() + offset);
    mEdited->numbers.erase(mEdited->numbers.begin() + offset);
    return true;
}

Returned Definition::sortLevels()
{
    const std::vector<LodLevelDefinition> sorted = levelsNearestFirst(data());
    std::vector<std::uint64_t> numbers;
    for (const LodLevelDefinition& level : sorted) {
        // No two values are alike.
        const auto before = std::find_if(data().levels.begin(), data().levels.end(),
                                         [&](const LodLevelDefinition& other) { return other.value == level.value; });
        numbers.push_back(mEdited->numbers[static_cast<std::size_t>(before - data().levels.begin())]);
    }
    mEdited->data.levels = sorted;
    mEdited->numbers = std::move(numbers);
    return true;
}

Returned Definition::errors() const
{
    Table sentences;
    for (const Error& error : findErrors(data()))
        sentences.add(describe(error));
    return sentences;
}

Returned Definition::copy() const
{
    return std::make_unique<Definition>(data());
}

Returned Definition::text() const
{
    const Result<std::string> text = loddefText(data());
    if (!text)
        return text.error();
    return text.value();
}

Returned newDefinition()
{
    return std::make_unique<Definition>(LodDefinition());
}

Returned parseDefinition(Text text, Text name)
{
    LoddefReading reading = parseLoddef(text, std::string(name));
    if (!reading.ok())
        return Returned::failures(reading.errors);
    return std::make_unique<Definition>(std::move(*reading.definition));
}

} // namespace lodsmith::lua
