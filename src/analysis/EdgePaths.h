#pragma once

#include <cstdint>
#include <utility>
#include <vector>

namespace lodsmith::analysis {

/// Answers which vertices that a simplification kept are joined by a path of certain edges of the original that meets
/// no other kept vertex on the way: what is left of a chain of edges when the vertices along it have been collapsed.
///
/// Add the edges, then seal(), then ask. Each edge has a rank; a path's rank is the highest found among its edges and
/// those joined to it through vertices that were not kept.
class EdgePaths {
public:
    /// @param kept for each vertex, whether the simplified mesh has it
    explicit EdgePaths(const std::vector<bool>& kept);

    void add(std::uint32_t a, std::uint32_t b, std::uint32_t rank);
    void seal();
    /// Whether a path of at least this rank joins two kept vertices.
    bool join(std::uint32_t a, std::uint32_t b, std::uint32_t rank) const;

private:
    struct Edge {
        std::uint32_t a, b, rank;
    };
    using Link = std::pair<std::uint32_t, std::uint32_t>; ///< a kept vertex and a cluster that it touches

    static bool precedes(const Edge& x, const Edge& y);
    std::uint32_t clusterOf(std::uint32_t vertex);

    const std::vector<bool>& mKept;
    std::vector<Edge> mEdges;
    std::vector<std::uint32_t> mParents; ///< vertices that were not kept, merged into clusters along the edges
    std::vector<std::uint32_t> mRanks;   ///< of each cluster, at its root
    std::vector<Link> mTouched;          ///< kept vertex and cluster, sorted
    std::vector<Edge> mDirect;           ///< between kept vertices, a < b, sorted
};

} // namespace lodsmith::analysis
