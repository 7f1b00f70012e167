#pragma once

#include <lodsmith/core/Result.h>
#include <lodsmith/lua/Returned.h>

#include <OgreMesh.h>

#include <cstddef>
#include <string>

namespace lodsmith::lua {

/// What m:info() says of a loaded mesh. Errors: those of MeshReader::read().
Result<Table> meshInfo(const Ogre::Mesh& mesh);

/// Triangles of OGRE's level `level`, 0 for the mesh itself. Errors: NotFound (no such level, a hand-made level that cannot be had).
Result<std::size_t> trianglesOfLevel(const Ogre::Mesh& mesh, double level);

} // namespace lodsmith::lua
