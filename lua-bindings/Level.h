#pragma once

#include "Definition.h"

namespace lodsmith::lua {

/// A level of a definition, wherever it stands by now; it knows when it was removed.
class Level final : public Handle {
public:
    Level(std::shared_ptr<EditedDefinition> definition, std::uint64_t number);

    Returned value() const;
    Returned setValue(double value);
    Returned method() const;
    Returned setMethod(double method);
    Returned amount() const;
    Returned setAmount(double amount);
    Returned setTarget(double method, double amount);
    Returned meshName() const;
    Returned setMeshName(Text name);
    Returned isHandMade() const;

private:
    template <class Work>
    Returned withLevel(const Work& work) const;

    std::shared_ptr<EditedDefinition> mDefinition;
    std::uint64_t mNumber;
};

/// What is wrong with a value for a level of the definition, out of range or there already; success when nothing is.
/// @param except the level that may have it
Result<Done> checkLevelValue(const LodDefinition& definition, double value,
                             std::size_t except = EditedDefinition::kNoLevel);

} // namespace lodsmith::lua
