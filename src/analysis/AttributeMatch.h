#pragma once

#include "SurfaceIndex.h"
#include "SurfaceSampling.h"

#include <cstdint>
#include <optional>

namespace lodsmith::analysis {

constexpr std::uint32_t kAnySubMesh = 0xffffffffu;

/// How much attributes differ between a sample and its counterpart on another surface; nothing where there is nothing
/// to compare.
struct AttributeDifference {
    std::optional<double> normal; ///< radians
    std::optional<double> uv;     ///< UV units
};

/// Finds the counterpart of a sample on another surface, near the closest point, and compares normals and UVs.
///
/// At an edge or a corner several triangles, with several wedges, are at the same distance, and on a two-sided wall
/// there is one for each side: the one that resembles the sample most is the counterpart, the others are the far side
/// of a seam. Triangles that face the other way count only where none faces the sample's. Beside a seam the closest
/// point may be beyond it by a hair. Where the UVs differ by more than a shift by twice the distance explains, the
/// closest triangle within twice the distance that is across a seam from there and whose UV does fit is taken instead.
/// @param subMesh the only one to compare with, kAnySubMesh for all; must have a triangle
/// @param distance from the sample to the closest point of `to`, of whichever submesh
AttributeDifference matchAttributes(const Surface& from, const SurfaceSample& sample, const SurfaceIndex& to,
                                    std::uint32_t subMesh, double distance);

} // namespace lodsmith::analysis
