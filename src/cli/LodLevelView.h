#pragma once

#include <lodsmith/core/MeshView.h>
#include <lodsmith/core/Result.h>
#include <lodsmith/ogre/MeshReader.h>

#include <OgreMesh.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lodsmith::cli {

/// A generated level of a mesh: the vertex buffers of level 0 with the level's own triangles. The MeshData that it was
/// made from has to outlive it.
struct LodLevelView {
    MeshView view;
    std::vector<std::vector<std::uint32_t>> indices; ///< what the view's submeshes point to
};

/// Copies the triangles of generated level `level`, 1 and up, out of a mesh that `data` was read from. The triangle
/// without area that stands for an empty list is left out. Errors: IndexOutOfRange, Unsupported (a level of strips or
/// fans).
Result<LodLevelView> readLodLevel(const Ogre::Mesh& mesh, const MeshData& data, std::size_t level);

} // namespace lodsmith::cli
