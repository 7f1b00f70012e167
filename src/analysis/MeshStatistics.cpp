#include <lodsmith/analysis/MeshStatistics.h>

#include "../core/Vec3.h"
#include "EdgeUses.h"
#include "WeldedMesh.h"

#include <algorithm>
#include <limits>
#include <new>
#include <numeric>

namespace lodsmith {

namespace analysis {

namespace {

using Triangles = std::vector<WeldedTriangle>;

Vec3 toVec3(const Position& position)
{
    return {position[0], position[1], position[2]};
}

/// Whether two vertices of two streams differ in any of `count` floats.
bool differ(const FloatStream& a, std::uint32_t vertexA, const FloatStream& b, std::uint32_t vertexB, int count)
{
    float first[4], second[4];
    a.read(vertexA, count, first);
    b.read(vertexB, count, second);
    return !std::equal(first, first + count, second);
}

/// Disjoint sets of triangles, merged as edges connect them.
class Pieces {
public:
    explicit Pieces(std::size_t count) : mParents(count) { std::iota(mParents.begin(), mParents.end(), 0u); }

    std::uint32_t find(std::uint32_t triangle)
    {
        while (mParents[triangle] != triangle)
            triangle = mParents[triangle] = mParents[mParents[triangle]];
        return triangle;
    }
    void merge(std::uint32_t a, std::uint32_t b) { mParents[find(a)] = find(b); }

private:
    std::vector<std::uint32_t> mParents;
};

class EdgeCounter {
public:
    EdgeCounter(const MeshView& mesh, const Triangles& triangles, MeshStatistics& statistics)
        : mMesh(mesh), mTriangles(triangles), mStatistics(statistics)
    {
    }

    void count(const EdgeUse* uses, std::size_t useCount)
    {
        ++mStatistics.edges;
        if (useCount == 1)
            ++mStatistics.borderEdges;
        else if (useCount > 2)
            ++mStatistics.nonManifoldEdges;
        else
            countManifold(uses[0], uses[1]);
    }

private:
    void countManifold(const EdgeUse& a, const EdgeUse& b)
    {
        if (a.forward(mTriangles) == b.forward(mTriangles))
            ++mStatistics.inconsistentEdges;
        if (mTriangles[a.triangle].subMesh != mTriangles[b.triangle].subMesh)
            ++mStatistics.materialEdges;
        if (uvsDiffer(a, b, true) || uvsDiffer(a, b, false))
            ++mStatistics.uvSeamEdges;
        if (normalsDiffer(a, b, true) || normalsDiffer(a, b, false))
            ++mStatistics.normalSeamEdges;
    }

    const VertexBufferView& bufferOf(const EdgeUse& use) const
    {
        return mMesh.vertexBuffers[mMesh.subMeshes[mTriangles[use.triangle].subMesh].vertexBuffer];
    }

    /// The buffer vertex of the use's triangle at the lower or the higher end of the edge.
    std::uint32_t vertexAt(const EdgeUse& use, bool low) const
    {
        const bool first = use.forward(mTriangles) == low;
        return mTriangles[use.triangle].vertex[first ? use.corner : (use.corner + 1) % 3];
    }

    bool uvsDiffer(const EdgeUse& a, const EdgeUse& b, bool low) const
    {
        const std::vector<UvStream>& setsA = bufferOf(a).uvSets;
        const std::vector<UvStream>& setsB = bufferOf(b).uvSets;
        for (std::size_t set = 0; set < std::min(setsA.size(), setsB.size()); ++set)
            if (setsA[set].stream && setsB[set].stream
                && differ(setsA[set].stream, vertexAt(a, low), setsB[set].stream, vertexAt(b, low),
                          std::min(setsA[set].components, setsB[set].components)))
                return true;
        return false;
    }

    bool normalsDiffer(const EdgeUse& a, const EdgeUse& b, bool low) const
    {
        const FloatStream& normalsA = bufferOf(a).normals;
        const FloatStream& normalsB = bufferOf(b).normals;
        return normalsA && normalsB && differ(normalsA, vertexAt(a, low), normalsB, vertexAt(b, low), 3);
    }

    const MeshView& mMesh;
    const Triangles& mTriangles;
    MeshStatistics& mStatistics;
};

void countVertices(const MeshView& mesh, const Triangles& triangles, MeshStatistics& statistics)
{
    std::vector<std::vector<bool>> used(mesh.vertexBuffers.size());
    for (std::size_t i = 0; i < used.size(); ++i) {
        used[i].resize(mesh.vertexBuffers[i].vertexCount, false);
        statistics.bufferVertices += mesh.vertexBuffers[i].vertexCount;
    }
    for (const WeldedTriangle& triangle : triangles)
        for (const std::uint32_t vertex : triangle.vertex)
            used[mesh.subMeshes[triangle.subMesh].vertexBuffer][vertex] = true;
    for (const std::vector<bool>& buffer : used)
        statistics.unreferencedVertices += static_cast<std::uint32_t>(std::count(buffer.begin(), buffer.end(), false));
}

void countTriangles(const Triangles& triangles, const std::vector<Position>& positions, MeshStatistics& statistics)
{
    statistics.triangles = static_cast<std::uint32_t>(triangles.size());
    for (const WeldedTriangle& triangle : triangles) {
        const Vec3 a = toVec3(positions[triangle.position[0]]);
        const Vec3 b = toVec3(positions[triangle.position[1]]);
        const Vec3 c = toVec3(positions[triangle.position[2]]);
        const double area = length(cross(b - a, c - a)) / 2.0;
        statistics.surfaceArea += area;
        if (triangle.collapsed() || area == 0.0)
            ++statistics.degenerateTriangles;
    }
    const std::vector<bool> repeated = findRepeated(triangles, Repetition::AnyWinding);
    statistics.repeatedTriangles = static_cast<std::uint32_t>(std::count(repeated.begin(), repeated.end(), true));
}

void countEdges(const MeshView& mesh, const Triangles& triangles, MeshStatistics& statistics)
{
    std::vector<bool> collapsed(triangles.size());
    for (std::size_t i = 0; i < triangles.size(); ++i)
        collapsed[i] = triangles[i].collapsed();
    Pieces pieces(triangles.size());
    EdgeCounter counter(mesh, triangles, statistics);
    forEachEdge(sortedEdgeUses(triangles, collapsed), [&](const EdgeUse* uses, std::size_t count) {
        counter.count(uses, count);
        for (std::size_t i = 1; i < count; ++i)
            pieces.merge(uses[0].triangle, uses[i].triangle);
    });
    for (std::uint32_t i = 0; i < triangles.size(); ++i)
        if (!collapsed[i] && pieces.find(i) == i)
            ++statistics.components;
}

double boundingRadius(const std::vector<Position>& positions)
{
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    Vec3 low{kInfinity, kInfinity, kInfinity}, high = low * -1.0;
    for (const Position& position : positions) {
        low = {std::min<double>(low.x, position[0]), std::min<double>(low.y, position[1]),
               std::min<double>(low.z, position[2])};
        high = {std::max<double>(high.x, position[0]), std::max<double>(high.y, position[1]),
                std::max<double>(high.z, position[2])};
    }
    const Vec3 centre = (low + high) * 0.5;
    double radius = 0.0;
    for (const Position& position : positions)
        radius = std::max(radius, length(toVec3(position) - centre));
    return radius;
}

Result<MeshStatistics> countMesh(const MeshView& mesh)
{
    PositionTable table;
    const Result<Triangles> welded = weldTriangles(mesh, table);
    if (!welded)
        return welded.error();
    MeshStatistics statistics;
    statistics.vertices = table.size();
    statistics.radius = boundingRadius(table.positions());
    countVertices(mesh, welded.value(), statistics);
    countTriangles(welded.value(), table.positions(), statistics);
    countEdges(mesh, welded.value(), statistics);
    return statistics;
}

} // namespace

} // namespace analysis

Result<MeshStatistics> meshStatistics(const MeshView& mesh)
{
    try {
        return analysis::countMesh(mesh);
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::OutOfMemory, "not enough memory to count the mesh"};
    }
}

} // namespace lodsmith
