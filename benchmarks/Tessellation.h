#pragma once

#include <OgreMesh.h>

#include <cstdint>
#include <string>

namespace lodsmith::benchmarks {

/// Surfaces that can be made at any density, so that time can be followed over the number of triangles.
enum class Surface {
    Planet,  ///< closed: a displaced sphere, its texture in six square charts with seams between them
    Terrain, ///< open: a displaced square with a border
};

/// Makes a mesh of about `triangles` triangles (at least 64) with normals, one texture coordinate set and 32-bit indices.
/// The same arguments give the same mesh. Main thread only.
Ogre::MeshPtr tessellate(const std::string& name, Surface surface, std::uint32_t triangles);

} // namespace lodsmith::benchmarks
