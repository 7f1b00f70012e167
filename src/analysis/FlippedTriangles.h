#pragma once

#include "ComparisonProgress.h"
#include "SurfaceIndex.h"

#include <cstdint>

namespace lodsmith::analysis {

/// Counts the triangles of a simplified surface that face against the original at their corners.
///
/// Corners are where the two surfaces are known to be the same: near the rest of a triangle, the other side of a thin
/// sheet may be closer than the side it stands for. The original at a corner are the triangles that have a vertex
/// there; where none has, those at the point closest to it. A triangle faces against them when its cosine with their
/// normals, averaged over the three corners, is below -0.02 (standing across the original, as on the side of a box, is
/// not enough, to a degree), and that twice:
///   - with all of them, each weighted by its angle at the corner: at the edge of a blade or a crease this mean points
///     away from the edge, so that triangles of either side agree with it;
///   - with those that leave the corner in the direction of the triangle's centre, to 0.05 radians, taking of several
///     the one that agrees best: so a triangle of the original itself is never flipped, whatever it is next to.
/// A triangle that agrees with these to 45 degrees at one corner is not flipped either: where it faces against the
/// others, it reaches round an edge, from one side of a sheet to the other.
///
/// Triangles thinner than kTolerance are not counted: where they face is a matter of rounding, and nobody sees them.
/// Both surfaces need the same points. Takes one step of `progress` a triangle. Errors: Cancelled.
Result<std::uint32_t> countFlippedTriangles(const Surface& simplified, const SurfaceIndex& original,
                                            ComparisonProgress& progress);

} // namespace lodsmith::analysis
