#include <lodsmith/analysis/SurfaceDistances.h>

#include "ComparisonProgress.h"
#include "SurfaceIndex.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <new>

namespace lodsmith {

namespace analysis {

namespace {

using VertexDistances = std::vector<std::vector<float>>;

std::vector<Vec3> localPoints(const PositionTable& table, const LocalFrame& frame)
{
    std::vector<Vec3> points;
    points.reserve(table.size());
    for (const Position& position : table.positions())
        points.push_back(frame.toLocal(position));
    return points;
}

/// Distances of the first `count` points, in world units.
Result<std::vector<float>> distancesOf(const std::vector<Vec3>& points, std::size_t count, const SurfaceIndex& surface,
                                       const LocalFrame& frame, ComparisonProgress& steps)
{
    std::vector<float> distances;
    distances.reserve(count);
    std::uint32_t guess = 0;
    for (std::size_t i = 0; i < count; ++i) {
        if (!steps.step())
            return ComparisonProgress::cancelled();
        const ClosestHit hit = surface.closest(points[i], guess);
        guess = hit.triangle;
        constexpr double kMost = std::numeric_limits<float>::max();
        distances.push_back(static_cast<float>(std::min(frame.toWorld(hit.distance()), kMost)));
    }
    return distances;
}

Result<std::vector<float>> distancesOf(const MeshView& to, const std::vector<WeldedTriangle>& triangles,
                                       const PositionTable& table, std::size_t count, ComparisonProgress& steps)
{
    const LocalFrame frame(table.positions());
    const std::vector<Vec3> points = localPoints(table, frame);
    const Surface surface(to, triangles, points);
    if (count == 0)
        return std::vector<float>{};
    if (surface.triangleCount() == 0)
        return Error{ErrorCode::Unsupported, "the other mesh has no triangle, so there is no distance"};
    const Result<SurfaceIndex> index = SurfaceIndex::create(surface);
    if (!index)
        return index.error();
    return distancesOf(points, count, index.value(), frame, steps);
}

/// From distances of welded positions to distances of the vertices that lie there.
VertexDistances spread(const MeshView& mesh, const std::vector<WeldedTriangle>& triangles,
                       const std::vector<float>& distances)
{
    VertexDistances result;
    result.reserve(mesh.vertexBuffers.size());
    for (const VertexBufferView& buffer : mesh.vertexBuffers)
        result.emplace_back(buffer.vertexCount, 0.0f);
    for (const WeldedTriangle& triangle : triangles) {
        std::vector<float>& ofBuffer = result[mesh.subMeshes[triangle.subMesh].vertexBuffer];
        for (std::size_t corner = 0; corner < 3; ++corner)
            ofBuffer[triangle.vertex[corner]] = distances[triangle.position[corner]];
    }
    return result;
}

/// At rest, or in the pose whose views these are.
Result<VertexDistances> measure(const MeshView& from, const MeshView& to, ComparisonProgress& steps)
{
    PositionTable table;
    const Result<std::vector<WeldedTriangle>> fromTriangles = weldTriangles(from, table);
    if (!fromTriangles)
        return fromTriangles.error();
    const std::size_t fromPositions = table.size();
    const Result<std::vector<WeldedTriangle>> toTriangles = weldTriangles(to, table);
    if (!toTriangles)
        return toTriangles.error();
    const Result<std::vector<float>> distances = distancesOf(to, toTriangles.value(), table, fromPositions, steps);
    if (!distances)
        return distances.error();
    return spread(from, fromTriangles.value(), distances.value());
}

void raise(VertexDistances& distances, const VertexDistances& others)
{
    for (std::size_t b = 0; b < distances.size(); ++b)
        for (std::size_t v = 0; v < distances[b].size(); ++v)
            distances[b][v] = std::max(distances[b][v], others[b][v]);
}

Result<VertexDistances> measureAll(const MeshView& from, const MeshView& to, Progress* progress)
{
    const std::size_t poses = poseCount(from) == poseCount(to) ? poseCount(from) : 0;
    std::uint64_t vertices = 0;
    for (const VertexBufferView& buffer : from.vertexBuffers)
        vertices += buffer.vertexCount;
    ComparisonProgress steps(progress, (1 + poses) * vertices);
    Result<VertexDistances> result = measure(from, to, steps);
    for (std::size_t pose = 0; pose < poses && result; ++pose) {
        const Result<VertexDistances> posed = measure(inPose(from, pose), inPose(to, pose), steps);
        if (posed)
            raise(result.value(), posed.value());
        else if (posed.error().code != ErrorCode::Unsupported)
            return posed.error();
    }
    if (!result)
        return result.error();
    if (progress && progress->cancelled())
        return ComparisonProgress::cancelled();
    if (progress)
        progress->report(1.0f);
    return result;
}

} // namespace

} // namespace analysis

Result<std::vector<std::vector<float>>> surfaceDistances(const MeshView& from, const MeshView& to, Progress* progress)
{
    if (progress && progress->cancelled())
        return analysis::ComparisonProgress::cancelled();
    try {
        return analysis::measureAll(from, to, progress);
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::OutOfMemory, "not enough memory to measure the distances"};
    }
}

} // namespace lodsmith
