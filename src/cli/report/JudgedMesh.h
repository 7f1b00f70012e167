#pragma once

#include "../../files/TemporaryDirectory.h"
#include "../JsonRecord.h"
#include "../OutputPlan.h"

#include <lodsmith/core/Progress.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace lodsmith::cli {

/// A mesh with the levels by which a report judges it: those in its file, or where it has none those that its
/// definition gives it, or else the automatic ones, in a temporary file.
struct JudgedMesh {
    std::filesystem::path input; ///< the mesh itself
    std::filesystem::path file;
    std::string levelsFrom; ///< "file", "definition" or "automatic"
    std::string definition; ///< its path, where they are from one
    std::vector<std::optional<std::string>>
        stops;                      ///< word for the stop reason of each level; nothing where it is not known
    std::vector<std::string> notes; ///< of generating
    std::optional<TemporaryDirectory> directory = {}; ///< holds `file`, unless that is the mesh's own
};

/// Starts OGRE for a while: to be called in a child process without an OgreSession. Errors: those of loading, and of
/// generateMesh(), writeMeshFiles(); TemporaryDirectory's.
Result<JudgedMesh> judgedMesh(const PlannedFile& mesh, Progress& progress);

} // namespace lodsmith::cli
