#pragma once

#include <OgreQuaternion.h>
#include <OgreVector.h>

#include <cstdint>
#include <string>
#include <vector>

namespace lodsmith::media {

struct Vertex {
    Ogre::Vector3 position;
    Ogre::Vector3 normal;
    Ogre::Vector2 uv;
};

/// Triangles of one material. Lengths are metres, Y is up; fronts are counter-clockwise.
struct Shape {
    std::string material;
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;

    std::uint32_t add(const Vertex& vertex)
    {
        vertices.push_back(vertex);
        return static_cast<std::uint32_t>(vertices.size() - 1);
    }
    void addTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) { indices.insert(indices.end(), {a, b, c}); }
    void addQuad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d)
    {
        addTriangle(a, b, c);
        addTriangle(a, c, d);
    }
    void append(const Shape& other);
};

/// Where a part stands in its model.
struct Placement {
    Ogre::Vector3 position = Ogre::Vector3::ZERO;
    Ogre::Quaternion orientation = Ogre::Quaternion::IDENTITY;
};

/// A flat quad with its own four corners, normal and texture coordinates `uvScale` a metre along its first two edges.
void addFlatQuad(Shape& shape, const Ogre::Vector3& a, const Ogre::Vector3& b, const Ogre::Vector3& c,
                 const Ogre::Vector3& d, float uvScale);

/// A flat triangle, in the same way.
void addFlatTriangle(Shape& shape, const Ogre::Vector3& a, const Ogre::Vector3& b, const Ogre::Vector3& c,
                     float uvScale);

/// A box with flat chamfers, the texture laid on each face from its own side.
/// @param size     full lengths along the box's axes
/// @param chamfer  width taken off every edge; less than half of the least length
void addBox(Shape& shape, const Placement& placement, const Ogre::Vector3& size, float chamfer, float uvScale);

/// A beam: a box from `from` to `to`, its third axis as near to `up` as it can be.
/// @param section  thickness across, and along `up`
void addBeam(Shape& shape, const Ogre::Vector3& from, const Ogre::Vector3& to, const Ogre::Vector3& up,
             const Ogre::Vector2& section, float chamfer, float uvScale);

/// Makes one vertex of those that agree in everything, and drops triangles that have lost their area thereby.
void weld(Shape& shape);

} // namespace lodsmith::media
