#include "Shape.h"

#include <array>
#include <map>

namespace lodsmith::media {

namespace {

using Ogre::Vector2;
using Ogre::Vector3;

/// Texture coordinates in the plane of a face: `across` as near to horizontal as can be.
Vector2 planarUv(const Vector3& position, const Vector3& normal, float scale)
{
    const Vector3 helper = std::abs(normal.y) > 0.8f ? Vector3::UNIT_Z : Vector3::UNIT_Y;
    const Vector3 across = helper.crossProduct(normal).normalisedCopy();
    const Vector3 along = normal.crossProduct(across);
    return Vector2(position.dotProduct(across), -position.dotProduct(along)) * scale;
}

void addFace(Shape& shape, const Placement& placement, std::initializer_list<Vector3> corners, float uvScale)
{
    const std::vector<Vector3> local(corners);
    const Vector3 normal = (local[1] - local[0]).crossProduct(local[2] - local[0]).normalisedCopy();
    std::vector<std::uint32_t> fan;
    for (const Vector3& corner : local)
        fan.push_back(shape.add({placement.position + placement.orientation * corner, placement.orientation * normal,
                                 planarUv(corner, normal, uvScale)}));
    for (std::size_t i = 2; i < fan.size(); ++i)
        shape.addTriangle(fan[0], fan[i - 1], fan[i]);
}

/// Vector of a box's own frame: `axis` carries x, the next axis y, the one after z.
Vector3 turned(int axis, float x, float y, float z)
{
    Vector3 result;
    result[std::size_t(axis)] = x;
    result[std::size_t((axis + 1) % 3)] = y;
    result[std::size_t((axis + 2) % 3)] = z;
    return result;
}

void addBoxSides(Shape& shape, const Placement& placement, const Vector3& half, float chamfer, float uvScale)
{
    for (int axis = 0; axis < 3; ++axis) {
        const float x = half[std::size_t(axis)];
        const float y = half[std::size_t((axis + 1) % 3)] - chamfer, z = half[std::size_t((axis + 2) % 3)] - chamfer;
        addFace(shape, placement,
                {turned(axis, x, -y, -z), turned(axis, x, y, -z), turned(axis, x, y, z), turned(axis, x, -y, z)},
                uvScale);
        addFace(shape, placement,
                {turned(axis, -x, -y, z), turned(axis, -x, y, z), turned(axis, -x, y, -z), turned(axis, -x, -y, -z)},
                uvScale);
    }
}

void addBoxChamfers(Shape& shape, const Placement& placement, const Vector3& half, float chamfer, float uvScale)
{
    for (int axis = 0; axis < 3; ++axis) {
        const float x = half[std::size_t(axis)] - chamfer;
        const float y = half[std::size_t((axis + 1) % 3)], z = half[std::size_t((axis + 2) % 3)];
        for (const float s : {-1.0f, 1.0f})
            for (const float t : {-1.0f, 1.0f}) {
                const float e = -s * t * x;
                addFace(shape, placement,
                        {turned(axis, -e, s * y, t * (z - chamfer)), turned(axis, e, s * y, t * (z - chamfer)),
                         turned(axis, e, s * (y - chamfer), t * z), turned(axis, -e, s * (y - chamfer), t * z)},
                        uvScale);
            }
    }
}

void addBoxCorners(Shape& shape, const Placement& placement, const Vector3& half, float chamfer, float uvScale)
{
    for (const float x : {-1.0f, 1.0f})
        for (const float y : {-1.0f, 1.0f})
            for (const float z : {-1.0f, 1.0f}) {
                const Vector3 sign(x, y, z);
                const Vector3 a = sign * (half - Vector3(0, chamfer, chamfer));
                const Vector3 b = sign * (half - Vector3(chamfer, 0, chamfer));
                const Vector3 c = sign * (half - Vector3(chamfer, chamfer, 0));
                if (x * y * z > 0)
                    addFace(shape, placement, {a, b, c}, uvScale);
                else
                    addFace(shape, placement, {a, c, b}, uvScale);
            }
}

} // namespace

void Shape::append(const Shape& other)
{
    const auto first = static_cast<std::uint32_t>(vertices.size());
    vertices.insert(vertices.end(), other.vertices.begin(), other.vertices.end());
    for (const std::uint32_t index : other.indices)
        indices.push_back(first + index);
}

void addFlatQuad(Shape& shape, const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d, float uvScale)
{
    addFace(shape, {}, {a, b, c, d}, uvScale);
}

void addFlatTriangle(Shape& shape, const Vector3& a, const Vector3& b, const Vector3& c, float uvScale)
{
    addFace(shape, {}, {a, b, c}, uvScale);
}

void addBox(Shape& shape, const Placement& placement, const Vector3& size, float chamfer, float uvScale)
{
    const Vector3 half = size * 0.5f;
    addBoxSides(shape, placement, half, chamfer, uvScale);
    addBoxChamfers(shape, placement, half, chamfer, uvScale);
    addBoxCorners(shape, placement, half, chamfer, uvScale);
}

void addBeam(Shape& shape, const Vector3& from, const Vector3& to, const Vector3& up, const Vector2& section,
             float chamfer, float uvScale)
{
    const Vector3 along = (to - from).normalisedCopy();
    const Vector3 across = up.crossProduct(along).normalisedCopy();
    const Vector3 height = along.crossProduct(across);
    const Placement placement{(from + to) * 0.5f, Ogre::Quaternion(across, height, along)};
    addBox(shape, placement, Vector3(section.x, section.y, (to - from).length()), chamfer, uvScale);
}

void weld(Shape& shape)
{
    std::map<std::array<float, 8>, std::uint32_t> known;
    std::vector<std::uint32_t> place;
    std::vector<Vertex> kept;
    for (const Vertex& v : shape.vertices) {
        const std::array<float, 8> key{v.position.x, v.position.y, v.position.z, v.normal.x,
                                       v.normal.y,   v.normal.z,   v.uv.x,       v.uv.y};
        const auto [entry, isNew] = known.emplace(key, static_cast<std::uint32_t>(kept.size()));
        if (isNew)
            kept.push_back(v);
        place.push_back(entry->second);
    }
    std::vector<std::uint32_t> indices;
    for (std::size_t i = 0; i < shape.indices.size(); i += 3) {
        const std::uint32_t a = place[shape.indices[i]], b = place[shape.indices[i + 1]],
                            c = place[shape.indices[i + 2]];
        const Vector3 &pa = kept[a].position, &pb = kept[b].position, &pc = kept[c].position;
        if (pa != pb && pb != pc && pc != pa)
            indices.insert(indices.end(), {a, b, c});
    }
    shape.vertices = std::move(kept);
    shape.indices = std::move(indices);
}

} // namespace lodsmith::media
