#pragma once

#include "OutputPlan.h"

#include <lodsmith/core/Result.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace lodsmith::cli {

/// Which `.loddef` file says what levels a mesh gets.
struct DefinitionChoice {
    std::string given;  ///< for all meshes; empty: each mesh has the one beside it, if any
    bool beside = true; ///< whether a file beside a mesh counts
    bool waits = false; ///< whether it gives way to levels that the command line states
};

/// The definition beside a mesh, by loddefFileName(); nothing when there is none.
std::optional<std::filesystem::path> definitionBeside(const std::filesystem::path& mesh);

/// The definition that a mesh's levels come from; nothing when they come from elsewhere.
std::optional<std::filesystem::path> chosenDefinition(const DefinitionChoice& choice,
                                                      const std::filesystem::path& mesh);

/// The file of a hand-made level: by its name beside the mesh, failing that beside the definition.
/// Errors: InvalidSetting (the name leads out of these directories), NotFound; file is the definition.
Result<std::filesystem::path> findHandMade(const std::string& name, const std::filesystem::path& mesh,
                                           const std::filesystem::path& definition);

/// A plan without the inputs that definitions of other inputs name as hand-made levels: they go along with those as they
/// are, and OGRE allows them no levels of their own.
std::vector<PlannedFile> withoutHandMade(std::vector<PlannedFile> plan, const DefinitionChoice& choice);

} // namespace lodsmith::cli
