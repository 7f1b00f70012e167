#pragma once

#include <lodsmith/core/Result.h>

#include <OgreMesh.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace lodsmith::cli {

/// What an import brought into a mesh.
struct ImportReport {
    std::size_t subMeshes = 0;
    std::size_t vertices = 0; ///< in the buffers
    std::size_t triangles = 0;
    std::vector<std::string> notes; ///< what was left out or made up
};

/// Fills an empty mesh from a model file of any format that assimp reads.
///
/// Each mesh of each node becomes a submesh with the node's transform applied: positions, normals (made where missing,
/// edges above 60 degrees hard), up to eight UV sets with OGRE's v downwards, colours, and the material's name. Indices
/// have 16 bits where that is enough. Bones, animations and the materials themselves are left out and noted. Errors:
/// NotFound, Io, BadFile (assimp's own words), Unsupported (no triangles), InvalidGeometry (a position that is not
/// finite, with submesh and vertex); file is the path.
Result<ImportReport> importModel(const std::filesystem::path& path, Ogre::Mesh& mesh);

} // namespace lodsmith::cli
