#include "LevelCurve.h"

#include <lodsmith/analysis/Deviation.h>
#include <lodsmith/core/Simplify.h>

#include <cmath>

namespace lodsmith::cli {

namespace {

constexpr int kPoints = 10;
// All vertices are compared besides, so that few are enough.
constexpr std::uint32_t kSamples = 10000;
// A plot does not go on where there is nothing left to see.
constexpr double kFewestTriangles = 8.0;

/// Deviations that double up to half the radius, as automatic levels have them, and then all that goes.
std::vector<LevelTarget> risingDeviations(double radius)
{
    std::vector<LevelTarget> targets;
    for (int i = kPoints; i >= 1 && radius > 0.0; --i)
        targets.push_back({LevelTarget::Kind::Deviation, std::ldexp(radius, -i)});
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

Result<LevelCurve> levelCurve(const MeshView& mesh, double radius)
{
    const std::vector<LevelTarget> targets = risingDeviations(radius);
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
