#include "Level.h"

#include <lodsmith/lua/Numbers.h>

#include <utility>

namespace lodsmith::lua {

namespace {

constexpr double kLargestValue = 1e18;

double defaultAmount(LevelTarget::Kind method)
{
    return method == LevelTarget::Kind::Proportional ? LevelTarget().amount : 0.0;
}

/// What the definition's own check says about a level with another value, without the number that it gives it.
Result<Done> checkLevel(LodLevelDefinition level)
{
    level.value = 1.0f;
    LodDefinition definition;
    definition.levels.push_back(std::move(level));
    std::vector<Error> errors = findErrors(definition);
    if (errors.empty())
        return Done{};
    const std::string prefix = "level 1: ";
    if (errors.front().message.compare(0, prefix.size(), prefix) == 0)
        errors.front().message.erase(0, prefix.size());
    return errors.front();
}

bool isAllowed(const LevelTarget& target)
{
    LodLevelDefinition level;
    level.target = target;
    return checkLevel(std::move(level)).ok();
}

Returned setTargetOf(LodLevelDefinition& level, const LevelTarget& target)
{
    LodLevelDefinition changed;
    changed.target = target;
    Result<Done> checked = checkLevel(std::move(changed));
    if (checked)
        level.target = target;
    return checked;
}

} // namespace

Result<Done> checkLevelValue(const LodDefinition& definition, double value, std::size_t except)
{
    const auto number = static_cast<float>(value > 0 && value <= kLargestValue ? value : 0);
    if (!(number > 0))
        return Error{ErrorCode::InvalidSetting,
                     "the value " + numberText(value) + " is not a number above 0 and at most 1e18"};
    for (std::size_t i = 0; i < definition.levels.size(); ++i)
        if (i != except && definition.levels[i].value == number)
            return Error{ErrorCode::InvalidSetting,
                         "the value " + numberText(value) + " is that of level " + std::to_string(i + 1) + " already"};
    return Done{};
}

Level::Level(std::shared_ptr<EditedDefinition> definition, std::uint64_t number)
    : Handle("lodsmith::Level"), mDefinition(std::move(definition)), mNumber(number)
{
}

template <class Work>
Returned Level::withLevel(const Work& work) const
{
    const std::size_t place = mDefinition->find(mNumber);
    if (place == EditedDefinition::kNoLevel)
        return Returned::failure("the level is gone");
    return work(mDefinition->data.levels[place]);
}

Returned Level::value() const
{
    return withLevel([](const LodLevelDefinition& level) -> Returned { return level.value; });
}

Returned Level::setValue(double value)
{
    return withLevel([&](LodLevelDefinition& level) -> Returned {
        Result<Done> checked = checkLevelValue(mDefinition->data, value, mDefinition->find(mNumber));
        if (checked)
            level.value = static_cast<float>(value);
        return checked;
    });
}

Returned Level::method() const
{
    return withLevel([](const LodLevelDefinition& level) -> Returned { return level.target.kind; });
}

Returned Level::setMethod(double method)
{
    return withLevel([&](LodLevelDefinition& level) -> Returned {
        const auto kind = constantFrom(method, LevelTarget::Kind::CollapseCost, "Method");
        if (!kind)
            return kind.error();
        level.target.kind = kind.value();
        if (!isAllowed(level.target))
            level.target.amount = defaultAmount(kind.value());
        return true;
    });
}

Returned Level::amount() const
{
    return withLevel([](const LodLevelDefinition& level) -> Returned { return level.target.amount; });
}

Returned Level::setAmount(double amount)
{
    return withLevel([&](LodLevelDefinition& level) -> Returned {
        return setTargetOf(level, {level.target.kind, amount});
    });
}

Returned Level::setTarget(double method, double amount)
{
    return withLevel([&](LodLevelDefinition& level) -> Returned {
        const auto kind = constantFrom(method, LevelTarget::Kind::CollapseCost, "Method");
        if (!kind)
            return kind.error();
        return setTargetOf(level, {kind.value(), amount});
    });
}

Returned Level::meshName() const
{
    return withLevel([](const LodLevelDefinition& level) -> Returned { return level.meshName; });
}

Returned Level::setMeshName(Text name)
{
    return withLevel([&](LodLevelDefinition& level) -> Returned {
        LodLevelDefinition changed;
        changed.meshName = std::string(name);
        Result<Done> checked = checkLevel(changed);
        if (checked)
            level.meshName = std::move(changed.meshName);
        return checked;
    });
}

Returned Level::isHandMade() const
{
    return withLevel([](const LodLevelDefinition& level) -> Returned { return level.isManual(); });
}

} // namespace lodsmith::lua
