#pragma once

#include <lodsmith/core/Export.h>
#include <lodsmith/core/Result.h>
#include <lodsmith/core/Simplify.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace lodsmith {

/// What decides which level is shown: the four strategies of OGRE 1.12.
enum class LodStrategy {
    /// Length of a tangent from the camera to the bounding sphere, world units; values rise from level to level.
    DistanceSphere,
    DistanceBox,           ///< distance from the bounding box, world units; values rise
    PixelCount,            ///< pixels of the bounding sphere on screen; values fall
    ScreenRatioPixelCount, ///< those pixels as a share of the viewport's; values fall
};

/// The name under which OGRE knows a strategy ("distance_sphere").
LODSMITH_API const char* ogreName(LodStrategy strategy);

/// Whether a definition is meant for reduced levels or for hand-made ones.
enum class LodDefinitionType {
    Automatic, ///< levels are reduced by the generator; single ones may be hand-made
    User,      ///< all levels are hand-made
};

/// One level of a definition, level 1 or up.
struct LodLevelDefinition {
    /// From which distance on, or below how many pixels, the level is shown: what the strategy's user means, never OGRE's
    /// transformed value. Above 0, at most 1e18, no two levels of a definition alike.
    float value = 0.0f;
    /// How far the mesh is reduced. Proportional 0..1; Constant and Triangles 0..4294967295, Triangles whole; Deviation
    /// and CollapseCost finite, 0 or more. Means nothing in a hand-made level.
    LevelTarget target;
    /// Resource name of a hand-made mesh, failing that a path relative to the definition's file; empty for a reduced
    /// level. At most 1024 bytes of UTF-8, without control characters and without blanks around it.
    std::string meshName;
    /// The XML the level was read from; empty for a new one. What it holds beyond this structure is kept when written.
    std::string original;

    bool isManual() const { return !meshName.empty(); }
};

/// How much each submesh counts. The same measure as VertexBufferView::importance, for all vertices of a submesh.
struct SubMeshImportance {
    std::uint16_t subMesh = 0; ///< OGRE's number, from 0
    /// 0..1; deviation counts 1 / (1 - importance) times as much, and 1 locks the submesh. A vertex of several submeshes
    /// takes the greatest.
    float importance = 0.0f;
};

/// AttributeWeights of which each may be left to its default.
struct GivenAttributeWeights {
    std::optional<float> normal; ///< this and all others: finite, 0 or more
    std::optional<float> uv;
    std::optional<float> colour;
    std::optional<float> bone;

    bool any() const { return normal || uv || colour || bone; }
};

/// What is written beside a mesh about its levels of detail (docs/loddef.md). Plain data; the defaults are those of a
/// file that says nothing (`<lod/>`).
struct LodDefinition {
    /// Levels come from the automatic configuration, and everything below waits until that is switched off.
    bool automatic = true;
    LodDefinitionType type = LodDefinitionType::Automatic;
    LodStrategy strategy = LodStrategy::DistanceSphere;
    /// At most kMaxLoddefLevels, in the order of the file, which means nothing: see levelsNearestFirst(). None means that
    /// the mesh gets no levels.
    std::vector<LodLevelDefinition> levels;
    std::optional<Metric> metric;  ///< none: see simplifyOptions()
    GivenAttributeWeights weights; ///< for Metric::Quadric only
    bool lockBorders = false;
    std::vector<SubMeshImportance> subMeshes; ///< no submesh twice; those that are not named have importance 0
    /// The XML of the file it was read from; empty for a new one. What it holds beyond this structure (comments, elements
    /// and attributes that this library does not know) is kept in its place when written.
    std::string original;
};

constexpr std::size_t kMaxLoddefLevels = 256;
constexpr std::size_t kMaxMeshNameBytes = 1024;

/// Whether two definitions mean the same: `original` does not count, nor does the target of a hand-made level.
LODSMITH_API bool operator==(const LodDefinition& a, const LodDefinition& b);
inline bool operator!=(const LodDefinition& a, const LodDefinition& b)
{
    return !(a == b);
}

/// Everything that is out of range, double or contradictory, one InvalidSetting each; empty for a definition in order.
LODSMITH_API std::vector<Error> findErrors(const LodDefinition& definition);

/// The levels of a definition in order, as a LodConfig wants them: rising distances, falling pixel counts.
LODSMITH_API std::vector<LodLevelDefinition> levelsNearestFirst(const LodDefinition& definition);

/// Options for the reduced levels, with defaults where the definition says nothing. Without a metric it is
/// Metric::Curvature when a reduced level has a CollapseCost target, for whose costs that was made, and
/// Metric::Quadric otherwise.
LODSMITH_API SimplifyOptions simplifyOptions(const LodDefinition& definition);

} // namespace lodsmith
