#include <lodsmith/analysis/Deviation.h>

#include "FlippedTriangles.h"
#include "SurfaceComparison.h"
#include "SurfaceIndex.h"
#include "SurfaceSampling.h"
#include "TopologyDifference.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <string>

namespace lodsmith {

namespace analysis {

namespace {

using Triangles = std::vector<WeldedTriangle>;

Error inMesh(const char* which, Error error)
{
    error.message += std::string(", in the ") + which + " mesh";
    return error;
}

bool isFinite(const FloatStream& stream, std::uint32_t vertex, int count)
{
    float values[4];
    stream.read(vertex, count, values);
    return std::all_of(values, values + count, [](float value) { return std::isfinite(value); });
}

const char* findBadAttribute(const VertexBufferView& buffer, std::uint32_t vertex)
{
    if (buffer.normals && !isFinite(buffer.normals, vertex, 3))
        return "a vertex normal is not finite";
    if (!buffer.uvSets.empty() && buffer.uvSets[0].stream
        && !isFinite(buffer.uvSets[0].stream, vertex, buffer.uvSets[0].components))
        return "a texture coordinate is not finite";
    return nullptr;
}

/// Welds one of the two meshes and checks the attributes that will be compared.
Result<Triangles> prepare(const MeshView& mesh, PositionTable& table, const char* which)
{
    Result<Triangles> welded = weldTriangles(mesh, table);
    if (!welded)
        return inMesh(which, welded.error());
    for (const WeldedTriangle& triangle : welded.value())
        for (const std::uint32_t vertex : triangle.vertex)
            if (const char* message =
                    findBadAttribute(mesh.vertexBuffers[mesh.subMeshes[triangle.subMesh].vertexBuffer], vertex)) {
                Error error{ErrorCode::InvalidGeometry, message};
                error.subMesh = static_cast<int>(triangle.subMesh);
                error.item = vertex;
                return inMesh(which, error);
            }
    return welded;
}

DeviationFigures toWorld(const DeviationFigures& local, const LocalFrame& frame)
{
    return {frame.toWorld(local.mean), frame.toWorld(local.rms), frame.toWorld(local.maximum)};
}

/// Fills in what the surfaces tell: the figures and the flipped triangles.
Result<Done> measureSurfaces(const Surface& original, const Surface& simplified, const LocalFrame& frame,
                             const DeviationOptions& options, Progress* progress, Deviation& deviation)
{
    const Result<SurfaceIndex> originalIndex = SurfaceIndex::create(original);
    const Result<SurfaceIndex> simplifiedIndex = SurfaceIndex::create(simplified);
    for (const Result<SurfaceIndex>* index : {&originalIndex, &simplifiedIndex})
        if (!*index)
            return index->error();
    const std::vector<SurfaceSample> originalVertices = sampleVertices(original);
    const std::vector<SurfaceSample> simplifiedVertices = sampleVertices(simplified);
    ComparisonProgress steps(progress, 2ull * options.samples + originalVertices.size() + simplifiedVertices.size()
                                           + simplified.triangleCount());

    const Result<SurfaceComparison> there =
        compareSurfaces(original, simplifiedIndex.value(), sampleArea(original, options.samples, 2ull * options.seed),
                        originalVertices, steps);
    if (!there)
        return there.error();
    const Result<SurfaceComparison> back =
        compareSurfaces(simplified, originalIndex.value(),
                        sampleArea(simplified, options.samples, 2ull * options.seed + 1), simplifiedVertices, steps);
    if (!back)
        return back.error();

    deviation.surface = toWorld(FigureSums::combine(there.value().distance, back.value().distance), frame);
    deviation.normal = FigureSums::combine(there.value().normal, back.value().normal);
    deviation.uv = FigureSums::combine(there.value().uv, back.value().uv);
    const Result<std::uint32_t> flipped = countFlippedTriangles(simplified, originalIndex.value(), steps);
    if (!flipped)
        return flipped.error();
    deviation.flippedTriangles = flipped.value();
    return Done{};
}

Result<Deviation> measure(const MeshView& originalMesh, const MeshView& simplifiedMesh, const DeviationOptions& options,
                          Progress* progress)
{
    PositionTable table;
    const Result<Triangles> originalTriangles = prepare(originalMesh, table, "original");
    if (!originalTriangles)
        return originalTriangles.error();
    const Result<Triangles> simplifiedTriangles = prepare(simplifiedMesh, table, "simplified");
    if (!simplifiedTriangles)
        return simplifiedTriangles.error();

    const LocalFrame frame(table.positions());
    std::vector<Vec3> points;
    points.reserve(table.size());
    for (const Position& position : table.positions())
        points.push_back(frame.toLocal(position));
    const Surface original(originalMesh, originalTriangles.value(), points);
    const Surface simplified(simplifiedMesh, simplifiedTriangles.value(), points);
    if ((original.triangleCount() == 0) != (simplified.triangleCount() == 0))
        return Error{ErrorCode::Unsupported, "one of the two meshes has no triangle, so there is no distance"};

    Deviation deviation;
    const TopologyDifference topology =
        compareTopology(originalTriangles.value(), simplifiedTriangles.value(), table.size());
    deviation.newBorderEdges = topology.newBorderEdges;
    deviation.newNonManifoldEdges = topology.newNonManifoldEdges;
    deviation.repeatedTriangles = topology.repeatedTriangles;
    deviation.degenerateTriangles = topology.degenerateTriangles;
    if (original.triangleCount() > 0) {
        const Result<Done> done = measureSurfaces(original, simplified, frame, options, progress, deviation);
        if (!done)
            return done.error();
    }
    if (progress && progress->cancelled())
        return ComparisonProgress::cancelled();
    if (progress)
        progress->report(1.0f);
    return deviation;
}

} // namespace

} // namespace analysis

Result<Deviation> measureDeviation(const MeshView& original, const MeshView& simplified,
                                   const DeviationOptions& options, Progress* progress)
{
    if (options.samples == 0)
        return Error{ErrorCode::InvalidSetting, "a measurement needs at least one sample"};
    if (progress && progress->cancelled())
        return analysis::ComparisonProgress::cancelled();
    try {
        return analysis::measure(original, simplified, options, progress);
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::OutOfMemory, "not enough memory to measure the deviation"};
    }
}

} // namespace lodsmith
