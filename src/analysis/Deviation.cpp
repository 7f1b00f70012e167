#include <lodsmith/analysis/Deviation.h>

#include "FlippedTriangles.h"
#include "SurfaceComparison.h"
#include "SurfaceIndex.h"
#include "SurfaceSampling.h"
#include "TopologyDifference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <new>
#include <optional>
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

std::vector<Vec3> localPoints(const PositionTable& table, const LocalFrame& frame)
{
    std::vector<Vec3> points;
    points.reserve(table.size());
    for (const Position& position : table.positions())
        points.push_back(frame.toLocal(position));
    return points;
}

/// The two meshes, at rest or in one pose, as surfaces in one frame.
struct SurfacePair {
    SurfacePair(const MeshView& originalMesh, const Triangles& originalTriangles, const MeshView& simplifiedMesh,
                const Triangles& simplifiedTriangles, const PositionTable& table)
        : frame(table.positions()), points(localPoints(table, frame)),
          original(originalMesh, originalTriangles, points), simplified(simplifiedMesh, simplifiedTriangles, points)
    {
    }
    SurfacePair(const SurfacePair&) = delete;
    SurfacePair& operator=(const SurfacePair&) = delete;

    LocalFrame frame;
    std::vector<Vec3> points;
    Surface original, simplified;
};

/// What both comparisons need: samples of both surfaces, and indices to search them.
struct Measuring {
    Result<SurfaceIndex> originalIndex, simplifiedIndex;
    std::vector<SurfaceSample> originalArea, simplifiedArea, originalVertices, simplifiedVertices;

    Measuring(const SurfacePair& pair, const DeviationOptions& options)
        : originalIndex(SurfaceIndex::create(pair.original)), simplifiedIndex(SurfaceIndex::create(pair.simplified)),
          originalArea(sampleArea(pair.original, options.samples, 2ull * options.seed)),
          simplifiedArea(sampleArea(pair.simplified, options.samples, 2ull * options.seed + 1)),
          originalVertices(sampleVertices(pair.original)), simplifiedVertices(sampleVertices(pair.simplified))
    {
    }

    std::uint64_t samples() const
    {
        return originalArea.size() + simplifiedArea.size() + originalVertices.size() + simplifiedVertices.size();
    }
    Result<Done> indexed() const
    {
        for (const Result<SurfaceIndex>* index : {&originalIndex, &simplifiedIndex})
            if (!*index)
                return index->error();
        return Done{};
    }
};

/// Runs one of the comparisons both ways.
template <class Compared>
Result<std::array<Compared, 2>>
bothWays(const SurfacePair& pair, const Measuring& measuring, ComparisonProgress& steps,
         Result<Compared> (*compare)(const Surface&, const SurfaceIndex&, const std::vector<SurfaceSample>&,
                                     const std::vector<SurfaceSample>&, ComparisonProgress&))
{
    const Result<Compared> there = compare(pair.original, measuring.simplifiedIndex.value(), measuring.originalArea,
                                           measuring.originalVertices, steps);
    if (!there)
        return there.error();
    const Result<Compared> back = compare(pair.simplified, measuring.originalIndex.value(), measuring.simplifiedArea,
                                          measuring.simplifiedVertices, steps);
    if (!back)
        return back.error();
    return std::array<Compared, 2>{there.value(), back.value()};
}

/// Fills in what the surfaces at rest tell: the figures and the flipped triangles.
Result<Done> measureSurfaces(const SurfacePair& pair, const Measuring& measuring, ComparisonProgress& steps,
                             Deviation& deviation)
{
    const auto compared = bothWays(pair, measuring, steps, compareSurfaces);
    if (!compared)
        return compared.error();
    const auto& [there, back] = compared.value();
    deviation.surface = toWorld(FigureSums::combine(there.distance, back.distance), pair.frame);
    deviation.normal = FigureSums::combine(there.normal, back.normal);
    deviation.uv = FigureSums::combine(there.uv, back.uv);
    const Result<std::uint32_t> flipped =
        countFlippedTriangles(pair.simplified, measuring.originalIndex.value(), steps);
    if (!flipped)
        return flipped.error();
    deviation.flippedTriangles = flipped.value();
    return Done{};
}

/// The distances in one pose; nothing when either mesh has no triangle left in it.
Result<std::optional<DeviationFigures>> measurePose(const MeshView& originalMesh, const MeshView& simplifiedMesh,
                                                    std::size_t pose, const DeviationOptions& options,
                                                    ComparisonProgress& steps)
{
    PositionTable table;
    const Result<Triangles> originalTriangles = weldTrianglesInPose(originalMesh, pose, table);
    if (!originalTriangles)
        return inMesh("original", originalTriangles.error());
    const Result<Triangles> simplifiedTriangles = weldTrianglesInPose(simplifiedMesh, pose, table);
    if (!simplifiedTriangles)
        return inMesh("simplified", simplifiedTriangles.error());
    const SurfacePair pair(originalMesh, originalTriangles.value(), simplifiedMesh, simplifiedTriangles.value(), table);
    if (pair.original.triangleCount() == 0 || pair.simplified.triangleCount() == 0)
        return std::optional<DeviationFigures>();
    const Measuring measuring(pair, options);
    if (const Result<Done> indexed = measuring.indexed(); !indexed)
        return indexed.error();
    const auto compared = bothWays(pair, measuring, steps, compareDistances);
    if (!compared)
        return compared.error();
    return std::optional(toWorld(FigureSums::combine(compared.value()[0], compared.value()[1]), pair.frame));
}

/// Adds what the poses tell to the figures of rest.
Result<Done> measurePoses(const MeshView& original, const MeshView& simplified, std::size_t poses,
                          const DeviationOptions& options, ComparisonProgress& steps, Deviation& deviation)
{
    DeviationFigures& surface = deviation.surface;
    double sum = surface.mean, squares = surface.rms * surface.rms;
    for (std::size_t pose = 0; pose < poses; ++pose) {
        const auto measured = measurePose(original, simplified, pose, options, steps);
        if (!measured) {
            Error error = measured.error();
            if (error.code == ErrorCode::InvalidGeometry)
                error.message += ", in pose " + std::to_string(pose);
            return error;
        }
        const std::optional<DeviationFigures>& figures = measured.value();
        if (!figures)
            continue;
        ++deviation.poses;
        sum += figures->mean;
        squares += figures->rms * figures->rms;
        surface.maximum = std::max(surface.maximum, figures->maximum);
    }
    if (deviation.poses != 0) {
        surface.mean = sum / (1.0 + deviation.poses);
        surface.rms = std::sqrt(squares / (1.0 + deviation.poses));
    }
    return Done{};
}

Result<Done> measureAll(const SurfacePair& pair, const DeviationOptions& options, Progress* progress,
                        Deviation& deviation)
{
    const MeshView &original = pair.original.mesh(), &simplified = pair.simplified.mesh();
    const std::size_t poses = poseCount(original) == poseCount(simplified) ? poseCount(original) : 0;
    const Measuring measuring(pair, options);
    if (const Result<Done> indexed = measuring.indexed(); !indexed)
        return indexed.error();
    ComparisonProgress steps(progress, (1 + poses) * measuring.samples() + pair.simplified.triangleCount());
    const Result<Done> measured = measureSurfaces(pair, measuring, steps, deviation);
    return measured ? measurePoses(original, simplified, poses, options, steps, deviation) : measured;
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

    const SurfacePair pair(originalMesh, originalTriangles.value(), simplifiedMesh, simplifiedTriangles.value(), table);
    if ((pair.original.triangleCount() == 0) != (pair.simplified.triangleCount() == 0))
        return Error{ErrorCode::Unsupported, "one of the two meshes has no triangle, so there is no distance"};

    Deviation deviation;
    const TopologyDifference topology =
        compareTopology(originalTriangles.value(), simplifiedTriangles.value(), table.size());
    deviation.newBorderEdges = topology.newBorderEdges;
    deviation.newNonManifoldEdges = topology.newNonManifoldEdges;
    deviation.repeatedTriangles = topology.repeatedTriangles;
    deviation.degenerateTriangles = topology.degenerateTriangles;
    if (pair.original.triangleCount() > 0) {
        const Result<Done> done = measureAll(pair, options, progress, deviation);
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
