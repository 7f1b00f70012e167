#include <lodsmith/analysis/DeviationCurve.h>

#include <cmath>
#include <new>
#include <string>

namespace lodsmith {

namespace {

double trianglesOf(const MeshView& mesh)
{
    double indices = 0.0;
    for (const SubMeshView& subMesh : mesh.subMeshes)
        indices += subMesh.indexCount;
    return std::floor(indices / 3.0);
}

/// Whole numbers from below `triangles` to 1, each once.
std::vector<LevelTarget> fallingCounts(double triangles, unsigned points)
{
    std::vector<LevelTarget> targets;
    double before = triangles;
    for (unsigned i = 1; i <= points; ++i) {
        const double count = std::floor(std::pow(triangles, 1.0 - static_cast<double>(i) / points));
        if (count < before)
            targets.push_back({LevelTarget::Kind::Triangles, count});
        before = count;
    }
    return targets;
}

std::vector<LevelPoint> pointsOf(const LodChain& chain)
{
    std::vector<LevelPoint> points{{chain.triangles, chain.vertices, 0.0}};
    for (const LodChainLevel& level : chain.levels)
        if (!level.skipped)
            points.push_back({level.triangles, level.vertices, level.deviation});
    return points;
}

} // namespace

Result<std::vector<LevelPoint>> deviationCurve(const MeshView& mesh, const SimplifyOptions& options, unsigned points,
                                               Progress* progress)
{
    if (points == 0 || points > kMaxCurvePoints)
        return Error{ErrorCode::InvalidSetting,
                     "a curve has 1 to " + std::to_string(kMaxCurvePoints) + " points, not " + std::to_string(points)};
    try {
        const Result<LodChain> chain = simplify(mesh, fallingCounts(trianglesOf(mesh), points), options, progress);
        if (!chain)
            return chain.error();
        return pointsOf(chain.value());
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::OutOfMemory, "not enough memory for the curve"};
    }
}

} // namespace lodsmith
