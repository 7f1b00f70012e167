#pragma once

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
    /// Manual levels reach living entities only when these are initialised again (Ogre::Entity::_initialise()), as OGRE does
    /// itself when a mesh is loaded again: their sub-entities, animation states and skeleton instances are made anew, so that
    /// pointers to these end and materials come from the mesh, and what was attached to bones is detached. Off: a mesh that
    /// has living entities gets no manual levels, and after manual ones no others (Unsupported).
    bool reinitialiseEntities = false;
    /// Above 0 `levels`, all of them generated, are candidates: at most so many are stored, those that leave the fewest triangles to
    /// draw while the mesh recedes (chooseLevels() in analysis/LevelChoice.h); the others are reported as skipped. 0 stores
    /// all that differ.
    unsigned mostLevels = 0;
};

} // namespace lodsmith
