#pragma once

#include "CommandOptions.h"
#include "DefinitionFiles.h"
#include "JsonRecord.h"
#include "LevelSpec.h"
#include "MeshFile.h"
#include "OgreSession.h"
#include "OutputPlan.h"

#include <lodsmith/core/Progress.h>
#include <lodsmith/core/Simplify.h>
#include <lodsmith/ogre/AutomaticLods.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace lodsmith::cli {

/// What `lodsmith generate` was asked to do with each mesh.
struct GenerateSettings {
    DefinitionChoice definition;   ///< where there is one, levels, strategy, metric, weights and locks are its own
    std::vector<LevelSpec> levels; ///< empty for the automatic configuration
    std::string strategy;          ///< OGRE's name; not used by the automatic configuration
    AutomaticLods automatic;       ///< but for the metric
    bool saysAutomatic = false;    ///< the command line says what automatic levels are like
    std::optional<Metric> metric;  ///< nothing: quadric, and for the automatic configuration its own
    AttributeWeights weights;
    bool lockBorders = false;
    bool lockSeams = false;
    bool shareBuffers = false;
    bool separateMeshes = false; ///< levels of foliage may become meshes of their own, in files beside the output
    unsigned repeat = 1;         ///< >= 1
    unsigned threads = 1;        ///< for one mesh, if it is large
    std::filesystem::path cache; ///< directory that keeps generated levels; empty for none
    WriteOptions write;
};

/// A mesh with its levels, not yet written.
struct GeneratedMesh {
    std::string bytes;                 ///< of the `.mesh` file
    std::vector<Companion> companions; ///< what goes along
    Json record;                       ///< how it went; see docs/cli.md
    FileHashes read;                   ///< everything that it was made of
};

/// Loads a mesh and gives it levels. Errors: those of loading and generating.
Result<GeneratedMesh> generateMesh(const GenerateSettings& settings, const PlannedFile& file, OgreSession& session,
                                   Progress& progress);

/// The record of a mesh that failed: the same members, without values.
Json failedRecord(const PlannedFile& file, const Error& error);

} // namespace lodsmith::cli
