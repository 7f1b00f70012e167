#include "WeldedMesh.h"

#include <lodsmith/core/Assert.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <tuple>

namespace lodsmith::analysis {

namespace {

constexpr std::uint32_t kNone = 0xffffffffu;

std::uint64_t hash(const Position& position)
{
    std::uint32_t bits[3];
    std::memcpy(bits, position.data(), sizeof bits);
    std::uint64_t h = bits[0] * 0x9e3779b97f4a7c15ull;
    h = (h ^ (h >> 32) ^ bits[1]) * 0xff51afd7ed558ccdull;
    h = (h ^ (h >> 32) ^ bits[2]) * 0xc4ceb9fe1a85ec53ull;
    return h ^ (h >> 29);
}

bool isFinite(const Position& position)
{
    return std::isfinite(position[0]) && std::isfinite(position[1]) && std::isfinite(position[2]);
}

Error errorAt(ErrorCode code, const char* message, std::size_t subMesh, std::size_t item)
{
    Error error{code, message};
    error.subMesh = static_cast<int>(subMesh);
    error.item = static_cast<std::int64_t>(item);
    return error;
}

void checkPromises(const MeshView& mesh, const SubMeshView& subMesh)
{
    LODSMITH_ASSERT(subMesh.indexCount % 3 == 0, "a triangle list has three indices a triangle");
    LODSMITH_ASSERT(subMesh.indexBytes == 2 || subMesh.indexBytes == 4, "indices are 2 or 4 bytes wide");
    LODSMITH_ASSERT(subMesh.indices != nullptr, "a submesh with triangles needs indices");
    LODSMITH_ASSERT(subMesh.vertexBuffer < mesh.vertexBuffers.size(), "a submesh names a vertex buffer of its mesh");
    const VertexBufferView& buffer = mesh.vertexBuffers[subMesh.vertexBuffer];
    LODSMITH_ASSERT(buffer.vertexCount == 0 || buffer.positions, "a vertex buffer needs positions");
}

/// A triangle's identity: equal keys are repetitions of each other.
struct TriangleKey {
    std::array<std::uint32_t, 3> position;
    std::uint32_t subMesh;
    std::uint32_t triangle;

    auto identity() const { return std::tie(position, subMesh); }
    bool operator<(const TriangleKey& o) const
    {
        return std::tie(position, subMesh, triangle) < std::tie(o.position, o.subMesh, o.triangle);
    }
};

TriangleKey keyOf(const WeldedTriangle& triangle, std::uint32_t number, Repetition kind)
{
    std::array<std::uint32_t, 3> corners = triangle.position;
    if (kind == Repetition::AnyWinding) {
        std::sort(corners.begin(), corners.end());
        return {corners, 0, number};
    }
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    return {corners, triangle.subMesh, number};
}

} // namespace

std::uint32_t PositionTable::insert(Position position)
{
    for (float& component : position)
        component += 0.0f; // turns -0 into +0
    if (mPositions.size() * 2 >= mSlots.size())
        grow();
    const std::size_t slot = slotOf(position);
    if (mSlots[slot] == kNone) {
        mSlots[slot] = size();
        mPositions.push_back(position);
    }
    return mSlots[slot];
}

std::size_t PositionTable::slotOf(const Position& position) const
{
    const std::size_t mask = mSlots.size() - 1;
    std::size_t slot = hash(position) & mask;
    while (mSlots[slot] != kNone && mPositions[mSlots[slot]] != position)
        slot = (slot + 1) & mask;
    return slot;
}

void PositionTable::grow()
{
    mSlots.assign(std::max<std::size_t>(64, mSlots.size() * 2), kNone);
    for (std::uint32_t i = 0; i < size(); ++i)
        mSlots[slotOf(mPositions[i])] = i;
}

Result<std::vector<WeldedTriangle>> weldTriangles(const MeshView& mesh, PositionTable& table)
{
    std::vector<std::vector<std::uint32_t>> numbers(mesh.vertexBuffers.size());
    std::vector<WeldedTriangle> triangles;
    for (std::size_t s = 0; s < mesh.subMeshes.size(); ++s) {
        const SubMeshView& subMesh = mesh.subMeshes[s];
        if (subMesh.indexCount == 0)
            continue;
        checkPromises(mesh, subMesh);
        const VertexBufferView& buffer = mesh.vertexBuffers[subMesh.vertexBuffer];
        std::vector<std::uint32_t>& known = numbers[subMesh.vertexBuffer];
        known.resize(buffer.vertexCount, kNone);
        for (std::size_t i = 0; i < subMesh.indexCount; ++i) {
            const std::uint32_t vertex = subMesh.index(i);
            if (vertex >= buffer.vertexCount)
                return errorAt(ErrorCode::IndexOutOfRange, "an index names no vertex of its buffer", s, i);
            if (known[vertex] == kNone) {
                Position position;
                buffer.positions.read(vertex, 3, position.data());
                if (!isFinite(position))
                    return errorAt(ErrorCode::InvalidGeometry, "a vertex position is not finite", s, vertex);
                known[vertex] = table.insert(position);
            }
            if (i % 3 == 0)
                triangles.push_back({{}, {}, static_cast<std::uint32_t>(s)});
            triangles.back().position[i % 3] = known[vertex];
            triangles.back().vertex[i % 3] = vertex;
        }
    }
    return triangles;
}

Result<std::vector<WeldedTriangle>> weldTrianglesInPose(const MeshView& mesh, std::size_t pose, PositionTable& table)
{
    Result<std::vector<WeldedTriangle>> welded = weldTriangles(inPose(mesh, pose), table);
    if (!welded)
        return welded;
    const auto restOf = [&](const WeldedTriangle& triangle, std::size_t corner) {
        Position position;
        mesh.vertexBuffers[mesh.subMeshes[triangle.subMesh].vertexBuffer].positions.read(triangle.vertex[corner], 3,
                                                                                         position.data());
        return position;
    };
    std::vector<WeldedTriangle>& triangles = welded.value();
    const auto collapsedAtRest = [&](const WeldedTriangle& triangle) {
        const Position a = restOf(triangle, 0), b = restOf(triangle, 1), c = restOf(triangle, 2);
        return a == b || b == c || c == a;
    };
    triangles.erase(std::remove_if(triangles.begin(), triangles.end(), collapsedAtRest), triangles.end());
    return welded;
}

std::vector<bool> findRepeated(const std::vector<WeldedTriangle>& triangles, Repetition kind)
{
    std::vector<TriangleKey> keys;
    keys.reserve(triangles.size());
    for (std::uint32_t i = 0; i < triangles.size(); ++i)
        if (!triangles[i].collapsed())
            keys.push_back(keyOf(triangles[i], i, kind));
    std::sort(keys.begin(), keys.end());
    std::vector<bool> repeated(triangles.size(), false);
    for (std::size_t i = 1; i < keys.size(); ++i)
        if (keys[i].identity() == keys[i - 1].identity())
            repeated[keys[i].triangle] = true;
    return repeated;
}

} // namespace lodsmith::analysis
