#pragma once

#include <lodsmith/loddef/LodDefinition.h>
#include <lodsmith/lua/Binding.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace lodsmith::lua {

/// A definition that scripts edit. Levels have a number each, so that a script's hold on one survives the others' coming and
/// going.
struct EditedDefinition {
    static constexpr std::size_t kNoLevel = static_cast<std::size_t>(-1);

    explicit EditedDefinition(LodDefinition definition);

    /// Where the level of a number is; kNoLevel when it was removed.
    std::size_t find(std::uint64_t number) const;

    LodDefinition data;
    std::vector<std::uint64_t> numbers; ///< one a level
    std::uint64_t nextNumber = 0;
};

class Definition final : public Handle {
public:
    explicit Definition(LodDefinition definition);

    const LodDefinition& data() const { return mEdited->data; }

    Returned isAutomatic() const { return data().automatic; }
    Returned setAutomatic(bool automatic);
    Returned type() const { return data().type; }
    Returned setType(double type);
    Returned strategy() const { return data().strategy; }
    Returned setStrategy(double strategy);
    Returned metric() const { return data().metric; }
    Returned setMetric(OptionalNumber metric);
    Returned lockBorders() const { return data().lockBorders; }
    Returned setLockBorders(bool lock);
    Returned weight(Text attribute) const;
    Returned setWeight(Text attribute, OptionalNumber weight);

    Returned levelCount() const { return data().levels.size(); }
    Returned level(double index) const;
    Returned addLevel(double value);
    Returned removeLevel(double index);
    Returned sortLevels();

    Returned errors() const;
    Returned copy() const;
    Returned equals(const Definition& other) const { return data() == other.data(); }
    Returned text() const;

private:
    std::shared_ptr<EditedDefinition> mEdited;
};

/// newDefinition() of Lua.
Returned newDefinition();
/// parseDefinition() of Lua.
Returned parseDefinition(Text text, Text name);

} // namespace lodsmith::lua
