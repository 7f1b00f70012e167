#include "ImplicitSurface.h"

#include <array>
#include <cmath>
#include <map>
#include <stdexcept>

namespace lodsmith::media {

namespace {

using Ogre::Vector3;

/// Field values at the corners of a grid, and for each cell its vertex.
struct Grid {
    Vector3 origin;
    float cell = 0.0f;
    std::size_t nx = 0, ny = 0, nz = 0; ///< corners
    std::vector<float> values;
    std::vector<std::uint32_t> vertexOfCell;

    std::size_t at(std::size_t x, std::size_t y, std::size_t z) const { return (z * ny + y) * nx + x; }
    Vector3 corner(std::size_t x, std::size_t y, std::size_t z) const
    {
        return origin + Vector3(float(x), float(y), float(z)) * cell;
    }
};

Grid sample(const Field& field, const Ogre::AxisAlignedBox& box, float cell)
{
    Grid grid;
    grid.cell = cell;
    grid.origin = box.getMinimum();
    const Vector3 size = box.getSize() / cell;
    grid.nx = static_cast<std::size_t>(std::ceil(size.x)) + 1;
    grid.ny = static_cast<std::size_t>(std::ceil(size.y)) + 1;
    grid.nz = static_cast<std::size_t>(std::ceil(size.z)) + 1;
    grid.values.reserve(grid.nx * grid.ny * grid.nz);
    for (std::size_t z = 0; z < grid.nz; ++z)
        for (std::size_t y = 0; y < grid.ny; ++y)
            for (std::size_t x = 0; x < grid.nx; ++x)
                grid.values.push_back(field(grid.corner(x, y, z)));
    grid.vertexOfCell.assign(grid.values.size(), 0);
    return grid;
}

/// Mean of the places where the surface cuts the twelve edges of a cell; false when it cuts none.
bool meanCrossing(const Grid& grid, std::size_t x, std::size_t y, std::size_t z, Vector3& mean)
{
    Vector3 sum = Vector3::ZERO;
    int crossings = 0;
    const auto edge = [&](std::size_t a, std::size_t b) {
        const auto corner = [&](std::size_t i) { return std::array{x + (i & 1), y + (i >> 1 & 1), z + (i >> 2)}; };
        const auto ca = corner(a), cb = corner(b);
        const float va = grid.values[grid.at(ca[0], ca[1], ca[2])], vb = grid.values[grid.at(cb[0], cb[1], cb[2])];
        if ((va < 0.0f) == (vb < 0.0f))
            return;
        const Vector3 pa = grid.corner(ca[0], ca[1], ca[2]), pb = grid.corner(cb[0], cb[1], cb[2]);
        sum += pa + (pb - pa) * (va / (va - vb));
        ++crossings;
    };
    for (std::size_t corner = 0; corner < 8; ++corner)
        for (const std::size_t bit : {1u, 2u, 4u})
            if (!(corner & bit))
                edge(corner, corner | bit);
    mean = crossings ? sum / float(crossings) : sum;
    return crossings > 0;
}

void placeVertices(Grid& grid, SurfaceMesh& mesh)
{
    for (std::size_t z = 0; z + 1 < grid.nz; ++z)
        for (std::size_t y = 0; y + 1 < grid.ny; ++y)
            for (std::size_t x = 0; x + 1 < grid.nx; ++x) {
                Vector3 position;
                if (!meanCrossing(grid, x, y, z, position))
                    continue;
                grid.vertexOfCell[grid.at(x, y, z)] = static_cast<std::uint32_t>(mesh.positions.size());
                mesh.positions.push_back(position);
            }
}

/// Two triangles along the shorter diagonal.
void addQuad(SurfaceMesh& mesh, std::array<std::uint32_t, 4> q, bool turned)
{
    if (turned)
        std::swap(q[1], q[3]);
    const auto& p = mesh.positions;
    if (p[q[0]].squaredDistance(p[q[2]]) <= p[q[1]].squaredDistance(p[q[3]]))
        mesh.indices.insert(mesh.indices.end(), {q[0], q[1], q[2], q[0], q[2], q[3]});
    else
        mesh.indices.insert(mesh.indices.end(), {q[1], q[2], q[3], q[1], q[3], q[0]});
}

/// A quad for every grid edge that the surface cuts, between the four cells around it.
void joinVertices(const Grid& grid, SurfaceMesh& mesh)
{
    const std::size_t steps[3] = {1, grid.nx, grid.nx * grid.ny};
    for (std::size_t z = 1; z + 1 < grid.nz; ++z)
        for (std::size_t y = 1; y + 1 < grid.ny; ++y)
            for (std::size_t x = 1; x + 1 < grid.nx; ++x)
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    const std::size_t here = grid.at(x, y, z);
                    const bool inside = grid.values[here] < 0.0f;
                    if (inside == (grid.values[here + steps[axis]] < 0.0f))
                        continue;
                    const std::size_t u = steps[(axis + 1) % 3], v = steps[(axis + 2) % 3];
                    const auto& cells = grid.vertexOfCell;
                    addQuad(mesh, {cells[here - u - v], cells[here - v], cells[here], cells[here - u]}, !inside);
                }
}

void checkClosed(const SurfaceMesh& mesh)
{
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
        for (std::size_t corner = 0; corner < 3; ++corner)
            ++uses[{mesh.indices[i + corner], mesh.indices[i + (corner + 1) % 3]}];
    for (const auto& [edge, count] : uses) {
        const auto back = uses.find({edge.second, edge.first});
        if (count != 1 || back == uses.end() || back->second != 1)
            throw std::runtime_error("the surface is not a closed manifold");
    }
}

void project(const Field& field, Vector3& position)
{
    for (int step = 0; step < 4; ++step)
        position -= fieldNormal(field, position) * field(position);
}

/// Moves every vertex towards the middle of its neighbours and back onto the surface.
void relax(const Field& field, SurfaceMesh& mesh)
{
    std::vector<Vector3> sums(mesh.positions.size(), Vector3::ZERO);
    std::vector<int> counts(mesh.positions.size(), 0);
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::uint32_t from = mesh.indices[i + corner], to = mesh.indices[i + (corner + 1) % 3];
            sums[from] += mesh.positions[to];
            ++counts[from];
        }
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        Vector3& position = mesh.positions[i];
        const Vector3 normal = fieldNormal(field, position);
        const Vector3 pull = sums[i] / float(counts[i]) - position;
        position += (pull - normal * pull.dotProduct(normal)) * 0.6f;
        project(field, position);
    }
}

} // namespace

Vector3 fieldNormal(const Field& field, const Vector3& position)
{
    constexpr float kStep = 2e-3f;
    Vector3 normal;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        Vector3 step = Vector3::ZERO;
        step[axis] = kStep;
        normal[axis] = field(position + step) - field(position - step);
    }
    return normal.normalisedCopy();
}

SurfaceMesh followSurface(const Field& field, const Ogre::AxisAlignedBox& box, float cell)
{
    constexpr int kRelaxations = 12;
    SurfaceMesh mesh;
    Grid grid = sample(field, box, cell);
    placeVertices(grid, mesh);
    joinVertices(grid, mesh);
    checkClosed(mesh);
    for (int i = 0; i < kRelaxations; ++i)
        relax(field, mesh);
    for (const Vector3& position : mesh.positions)
        mesh.normals.push_back(fieldNormal(field, position));
    return mesh;
}

} // namespace lodsmith::media
