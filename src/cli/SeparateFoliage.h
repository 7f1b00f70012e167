#pragma once

#include "MeshFile.h"
#include "MeshPlan.h"
#include "OutputPlan.h"

#include <lodsmith/core/Result.h>
#include <lodsmith/ogre/ProgressiveMeshGenerator.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace lodsmith::cli {

/// A level of a mesh with foliage.
struct FoliageRecord {
    double kept = 1.0;          ///< CoverageMeter's, of the level as it is stored
    double keptByIndices = 1.0; ///< of the generated level
    std::string file{};         ///< name of the mesh that stands for it; empty for a generated one
    std::uint32_t vertices = 0; ///< of that mesh, in use
    std::uint32_t triangles = 0;
    std::size_t bytes = 0; ///< of that mesh's file
};

/// What became of a mesh's foliage. Empty for a mesh without.
struct FoliageReport {
    std::map<std::size_t, FoliageRecord> levels; ///< by number in LodReport::levels, generated and stored ones
    std::vector<Companion> files;                ///< to be written beside the output
    std::vector<std::string> notes;
};

/// "tree.lod2.mesh" for level 2 of "out/tree.mesh".
std::string separateName(const std::filesystem::path& output, std::size_t level);

/// The stem of the output that a file would be a level of by its name ("tree" for "tree.lod2.mesh"); empty for other
/// names.
std::string stemOfSeparate(const std::filesystem::path& file);

/// Measures how much of the original's outline the generated levels of a mesh with foliage keep. Where that is less
/// than 95 % and `permitted`, puts a mesh of its own in the level's place if that keeps more; else a note says so.
/// Errors: those of reading, of foliageLevels() and makeFoliageMesh(), InvalidSetting (a hand-made level has the file's
/// name).
///
/// @param plan with levels as they have been generated on plan.config.mesh
Result<FoliageReport> treatFoliage(const MeshPlan& plan, const LodReport& report, const PlannedFile& file,
                                   const MeshFormat& format, bool permitted, Progress& progress);

} // namespace lodsmith::cli
