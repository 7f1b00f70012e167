#include "Tessellation.h"

#include <OgreHardwareBufferManager.h>
#include <OgreMeshManager.h>
#include <OgreSubMesh.h>

#include <array>
#include <cmath>
#include <vector>

namespace lodsmith::benchmarks {

namespace {

constexpr double kQuarterTurn = 3.14159265358979323846 / 4.0;

struct GridVertex {
    float position[3];
    float normal[3];
    float uv[2];
};

struct Geometry {
    std::vector<GridVertex> vertices;
    std::vector<std::uint32_t> indices;
};

using Point = std::array<double, 3>;

/// Waves of falling length and height: detail at every scale, so that no density is smooth and none is noise.
double waves(double x, double y, double z)
{
    double height = 0.0;
    double frequency = 1.7;
    double amplitude = 1.0;
    for (int octave = 0; octave < 7; ++octave) {
        height += amplitude * std::sin(frequency * x + 1.3 * octave) * std::sin(frequency * 1.13 * y + 2.1 * octave)
                  * std::cos(frequency * 0.91 * z + 0.7 * octave);
        frequency *= 1.97;
        amplitude *= 0.48;
    }
    return height;
}

/// How far a point lies outside the surface, negative inside: its gradient is the normal.
double outside(Surface surface, const Point& p)
{
    if (surface == Surface::Terrain)
        return p[1] - 12.0 * waves(0.03 * p[0], 0.03 * p[2], 0.4);
    const double length = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
    return length - 100.0 - 9.0 * waves(3.0 * p[0] / length, 3.0 * p[1] / length, 3.0 * p[2] / length);
}

Point gradient(Surface surface, const Point& p)
{
    constexpr double kStep = 1e-4;
    Point result;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        Point before = p, behind = p;
        before[axis] += kStep;
        behind[axis] -= kStep;
        result[axis] = outside(surface, before) - outside(surface, behind);
    }
    const double length = std::sqrt(result[0] * result[0] + result[1] * result[1] + result[2] * result[2]);
    return {result[0] / length, result[1] / length, result[2] / length};
}

GridVertex makeVertex(Surface surface, const Point& p, double u, double v)
{
    const Point n = gradient(surface, p);
    return {{float(p[0]), float(p[1]), float(p[2])}, {float(n[0]), float(n[1]), float(n[2])}, {float(u), float(v)}};
}

/// Appends a square patch of n by n quads; `point` maps grid places, 0..n each, to the surface, counter-clockwise.
template <class PointAt>
void addPatch(Geometry& geometry, Surface surface, std::uint32_t n, PointAt point, double uvScale, double uOffset,
              double vOffset)
{
    const auto first = static_cast<std::uint32_t>(geometry.vertices.size());
    for (std::uint32_t row = 0; row <= n; ++row)
        for (std::uint32_t column = 0; column <= n; ++column)
            geometry.vertices.push_back(
                makeVertex(surface, point(column, row), uOffset + uvScale * column / n, vOffset + uvScale * row / n));
    for (std::uint32_t row = 0; row < n; ++row)
        for (std::uint32_t column = 0; column < n; ++column) {
            const std::uint32_t a = first + row * (n + 1) + column, b = a + 1, c = a + n + 1, d = c + 1;
            geometry.indices.insert(geometry.indices.end(), {a, b, d, a, d, c});
        }
}

Geometry terrain(std::uint32_t triangles)
{
    const auto n = static_cast<std::uint32_t>(std::lround(std::sqrt(triangles / 2.0)));
    Geometry geometry;
    const auto point = [n](std::uint32_t column, std::uint32_t row) {
        const double x = 200.0 * column / n, z = -200.0 * row / n;
        return Point{x, -outside(Surface::Terrain, {x, 0.0, z}), z};
    };
    addPatch(geometry, Surface::Terrain, n, point, 1.0, 0.0, 0.0);
    return geometry;
}

/// A point of one side of the cube, blown up to the planet. Neighbouring sides meet in bit-identical points, since both
/// compute them from the same three coordinates.
Point planetPoint(const Point& cube)
{
    const double length = std::sqrt(cube[0] * cube[0] + cube[1] * cube[1] + cube[2] * cube[2]);
    const Point direction{cube[0] / length, cube[1] / length, cube[2] / length};
    const double radius = -outside(Surface::Planet, direction) + 1.0;
    return {radius * direction[0], radius * direction[1], radius * direction[2]};
}

Geometry planet(std::uint32_t triangles)
{
    const auto n = static_cast<std::uint32_t>(std::lround(std::sqrt(triangles / 12.0)));
    Geometry geometry;
    for (std::size_t side = 0; side < 6; ++side) {
        const double sign = side < 3 ? 1.0 : -1.0;
        const auto point = [=](std::uint32_t column, std::uint32_t row) {
            Point cube;
            cube[side % 3] = sign;
            cube[(side + 1) % 3] = sign * std::tan(kQuarterTurn * (2.0 * column - n) / n);
            cube[(side + 2) % 3] = std::tan(kQuarterTurn * (2.0 * row - n) / n);
            return planetPoint(cube);
        };
        addPatch(geometry, Surface::Planet, n, point, 0.3, 0.33 * double(side % 3), 0.5 * double(side / 3));
    }
    return geometry;
}

Ogre::VertexData* createVertexData(const std::vector<GridVertex>& vertices)
{
    auto* data = new Ogre::VertexData();
    data->vertexCount = vertices.size();
    auto* declaration = data->vertexDeclaration;
    declaration->addElement(0, offsetof(GridVertex, position), Ogre::VET_FLOAT3, Ogre::VES_POSITION);
    declaration->addElement(0, offsetof(GridVertex, normal), Ogre::VET_FLOAT3, Ogre::VES_NORMAL);
    declaration->addElement(0, offsetof(GridVertex, uv), Ogre::VET_FLOAT2, Ogre::VES_TEXTURE_COORDINATES);
    auto buffer = Ogre::HardwareBufferManager::getSingleton().createVertexBuffer(sizeof(GridVertex), vertices.size(),
                                                                                 Ogre::HardwareBuffer::HBU_STATIC);
    buffer->writeData(0, buffer->getSizeInBytes(), vertices.data(), true);
    data->vertexBufferBinding->setBinding(0, buffer);
    return data;
}

void setIndices(Ogre::IndexData& data, const std::vector<std::uint32_t>& indices)
{
    data.indexBuffer = Ogre::HardwareBufferManager::getSingleton().createIndexBuffer(
        Ogre::HardwareIndexBuffer::IT_32BIT, indices.size(), Ogre::HardwareBuffer::HBU_STATIC);
    data.indexBuffer->writeData(0, data.indexBuffer->getSizeInBytes(), indices.data(), true);
    data.indexCount = indices.size();
}

void setBounds(Ogre::Mesh& mesh, const std::vector<GridVertex>& vertices)
{
    Ogre::AxisAlignedBox box;
    for (const GridVertex& vertex : vertices)
        box.merge(Ogre::Vector3(vertex.position));
    mesh._setBounds(box);
    mesh._setBoundingSphereRadius(box.getHalfSize().length());
}

} // namespace

Ogre::MeshPtr tessellate(const std::string& name, Surface surface, std::uint32_t triangles)
{
    const Geometry geometry = surface == Surface::Planet ? planet(triangles) : terrain(triangles);
    Ogre::MeshPtr mesh = Ogre::MeshManager::getSingleton().createManual(name, Ogre::RGN_DEFAULT);
    Ogre::SubMesh* subMesh = mesh->createSubMesh();
    subMesh->useSharedVertices = false;
    subMesh->vertexData = createVertexData(geometry.vertices);
    setIndices(*subMesh->indexData, geometry.indices);
    setBounds(*mesh, geometry.vertices);
    mesh->load();
    return mesh;
}

} // namespace lodsmith::benchmarks
