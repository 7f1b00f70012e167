#pragma once

#include <lodsmith/cache/LodCache.h>
#include <lodsmith/core/Export.h>
#include <lodsmith/core/Progress.h>
#include <lodsmith/core/Result.h>
#include <lodsmith/core/Simplify.h>
#include <lodsmith/ogre/AutomaticLods.h>
#include <lodsmith/ogre/LodConfig.h>
#include <lodsmith/ogre/MeshReader.h>
#include <lodsmith/ogre/ProgressiveMeshGenerator.h>

#include <memory>
#include <optional>
#include <vector>

/// Generation as three steps, so that the middle one can run on any thread: prepare, compute, finish. Whoever generates
/// goes this way, at once or through the queue.
namespace lodsmith {

/// What computing needs: plain arrays, and nothing of OGRE's. Can be moved, not copied.
struct PreparedLods {
    MeshData data;
    std::vector<LevelTarget> targets;
    SimplifyOptions options;
    std::shared_ptr<LodCache> cache{}; ///< where chains are kept; null for nowhere
    /// LodConfig::mostLevels, and for each target the size on screen from which on its level may be shown, in any unit.
    unsigned mostLevels = 0;
    std::vector<double> sizes{};
};

/// What was computed: plain arrays again.
struct ComputedLods {
    LodChain chain;
    bool fromCache = false;
    std::optional<Error> notStored{}; ///< it was made, but could not be stored: why
    double orderSeconds = 0.0;        ///< spent ordering index lists for the vertex cache
};

/// automaticLodConfig(), or InvalidSetting for settings out of range, or InvalidGeometry for a mesh without a bounding
/// radius to derive levels from. Main thread.
Result<LodConfig> checkedAutomaticConfig(const Ogre::MeshPtr& mesh, const AutomaticLods& automatic);

/// Checks the configuration and copies the mesh out. Main thread. Errors: those of planLods() and MeshReader::read().
Result<PreparedLods> prepareLods(const LodConfig& config, std::shared_ptr<LodCache> cache);

/// Simplifies, and orders the triangles for the vertex cache, or takes what that gave before from the cache; frees the arrays on
/// the way. Any thread. Errors: those of simplify(), without a file, subMesh its number in the mesh. Exported for the tests,
/// which put it inside a function of their own.
LODSMITH_API Result<ComputedLods> computeLods(PreparedLods& prepared, Progress* progress);

/// Writes the levels onto the mesh. Main thread. Errors: those of MeshWriter::write().
Result<LodReport> finishLods(const LodConfig& config, const PreparedLods& prepared, const ComputedLods& computed);

} // namespace lodsmith
