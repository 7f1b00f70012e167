#pragma once

#include <OgreAxisAlignedBox.h>
#include <OgreVector.h>

#include <cstdint>
#include <functional>
#include <vector>

namespace lodsmith::media {

/// A closed surface of evenly sized triangles.
struct SurfaceMesh {
    std::vector<Ogre::Vector3> positions;
    std::vector<Ogre::Vector3> normals; ///< unit length, outwards
    std::vector<std::uint32_t> indices;
};

/// Distance to a surface, or something like it: negative inside, smooth.
using Field = std::function<float(const Ogre::Vector3&)>;

/// Unit vector away from the surface.
Ogre::Vector3 fieldNormal(const Field& field, const Ogre::Vector3& position);

/// Follows the zero surface of `field` inside `box` (surface nets, Gibson 1998), then evens the triangles out while
/// keeping the vertices on the surface.
/// @param cell  edge of a grid cell, metres: about the length of the triangles' edges
/// @throws std::runtime_error when the surface leaves the box or is pinched, so that an edge has not two triangles
SurfaceMesh followSurface(const Field& field, const Ogre::AxisAlignedBox& box, float cell);

} // namespace lodsmith::media
