#include "LevelCurve.h"

#include <lodsmith/analysis/Deviation.h>
#include <lodsmith/core/Simplify.h>

#include <algorithm>
#include <cmath>

namespace lodsmith::cli {

namespace {

constexpr int kPoints = 10;
// All vertices are compared besides, so that few are enough.
constexpr std::uint32_t kSamples = 10000;
// A plot does not go on where there is nothing left to see.
constexpr double kFewestTriangles = 8.0;

std::vector<LevelTarget> fallingCounts(const MeshView& mesh)
{
    double indices = 0.0;
    for (const SubMeshView& subMesh : mesh.subMeshes)
        indices += subMesh.indexCount;
    const double triangles = std::floor(indices / 3.0);
    const double fewest = std::min(kFewestTriangles, triangles);
    std::vector<LevelTarget> targets;
    for (int i = 1; i <= kPoints && triangles > 0.0; ++i)
        targets.push_back({LevelTarget::Kind::Triangles,
                           std::floor(triangles * std::pow(fewest / triangles, static_cast<double>(i) / kPoints))});
    targets.push_back({LevelTarget::Kind::Triangles, 0.0});
    return targets;
}

MeshView mereShape(MeshView mesh)
{
    for (VertexBufferView& buffer : mesh.vertexBuffers) {
        buffer.normals = {};
        buffer.uvSets.clear();
        buffer.colours = {};
        buffer.bones = nullptr;
    }
    return mesh;
}

MeshView viewOf(const MeshView& mesh, const LodChainLevel& level)
{
    MeshView view = mesh;
    for (std::size_t i = 0; i < view.subMeshes.size(); ++i) {
        view.subMeshes[i].indices = level.indices[i].data();
        view.subMeshes[i].indexCount = static_cast<std::uint32_t>(level.indices[i].size());
        view.subMeshes[i].indexBytes = 4;
    }
    return view;
}

/// The bounds of a chain, in the place of measured deviations: cheap, and good for comparing one with another.
std::vector<CurvePoint> boundsOf(const LodChain& chain)
{
    std::vector<CurvePoint> points{{static_cast<double>(chain.triangles), 0.0}};
    for (const LodChainLevel& level : chain.levels)
        if (!level.skipped)
            points.push_back({static_cast<double>(level.triangles), level.deviation});
    return points;
}

Result<std::vector<CurvePoint>> measure(const MeshView& mesh, const LodChain& chain)
{
    std::vector<CurvePoint> points{{static_cast<double>(chain.triangles), 0.0}};
    for (const LodChainLevel& level : chain.levels) {
        if (level.skipped || level.triangles < kFewestTriangles)
            continue;
        const Result<Deviation> deviation = measureDeviation(mesh, viewOf(mesh, level), {kSamples, 1});
        if (!deviation)
            return deviation.error();
        points.push_back({static_cast<double>(level.triangles), deviation.value().surface.maximum});
    }
    return points;
}

} // namespace

Result<LevelCurve> levelCurve(const MeshView& mesh)
{
    const std::vector<LevelTarget> targets = fallingCounts(mesh);
    const Result<LodChain> chain = simplify(mesh, targets);
    if (!chain)
        return chain.error();
    const Result<LodChain> shape = simplify(mereShape(mesh), targets);
    if (!shape)
        return shape.error();
    const Result<std::vector<CurvePoint>> measured = measure(mesh, chain.value());
    if (!measured)
        return measured.error();
    LevelCurve curve;
    curve.measured = measured.value();
    curve.seamFactor = trianglesFactor(boundsOf(chain.value()), boundsOf(shape.value()));
    curve.least = chain.value().levels.back().triangles;
    curve.leastStop = chain.value().levels.back().stop;
    return curve;
}

} // namespace lodsmith::cli
