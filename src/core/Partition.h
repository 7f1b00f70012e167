#pragma once

#include "CollapseMesh.h"

#include <cstdint>
#include <vector>

namespace lodsmith {

/// A mesh in parts of about the same number of vertices, cut where they lie: halved along the longest side of what there is, again
/// and again. It depends on the mesh alone, not on the number of threads that make it.
struct Partition {
    /// @param largest vertices of a part, at most (unless they all lie in one place)
    /// @param share   of the vertices that lie before a cut. Other shares cut elsewhere.
    Partition(const CollapseMesh& mesh, std::uint32_t largest, double share, unsigned threads);

    std::size_t count() const { return firstVertex.size() - 1; }

    std::vector<std::uint32_t> vertices;    ///< those in use, part by part, ascending within each
    std::vector<std::uint32_t> firstVertex; ///< where in `vertices` each part begins; count() + 1 entries
    std::vector<std::uint32_t> place;       ///< of each vertex, where in `vertices` it is
    std::vector<std::uint32_t> faces;       ///< all with a corner in the part, part by part, ascending within each
    std::vector<std::uint32_t> firstFace;   ///< likewise

private:
    void listVertices(const std::vector<std::uint32_t>& partOf, std::size_t parts);
    void listFaces(const CollapseMesh& mesh, const std::vector<std::uint32_t>& partOf, unsigned threads);
};

} // namespace lodsmith
