#pragma once

#include <lodsmith/core/Export.h>
#include <lodsmith/core/Simplify.h>
#include <lodsmith/ogre/LodLevel.h>

#include <OgreMesh.h>

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
};

/// The automatic configuration, which needs no settings: four levels by pixel_count (pixels of the bounding sphere on screen)
/// and by LevelTarget::Kind::CollapseCost, for i = 2..5 pixels 3388608 / i^4 and cost R * i^5 / 100000, R the mesh's
/// bounding sphere radius. That is 211788, 41835, 13237 and 5422 pixels (circles of radius 260, 115, 65 and 42) and
/// R/3125, R/411, R/97.7 and R/32. The metric is Metric::Curvature, for whose costs the formula was made.
///
/// The mesh's bounds must be set. Main thread only, as MeshReader.
LODSMITH_API LodConfig automaticLodConfig(const Ogre::MeshPtr& mesh);

} // namespace lodsmith
