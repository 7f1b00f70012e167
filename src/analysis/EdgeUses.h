#pragma once

#include "WeldedMesh.h"

#include <lodsmith/core/Export.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lodsmith::analysis {

/// One side of one triangle, as a use of the edge between two welded positions.
struct EdgeUse {
    std::uint32_t low, high; ///< positions at the ends, low < high
    std::uint32_t triangle;
    std::uint32_t corner; ///< the side runs from this corner of the triangle to the next

    /// Whether the triangle runs from low to high.
    bool forward(const std::vector<WeldedTriangle>& triangles) const
    {
        return triangles[triangle].position[corner] == low;
    }
};

/// Every side of every triangle that `skipped` does not leave out, sorted so that the uses of an edge follow each
/// other. Exported for the generators.
LODSMITH_API std::vector<EdgeUse> sortedEdgeUses(const std::vector<WeldedTriangle>& triangles,
                                                 const std::vector<bool>& skipped);

/// Calls `visit(const EdgeUse* uses, std::size_t count)` once for each edge.
template <class Visitor>
void forEachEdge(const std::vector<EdgeUse>& uses, Visitor&& visit)
{
    for (std::size_t begin = 0, end = 0; begin < uses.size(); begin = end) {
        while (end < uses.size() && uses[end].low == uses[begin].low && uses[end].high == uses[begin].high)
            ++end;
        visit(&uses[begin], end - begin);
    }
}

} // namespace lodsmith::analysis
