#pragma once

#include "DrawnTriangles.h"

#include <lodsmith/core/LodChain.h>
#include <lodsmith/core/MeshView.h>
#include <lodsmith/core/Result.h>

#include <cstdint>
#include <vector>

namespace lodsmith::cli {

/// What a mesh can be simplified to.
struct LevelCurve {
    /// Maximum deviation, measured, world units, and triangles at bounds on it that double each time; the mesh itself first.
    std::vector<CurvePoint> measured;
    /// How many times as many triangles its texture seams and other attributes cost at equal deviation, >= 0; about 1
    /// when none.
    double seamFactor = 1.0;
    std::uint32_t least = 0;                          ///< triangles at which simplifying ends
    StopReason leastStop = StopReason::TargetReached; ///< and why it ends there
};

/// Simplifies a mesh with the usual settings, and once more its mere shape, without normals, texture coordinates,
/// colours and bones. Errors: those of simplify() and measureDeviation().
/// @param radius of the mesh, MeshStatistics::radius
Result<LevelCurve> levelCurve(const MeshView& mesh, double radius);

} // namespace lodsmith::cli
