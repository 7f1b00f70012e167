#pragma once

#include "Generation.h"

#include <optional>

namespace lodsmith::cli {

/// How the meshes of one run are made, beside what they become.
struct BuildRules {
    Json options = Json::object(); ///< what the command line says about the meshes, for their records
    bool force = false;            ///< make everything again, whatever is there
};

/// What is known of an output that is as this run would make it: the members of `generate --json`, without paths and times.
/// Nothing when it has to be made. Reads and hashes, and writes nothing.
std::optional<Json> upToDate(const PlannedFile& file, const BuildRules& rules);

/// Makes one mesh: loads it, gives it levels, writes it and its record. An output that is its own input has none.
/// Errors: those of generateMesh() and of writing.
Result<Json> buildMesh(const GenerateSettings& settings, const BuildRules& rules, const PlannedFile& file,
                       OgreSession& session, Progress& progress);

} // namespace lodsmith::cli
