#pragma once

#include "ComparisonProgress.h"
#include "SurfaceIndex.h"

#include <cstdint>
#include <vector>

namespace lodsmith::analysis {

/// Counts the triangles of a simplified surface that face against every original triangle near their centre. Triangles
/// thinner than kTolerance are not counted: where they face is a matter of rounding, and nobody sees them.
/// @param reach for each simplified triangle, the largest distance between the surfaces that was measured on it:
///              originals within this distance of the centre (or within the centre's own distance, if that is more) are
///              near
/// Takes one step of `progress` a triangle. Errors: Cancelled.
Result<std::uint32_t> countFlippedTriangles(const Surface& simplified, const SurfaceIndex& original,
                                            const std::vector<double>& reach, ComparisonProgress& progress);

} // namespace lodsmith::analysis
