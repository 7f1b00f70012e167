#pragma once

#include <lodsmith/core/Export.h>
#include <lodsmith/core/Simplify.h>
#include <lodsmith/ogre/LodLevel.h>

#include <OgreMesh.h>

#include <string>
#include <vector>

namespace lodsmith {

/// Everything a generator needs to know: which mesh, which levels, how.
struct LodConfig {
    Ogre::MeshPtr mesh;
    /// Name of a strategy that OGRE knows: distance_sphere, distance_box, pixel_count, screen_ratio_pixel_count or one that the
    /// program has added.
    Ogre::String strategy = "distance_sphere";
    /// Levels 1 and up, nearest first: values rise for distances and fall for pixel counts.
    std::vector<LodLevel> levels;
    SimplifyOptions options;
    /// Lets two neighbouring generated levels keep their triangles in one index buffer a submesh, one behind the other, for
    /// half as many buffers. Mesh files keep it so.
    bool shareIndexBuffers = false;
    /// How much each submesh counts, by its number in the mesh; those beyond the end count 0. 0..1, as
    /// VertexBufferView::importance: deviation counts 1/(1-x) times as much on all its vertices, and 1 locks them. A vertex of
    /// several submeshes takes the greatest.
    std::vector<float> subMeshImportance = {};
    /// Manual levels reach living entities only when these are initialised again (Ogre::Entity::_initialise()), as OGRE does
    /// itself when a mesh is loaded again: their sub-entities, animation states and skeleton instances are made anew, so that
    /// pointers to these end and materials come from the mesh, and what was attached to bones is detached. Off: a mesh that
    /// has living entities gets no manual levels, and after manual ones no others (Unsupported).
    bool reinitialiseEntities = false;
};

/// What automatic levels are like. The defaults need no thought.
struct AutomaticLods {
    static constexpr unsigned kMaxLevels = 8;
    static constexpr double kMinQuality = 0.1;
    static constexpr double kMaxQuality = 10.0;

    Metric metric = Metric::Curvature;
    /// How many, 1..kMaxLevels. Fewer than four leave out the nearest ones, which save least; more than four go on towards
    /// the horizon.
    unsigned levels = 4;
    /// kMinQuality..kMaxQuality. At 2 each level appears at half the radius on screen, so that its error is half as many
    /// pixels; at 0.5 at twice the radius. The levels themselves stay the same.
    double quality = 1.0;
};

/// The automatic configuration of a mesh: levels by pixel_count and LevelTarget::Kind::CollapseCost, which come from a row of
/// sizes, i = 2, 3, 4...: pixels 3388608 / i^4 / quality^2. The levels are the last of i = 2..max(5, levels + 1). What a
/// collapse may cost, R being the mesh's bounding sphere radius:
///
/// - Metric::Curvature: R * i^5 / 100000 up to i = 5, R * i^2 / 800 beyond. The defaults are therefore levels at 211788, 41835,
///   13237 and 5422 pixels with costs of R/3125, R/411, R/97.7 and R/32. Beyond the fourth level the cost stays the same
///   number of pixels.
/// - Metric::Quadric: half a pixel when the level appears at quality 1, R * i^2 / 2077. (With the costs above the nearest level
///   would save next to nothing, and the fourth be far off on some meshes: docs/runtime.md has figures.)
///
/// pixel_count is the area on screen of a disc of the bounding radius that faces the camera at the entity's node: a level
/// appears when the disc has a radius of sqrt(pixels / pi), by default 260, 115, 65 and 42 pixels. OGRE computes that as
/// R * scale / distance from the camera to the node, times half the viewport's height, times cot(vertical field of view / 2);
/// under an orthographic camera it is R * scale in pixels. R counts from the mesh's origin. This holds from OGRE 1.12.6 on,
/// and for cameras that have their viewport's aspect ratio.
///
/// The mesh's bounds must be set; settings out of range are misuse. Main thread only, as MeshReader.
LODSMITH_API LodConfig automaticLodConfig(const Ogre::MeshPtr& mesh, const AutomaticLods& automatic = {});

/// What is out of range, as a sentence; empty when nothing is.
LODSMITH_API std::string troubleWith(const AutomaticLods& automatic);

} // namespace lodsmith
