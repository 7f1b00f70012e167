#pragma once

#include <lodsmith/core/Export.h>
#include <lodsmith/core/LodChain.h>
#include <lodsmith/core/Progress.h>
#include <lodsmith/core/Result.h>
#include <lodsmith/ogre/AutomaticLods.h>
#include <lodsmith/ogre/LodConfig.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace lodsmith {

class LodCache;

/// What generation did with one level of the configuration, level 1 first.
struct LodLevelReport {
    Ogre::Real value = 0;
    bool manual = false;
    std::uint32_t vertices = 0; ///< welded; 0 for a manual level
    std::uint32_t triangles = 0;
    double deviation = 0.0; ///< bound, world units
    bool skipped = false;   ///< same vertices as the level before: not stored
    StopReason stop = StopReason::TargetReached;
};

/// What generation did with one mesh.
struct LodReport {
    std::uint32_t vertices = 0;       ///< of level 0, welded
    std::uint32_t bufferVertices = 0; ///< of level 0
    std::uint32_t triangles = 0;      ///< of level 0
    double radius = 0.0;              ///< world units: farthest referenced position from the bounding box's centre
    CleaningReport cleaned;
    std::vector<std::string> notes; ///< submeshes left alone, things converted
    std::vector<LodLevelReport> levels;
    double orderSeconds = 0.0; ///< spent ordering index buffers for the vertex cache; 0 when they came from the cache
    bool fromCache = false;    ///< the generated levels were taken from the cache
    std::optional<Error> notStored{}; ///< there is a cache, but they could not be stored in it: why
};

/// Makes LOD levels and attaches them to the mesh, where and when it is called.
///
///     lodsmith::LodConfig config;
///     config.mesh = mesh;
///     config.levels.push_back({20.0f, {lodsmith::LevelTarget::Kind::Proportional, 0.5}, ""});
///     auto report = lodsmith::ProgressiveMeshGenerator().generateLodLevels(config);
///     if (!report) log(describe(report.error()));
///
/// Main thread only, as MeshReader. On an error the mesh is as it was.
class LODSMITH_API ProgressiveMeshGenerator {
public:
    /// @param cache where generated levels are looked for and kept, docs/cache.md; null for nowhere
    explicit ProgressiveMeshGenerator(std::shared_ptr<LodCache> cache = nullptr);

    /// Checks the configuration, reads the mesh, simplifies the generated levels in one pass, orders their triangles for the
    /// vertex cache and writes them. Errors: those of MeshReader::read(), simplify() and
    /// MeshWriter::write(); file is the mesh's name, subMesh its number in the mesh.
    Result<LodReport> generateLodLevels(const LodConfig& config, Progress* progress = nullptr);

    /// generateLodLevels() with automaticLodConfig(mesh, automatic). Errors: the same, InvalidSetting for settings out of
    /// range, and InvalidGeometry without a bounding radius.
    Result<LodReport> generateAutoconfiguredLodLevels(const Ogre::MeshPtr& mesh, Progress* progress = nullptr,
                                                      const AutomaticLods& automatic = {});

private:
    std::shared_ptr<LodCache> mCache;
};

} // namespace lodsmith
