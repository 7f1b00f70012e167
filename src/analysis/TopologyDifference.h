#pragma once

#include "WeldedMesh.h"

#include <cstdint>
#include <vector>

namespace lodsmith::analysis {

/// The counts of Deviation that need no distances; see there for what each one means.
struct TopologyDifference {
    std::uint32_t newBorderEdges = 0;
    std::uint32_t newNonManifoldEdges = 0;
    std::uint32_t repeatedTriangles = 0;
    std::uint32_t degenerateTriangles = 0;
};

/// Compares two meshes that were welded with one table of `positionCount` positions.
TopologyDifference compareTopology(const std::vector<WeldedTriangle>& original,
                                   const std::vector<WeldedTriangle>& simplified, std::uint32_t positionCount);

} // namespace lodsmith::analysis
