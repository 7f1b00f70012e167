#include "MeshBuilders.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace lodsmith::test {

namespace {

constexpr double kPi = 3.14159265358979323846;

FloatStream floatStream(const std::vector<float>& values, std::size_t count)
{
    return values.empty() ? FloatStream{} : FloatStream{values.data(), count * sizeof(float)};
}

VertexBufferView bufferView(const TestBuffer& buffer)
{
    VertexBufferView view;
    view.vertexCount = buffer.vertexCount();
    view.positions = floatStream(buffer.positions, 3);
    view.normals = floatStream(buffer.normals, 3);
    for (const std::vector<float>& set : buffer.uvSets)
        view.uvSets.push_back({floatStream(set, 2), 2});
    view.colours = floatStream(buffer.colours, 4);
    view.bones = buffer.bones.empty() ? nullptr : buffer.bones.data();
    for (const std::vector<float>& offset : buffer.offsets)
        view.offsets.push_back(floatStream(offset, 3));
    for (const std::vector<float>& pose : buffer.poses)
        view.poses.push_back(floatStream(pose, 3));
    view.importance = floatStream(buffer.importance, 1);
    return view;
}

MeshView bufferViews(const TestMesh& mesh)
{
    MeshView view;
    for (const TestBuffer& buffer : mesh.buffers)
        view.vertexBuffers.push_back(bufferView(buffer));
    return view;
}

SubMeshView subMeshView(std::uint32_t vertexBuffer, const std::vector<std::uint32_t>& indices)
{
    return {vertexBuffer, indices.data(), static_cast<std::uint32_t>(indices.size()), 4};
}

TestMesh emptyMesh()
{
    TestMesh mesh;
    mesh.buffers.resize(1);
    mesh.subMeshes.resize(1);
    return mesh;
}

Point cross(const Point& a, const Point& b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Point normalized(const Point& a)
{
    const double length = std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
    return length > 0.0 ? Point{a[0] / length, a[1] / length, a[2] / length} : Point{0.0, 0.0, 1.0};
}

Point positionOf(const TestBuffer& buffer, std::uint32_t vertex)
{
    const float* p = &buffer.positions[3 * std::size_t(vertex)];
    return {p[0], p[1], p[2]};
}

Point faceNormal(const TestBuffer& buffer, std::uint32_t a, std::uint32_t b, std::uint32_t c)
{
    const Point p = positionOf(buffer, a), q = positionOf(buffer, b), r = positionOf(buffer, c);
    return cross({q[0] - p[0], q[1] - p[1], q[2] - p[2]}, {r[0] - p[0], r[1] - p[1], r[2] - p[2]});
}

/// Normals of the buffer from the faces of the submesh, area-weighted.
void smoothNormals(TestBuffer& buffer, const TestSubMesh& subMesh)
{
    std::vector<Point> sums(buffer.vertexCount(), Point{0.0, 0.0, 0.0});
    for (std::size_t i = 0; i < subMesh.indices.size(); i += 3) {
        const Point n = faceNormal(buffer, subMesh.indices[i], subMesh.indices[i + 1], subMesh.indices[i + 2]);
        for (std::size_t corner = i; corner < i + 3; ++corner)
            for (int axis = 0; axis < 3; ++axis)
                sums[subMesh.indices[corner]][axis] += n[axis];
    }
    buffer.normals.clear();
    for (const Point& sum : sums) {
        const Point n = normalized(sum);
        buffer.addNormal(n[0], n[1], n[2]);
    }
}

/// The quads of a (columns + 1) x (rows + 1) lattice of vertices, row by row.
void addLatticeQuads(TestSubMesh& subMesh, std::uint32_t columns, std::uint32_t rows, std::uint32_t first = 0)
{
    for (std::uint32_t row = 0; row < rows; ++row)
        for (std::uint32_t column = 0; column < columns; ++column) {
            const std::uint32_t corner = first + row * (columns + 1) + column;
            subMesh.addQuad(corner, corner + 1, corner + columns + 2, corner + columns + 1);
        }
}

/// Cosine and sine of a share of a full turn; equal for step 0 and step `steps`, to the last bit.
std::pair<double, double> turn(std::uint32_t step, std::uint32_t steps)
{
    const double angle = 2.0 * kPi * (step % steps) / steps;
    return {std::cos(angle), std::sin(angle)};
}

std::uint32_t midpoint(TestBuffer& buffer, std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t>& known,
                       std::uint32_t a, std::uint32_t b, double radius)
{
    const auto key = std::minmax(a, b);
    const auto found = known.find(key);
    if (found != known.end())
        return found->second;
    const Point p = positionOf(buffer, a), q = positionOf(buffer, b);
    const Point n = normalized({p[0] + q[0], p[1] + q[1], p[2] + q[2]});
    buffer.addNormal(n[0], n[1], n[2]);
    return known[key] = buffer.addPosition(n[0] * radius, n[1] * radius, n[2] * radius);
}

TestMesh makeIcosahedron(double radius)
{
    TestMesh mesh = emptyMesh();
    const double golden = (1.0 + std::sqrt(5.0)) / 2.0;
    for (int axis = 0; axis < 3; ++axis)
        for (int corner = 0; corner < 4; ++corner) {
            Point p{0.0, 0.0, 0.0};
            p[(axis + 1) % 3] = corner & 1 ? -1.0 : 1.0;
            p[(axis + 2) % 3] = corner & 2 ? -golden : golden;
            p = normalized(p);
            mesh.buffers[0].addNormal(p[0], p[1], p[2]);
            mesh.buffers[0].addPosition(p[0] * radius, p[1] * radius, p[2] * radius);
        }
    // The faces are the triples of mutual neighbours: edges are 1.05 radii long, the next distance is 1.7.
    const TestBuffer& buffer = mesh.buffers[0];
    const auto adjacent = [&](std::uint32_t a, std::uint32_t b) {
        const Point p = positionOf(buffer, a), q = positionOf(buffer, b);
        return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) < 1.2 * radius;
    };
    for (std::uint32_t a = 0; a < 12; ++a)
        for (std::uint32_t b = a + 1; b < 12; ++b)
            for (std::uint32_t c = b + 1; c < 12; ++c) {
                if (!adjacent(a, b) || !adjacent(b, c) || !adjacent(a, c))
                    continue;
                const Point n = faceNormal(buffer, a, b, c), p = positionOf(buffer, a);
                const bool outward = n[0] * p[0] + n[1] * p[1] + n[2] * p[2] > 0.0;
                outward ? mesh.subMeshes[0].addTriangle(a, b, c) : mesh.subMeshes[0].addTriangle(a, c, b);
            }
    return mesh;
}

/// The two strips of a shut mouth: rows of quads below and above y = 0, with separate vertices on that line.
TestMesh makeLipStrips(std::uint32_t cells)
{
    TestMesh mesh = emptyMesh();
    TestBuffer& buffer = mesh.buffers[0];
    for (int lip = 0; lip < 2; ++lip) {
        const std::uint32_t first = buffer.vertexCount();
        for (std::uint32_t row = 0; row <= cells; ++row)
            for (std::uint32_t column = 0; column <= cells; ++column) {
                const double y = double(row) / cells - (lip == 0 ? 1.0 : 0.0);
                buffer.addPosition(double(column) / cells, y, 0.1 * std::cos(2.0 * y));
            }
        addLatticeQuads(mesh.subMeshes[0], cells, cells, first);
    }
    smoothNormals(buffer, mesh.subMeshes[0]);
    return mesh;
}

} // namespace

std::uint32_t TestBuffer::addPosition(double x, double y, double z)
{
    positions.insert(positions.end(), {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)});
    return vertexCount() - 1;
}

void TestBuffer::addNormal(double x, double y, double z)
{
    normals.insert(normals.end(), {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)});
}

void TestBuffer::addUv(double u, double v, std::size_t set)
{
    if (uvSets.size() <= set)
        uvSets.resize(set + 1);
    uvSets[set].insert(uvSets[set].end(), {static_cast<float>(u), static_cast<float>(v)});
}

void TestSubMesh::addTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c)
{
    indices.insert(indices.end(), {a, b, c});
}

void TestSubMesh::addQuad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d)
{
    addTriangle(a, b, c);
    addTriangle(a, c, d);
}

MeshView TestMesh::view() const
{
    MeshView view = bufferViews(*this);
    for (const TestSubMesh& subMesh : subMeshes)
        view.subMeshes.push_back(subMeshView(subMesh.vertexBuffer, subMesh.indices));
    return view;
}

MeshView TestMesh::view(const LodChainLevel& level) const
{
    MeshView view = bufferViews(*this);
    for (std::size_t i = 0; i < subMeshes.size(); ++i)
        view.subMeshes.push_back(subMeshView(subMeshes[i].vertexBuffer, level.indices.at(i)));
    return view;
}

std::size_t TestMesh::triangleCount() const
{
    std::size_t count = 0;
    for (const TestSubMesh& subMesh : subMeshes)
        count += subMesh.indices.size() / 3;
    return count;
}

TestMesh makePatch(std::uint32_t columns, std::uint32_t rows, const Shape& shape)
{
    TestMesh mesh = emptyMesh();
    TestBuffer& buffer = mesh.buffers[0];
    for (std::uint32_t row = 0; row <= rows; ++row)
        for (std::uint32_t column = 0; column <= columns; ++column) {
            const double u = double(column) / columns, v = double(row) / rows;
            const Point p = shape(u, v);
            buffer.addPosition(p[0], p[1], p[2]);
            buffer.addUv(u, v);
        }
    addLatticeQuads(mesh.subMeshes[0], columns, rows);
    smoothNormals(buffer, mesh.subMeshes[0]);
    return mesh;
}

TestMesh makeGrid(std::uint32_t columns, std::uint32_t rows, double size)
{
    return makePatch(columns, rows, [size](double u, double v) { return Point{u * size, v * size, 0.0}; });
}

TestMesh makeTerrain(std::uint32_t cells)
{
    return makePatch(cells, cells, [](double u, double v) {
        return Point{u, v, 0.05 * std::sin(9.0 * u + 2.0 * v) + 0.04 * std::cos(13.0 * v - 3.0 * u * v)};
    });
}

TestMesh makeUvSphere(std::uint32_t sectors, std::uint32_t rings, double radius)
{
    TestMesh mesh = emptyMesh();
    TestBuffer& buffer = mesh.buffers[0];
    for (std::uint32_t ring = 0; ring <= rings; ++ring)
        for (std::uint32_t sector = 0; sector <= sectors; ++sector) {
            const bool pole = ring == 0 || ring == rings;
            const double polar = kPi * ring / rings;
            const double across = pole ? 0.0 : std::sin(polar);
            const auto [c, s] = turn(sector, sectors);
            // A pole's wedge belongs to the sector it closes, so its u is that sector's middle.
            const double u = (sector + (pole ? 0.5 : 0.0)) / sectors;
            buffer.addPosition(radius * across * c, radius * across * s, radius * -std::cos(polar));
            buffer.addNormal(across * c, across * s, -std::cos(polar));
            buffer.addUv(u, double(ring) / rings);
        }
    for (std::uint32_t ring = 0; ring < rings; ++ring)
        for (std::uint32_t sector = 0; sector < sectors; ++sector) {
            const std::uint32_t a = ring * (sectors + 1) + sector, d = a + sectors + 1;
            if (ring + 1 < rings)
                mesh.subMeshes[0].addTriangle(a, d + 1, d);
            if (ring > 0)
                mesh.subMeshes[0].addTriangle(a, a + 1, ring + 1 < rings ? d + 1 : d);
        }
    return mesh;
}

TestMesh makeIcosphere(std::uint32_t subdivisions, double radius)
{
    TestMesh mesh = makeIcosahedron(radius);
    for (std::uint32_t step = 0; step < subdivisions; ++step) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> known;
        const std::vector<std::uint32_t> coarse = std::exchange(mesh.subMeshes[0].indices, {});
        for (std::size_t i = 0; i < coarse.size(); i += 3) {
            const std::uint32_t a = coarse[i], b = coarse[i + 1], c = coarse[i + 2];
            const std::uint32_t ab = midpoint(mesh.buffers[0], known, a, b, radius);
            const std::uint32_t bc = midpoint(mesh.buffers[0], known, b, c, radius);
            const std::uint32_t ca = midpoint(mesh.buffers[0], known, c, a, radius);
            mesh.subMeshes[0].addTriangle(a, ab, ca);
            mesh.subMeshes[0].addTriangle(ab, b, bc);
            mesh.subMeshes[0].addTriangle(ca, bc, c);
            mesh.subMeshes[0].addTriangle(ab, bc, ca);
        }
    }
    return mesh;
}

TestMesh makeTorus(std::uint32_t sectors, std::uint32_t sides, double majorRadius, double minorRadius)
{
    TestMesh mesh = emptyMesh();
    TestBuffer& buffer = mesh.buffers[0];
    for (std::uint32_t side = 0; side <= sides; ++side)
        for (std::uint32_t sector = 0; sector <= sectors; ++sector) {
            const auto [c, s] = turn(sector, sectors);
            const auto [out, up] = turn(side, sides);
            const double distance = majorRadius + minorRadius * out;
            buffer.addPosition(distance * c, distance * s, minorRadius * up);
            buffer.addNormal(out * c, out * s, up);
            buffer.addUv(double(sector) / sectors, double(side) / sides);
        }
    addLatticeQuads(mesh.subMeshes[0], sectors, sides);
    return mesh;
}

TestMesh makeCylinder(std::uint32_t sectors, std::uint32_t stacks, double radius, double height)
{
    TestMesh mesh = emptyMesh();
    TestBuffer& buffer = mesh.buffers[0];
    for (std::uint32_t stack = 0; stack <= stacks; ++stack)
        for (std::uint32_t sector = 0; sector <= sectors; ++sector) {
            const auto [c, s] = turn(sector, sectors);
            buffer.addPosition(radius * c, radius * s, height * stack / stacks);
            buffer.addNormal(c, s, 0.0);
            buffer.addUv(double(sector) / sectors, double(stack) / stacks);
        }
    addLatticeQuads(mesh.subMeshes[0], sectors, stacks);
    return mesh;
}

TestMesh makeCube(std::uint32_t cells, double size)
{
    TestMesh mesh = emptyMesh();
    TestBuffer& buffer = mesh.buffers[0];
    for (int side = 0; side < 6; ++side) {
        const int axis = side / 2;
        const double sign = side % 2 ? 1.0 : -1.0;
        const std::uint32_t first = buffer.vertexCount();
        for (std::uint32_t row = 0; row <= cells; ++row)
            for (std::uint32_t column = 0; column <= cells; ++column) {
                const double u = double(column) / cells, v = double(row) / cells;
                Point p{}, n{};
                n[axis] = sign;
                p[axis] = sign * size / 2.0;
                p[(axis + 1) % 3] = (sign > 0.0 ? u - 0.5 : 0.5 - u) * size;
                p[(axis + 2) % 3] = (v - 0.5) * size;
                buffer.addPosition(p[0], p[1], p[2]);
                buffer.addNormal(n[0], n[1], n[2]);
                buffer.addUv(u, v);
            }
        addLatticeQuads(mesh.subMeshes[0], cells, cells, first);
    }
    return mesh;
}

TestMesh makeTetrahedron()
{
    TestMesh mesh = emptyMesh();
    mesh.buffers[0].positions = {1, 1, 1, -1, -1, 1, -1, 1, -1, 1, -1, -1};
    mesh.subMeshes[0].indices = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
    return mesh;
}

TestMesh makeTwoSidedWall(std::uint32_t cells)
{
    TestMesh mesh = makeGrid(cells, cells);
    TestMesh back = turnedInsideOut(mesh);
    for (float& component : back.buffers[0].normals)
        component = -component;
    TestBuffer& buffer = mesh.buffers[0];
    const std::uint32_t first = buffer.vertexCount();
    const auto append = [](std::vector<float>& to, const std::vector<float>& from) {
        to.insert(to.end(), from.begin(), from.end());
    };
    append(buffer.positions, back.buffers[0].positions);
    append(buffer.normals, back.buffers[0].normals);
    append(buffer.uvSets[0], back.buffers[0].uvSets[0]);
    for (const std::uint32_t index : back.subMeshes[0].indices)
        mesh.subMeshes[0].indices.push_back(first + index);
    return mesh;
}

TestMesh makeClosedLips(std::uint32_t cells)
{
    TestMesh mesh = makeLipStrips(cells);
    TestBuffer& buffer = mesh.buffers[0];
    std::vector<float> pose(buffer.positions.size(), 0.0f);
    for (std::uint32_t vertex = 0; vertex < buffer.vertexCount(); ++vertex) {
        const bool upper = vertex >= buffer.vertexCount() / 2;
        const double distance = std::abs(positionOf(buffer, vertex)[1]);
        pose[3 * std::size_t(vertex) + 1] = static_cast<float>((upper ? 0.2 : -0.2) * (1.0 - distance));
    }
    buffer.offsets.push_back(pose);
    return mesh;
}

TestMesh makeSkinnedLips(std::uint32_t cells)
{
    TestMesh mesh = makeLipStrips(cells);
    TestBuffer& buffer = mesh.buffers[0];
    for (std::uint32_t vertex = 0; vertex < buffer.vertexCount(); ++vertex) {
        BoneInfluences influences;
        influences.bone[0] = vertex >= buffer.vertexCount() / 2 ? 1 : 2;
        influences.weight[0] = 1.0f;
        buffer.bones.push_back(influences);
    }
    return mesh;
}

TestMesh makeSkinnedTube(std::uint32_t sectors, std::uint32_t stacks)
{
    TestMesh mesh = makeCylinder(sectors, stacks, 0.5, 2.0);
    TestBuffer& buffer = mesh.buffers[0];
    for (std::uint32_t vertex = 0; vertex < buffer.vertexCount(); ++vertex) {
        const double upper = std::min(1.0, std::max(0.0, positionOf(buffer, vertex)[2] - 0.5));
        BoneInfluences influences;
        influences.bone[1] = 1;
        influences.weight[0] = static_cast<float>(1.0 - upper);
        influences.weight[1] = static_cast<float>(upper);
        buffer.bones.push_back(influences);
    }
    return mesh;
}

TestMesh makeBentTube(std::uint32_t sectors, std::uint32_t stacks, const std::vector<double>& degrees)
{
    TestMesh mesh = makeSkinnedTube(sectors, stacks);
    TestBuffer& buffer = mesh.buffers[0];
    for (const double angle : degrees) {
        const double c = std::cos(angle * kPi / 180.0), s = std::sin(angle * kPi / 180.0);
        std::vector<float> pose;
        for (std::uint32_t vertex = 0; vertex < buffer.vertexCount(); ++vertex) {
            const Point p = positionOf(buffer, vertex);
            const double upper = buffer.bones[vertex].weight[1], y = p[1], z = p[2] - 1.0;
            pose.push_back(static_cast<float>(p[0]));
            pose.push_back(static_cast<float>((1.0 - upper) * y + upper * (c * y - s * z)));
            pose.push_back(static_cast<float>((1.0 - upper) * z + upper * (s * y + c * z) + 1.0));
        }
        buffer.poses.push_back(std::move(pose));
    }
    return mesh;
}

TestMesh makeFan(std::uint32_t triangles)
{
    TestMesh mesh = emptyMesh();
    mesh.buffers[0].addPosition(0.0, 0.0, 0.0);
    for (std::uint32_t i = 0; i < triangles; ++i) {
        const auto [c, s] = turn(i, triangles);
        mesh.buffers[0].addPosition(c, s, 0.0);
        mesh.subMeshes[0].addTriangle(0, 1 + i, 1 + (i + 1) % triangles);
    }
    smoothNormals(mesh.buffers[0], mesh.subMeshes[0]);
    return mesh;
}

TestMesh makeBook(std::uint32_t pages)
{
    TestMesh mesh = emptyMesh();
    mesh.buffers[0].addPosition(0.0, 0.0, 0.0);
    mesh.buffers[0].addPosition(0.0, 0.0, 1.0);
    for (std::uint32_t i = 0; i < pages; ++i) {
        const auto [c, s] = turn(i, pages);
        mesh.subMeshes[0].addTriangle(0, mesh.buffers[0].addPosition(c, s, 0.5), 1);
    }
    return mesh;
}

TestMesh makeIslands(std::uint32_t count)
{
    TestMesh mesh = emptyMesh();
    const TestMesh island = makeTetrahedron();
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t first = mesh.buffers[0].vertexCount();
        for (std::uint32_t vertex = 0; vertex < 4; ++vertex) {
            const Point p = positionOf(island.buffers[0], vertex);
            mesh.buffers[0].addPosition(p[0] + 3.0 * i, p[1], p[2]);
        }
        for (const std::uint32_t index : island.subMeshes[0].indices)
            mesh.subMeshes[0].indices.push_back(first + index);
    }
    return mesh;
}

TestMesh makeLeafCards(std::uint32_t count, std::uint32_t seed)
{
    TestMesh mesh = emptyMesh();
    TestBuffer& buffer = mesh.buffers[0];
    TestRandom random(seed);
    for (std::uint32_t i = 0; i < count; ++i) {
        const Point middle{random.uniform(), random.uniform(), random.uniform()};
        const auto [c, s] = turn(random.bits() % 360, 360);
        const std::uint32_t first = buffer.vertexCount();
        for (int corner = 0; corner < 4; ++corner) {
            const double u = corner == 1 || corner == 2 ? 1.0 : 0.0, v = corner >= 2 ? 1.0 : 0.0;
            const double across = 0.1 * (u - 0.5);
            buffer.addPosition(middle[0] + across * c, middle[1] + across * s, middle[2] + 0.1 * (v - 0.5));
            buffer.addNormal(s, -c, 0.0);
            buffer.addUv(u, v);
        }
        mesh.subMeshes[0].addQuad(first, first + 1, first + 2, first + 3);
    }
    return mesh;
}

TestMesh makeSoup(std::uint32_t triangles, std::uint32_t seed)
{
    TestMesh mesh = emptyMesh();
    TestRandom random(seed);
    for (std::uint32_t i = 0; i < 3 * triangles; ++i) {
        const double x = random.uniform(), y = random.uniform(), z = random.uniform();
        mesh.subMeshes[0].indices.push_back(mesh.buffers[0].addPosition(x, y, z));
    }
    return mesh;
}

TestMesh makeTwoMaterials(std::uint32_t cells, bool sharedBuffer)
{
    TestMesh mesh = makeGrid(2 * cells, cells);
    mesh.subMeshes.resize(2);
    const std::vector<std::uint32_t> all = std::exchange(mesh.subMeshes[0].indices, {});
    for (std::size_t i = 0; i < all.size(); ++i)
        mesh.subMeshes[i / 6 % (2 * cells) < cells ? 0 : 1].indices.push_back(all[i]);
    if (!sharedBuffer) {
        mesh.buffers.push_back(mesh.buffers[0]);
        mesh.subMeshes[1].vertexBuffer = 1;
    }
    return mesh;
}

TestMesh flatShaded(const TestMesh& mesh)
{
    TestMesh flat;
    for (const TestSubMesh& subMesh : mesh.subMeshes) {
        const TestBuffer& from = mesh.buffers[subMesh.vertexBuffer];
        TestBuffer to;
        TestSubMesh split;
        split.vertexBuffer = static_cast<std::uint32_t>(flat.buffers.size());
        for (std::size_t i = 0; i < subMesh.indices.size(); ++i) {
            const std::uint32_t* triangle = &subMesh.indices[i / 3 * 3];
            const std::uint32_t vertex = subMesh.indices[i];
            const Point p = positionOf(from, vertex);
            const Point n = normalized(faceNormal(from, triangle[0], triangle[1], triangle[2]));
            split.indices.push_back(to.addPosition(p[0], p[1], p[2]));
            to.addNormal(n[0], n[1], n[2]);
            for (std::size_t set = 0; set < from.uvSets.size(); ++set)
                to.addUv(from.uvSets[set][2 * std::size_t(vertex)], from.uvSets[set][2 * std::size_t(vertex) + 1], set);
        }
        flat.buffers.push_back(std::move(to));
        flat.subMeshes.push_back(std::move(split));
    }
    return flat;
}

TestMesh joined(const TestMesh& first, const TestMesh& second)
{
    TestMesh mesh = first;
    mesh.buffers.insert(mesh.buffers.end(), second.buffers.begin(), second.buffers.end());
    for (TestSubMesh subMesh : second.subMeshes) {
        subMesh.vertexBuffer += static_cast<std::uint32_t>(first.buffers.size());
        mesh.subMeshes.push_back(std::move(subMesh));
    }
    return mesh;
}

TestMesh scaled(TestMesh mesh, double factor)
{
    for (TestBuffer& buffer : mesh.buffers) {
        for (float& component : buffer.positions)
            component = static_cast<float>(component * factor);
        for (std::vector<std::vector<float>>* streams : {&buffer.offsets, &buffer.poses})
            for (std::vector<float>& stream : *streams)
                for (float& component : stream)
                    component = static_cast<float>(component * factor);
    }
    return mesh;
}

TestMesh translated(TestMesh mesh, double x, double y, double z)
{
    const double shift[3] = {x, y, z};
    for (TestBuffer& buffer : mesh.buffers)
        for (std::size_t i = 0; i < buffer.positions.size(); ++i)
            buffer.positions[i] = static_cast<float>(buffer.positions[i] + shift[i % 3]);
    return mesh;
}

TestMesh turnedInsideOut(TestMesh mesh)
{
    for (TestSubMesh& subMesh : mesh.subMeshes)
        for (std::size_t i = 0; i + 2 < subMesh.indices.size(); i += 3)
            std::swap(subMesh.indices[i + 1], subMesh.indices[i + 2]);
    return mesh;
}

TestMesh jittered(TestMesh mesh, double amount, std::uint32_t seed)
{
    TestRandom random(seed);
    std::map<std::array<float, 3>, Point> moved;
    for (TestBuffer& buffer : mesh.buffers)
        for (std::size_t i = 0; i < buffer.positions.size(); i += 3) {
            float* p = &buffer.positions[i];
            const auto [entry, isNew] = moved.try_emplace({p[0], p[1], p[2]});
            if (isNew)
                for (int axis = 0; axis < 3; ++axis)
                    entry->second[axis] = p[axis] + random.uniform(-amount, amount);
            for (int axis = 0; axis < 3; ++axis)
                p[axis] = static_cast<float>(entry->second[axis]);
        }
    return mesh;
}

std::uint32_t TestRandom::bits()
{
    mState = mState * 6364136223846793005ull + 1442695040888963407ull;
    std::uint64_t mixed = mState;
    mixed = (mixed ^ (mixed >> 33)) * 0xff51afd7ed558ccdull;
    return static_cast<std::uint32_t>(mixed >> 32);
}

double TestRandom::uniform()
{
    return bits() / 4294967296.0;
}

} // namespace lodsmith::test
