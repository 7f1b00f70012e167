#pragma once

#include <lodsmith/core/Export.h>
#include <lodsmith/core/MeshView.h>
#include <lodsmith/core/Progress.h>
#include <lodsmith/core/Result.h>
#include <lodsmith/core/Simplify.h>

#include <cstdint>
#include <vector>

namespace lodsmith {

/// What a level of so many triangles costs in shape.
struct LevelPoint {
    std::uint32_t triangles = 0;
    std::uint32_t vertices = 0; ///< referenced positions after welding
    double deviation = 0.0;     ///< world units: the bound of LodChainLevel
};

constexpr unsigned kMaxCurvePoints = 256;

/// Deviation against triangles, for the graph from which levels are chosen: simplifies once, and says what is left and how far
/// it is off at triangle counts that fall by the same factor each, from those of the mesh to one.
///
/// The first point is the mesh itself, with deviation 0. Triangles fall from point to point, and deviation never does. A
/// point is what simplify() gives for a LevelTarget of that count, so that it may have a few triangles fewer than asked.
/// Counts that come out the same, and those below what simplify() can reach, are left out: the last point is the least there
/// is.
///
/// Errors: InvalidSetting for `points` out of range, and those of simplify().
/// Thread-safe; uses the calling thread only; throws nothing.
///
/// @param points   triangle counts besides the mesh's own, 1..kMaxCurvePoints
/// @param progress may be null
LODSMITH_API Result<std::vector<LevelPoint>> deviationCurve(const MeshView& mesh, const SimplifyOptions& options,
                                                            unsigned points, Progress* progress = nullptr);

} // namespace lodsmith
