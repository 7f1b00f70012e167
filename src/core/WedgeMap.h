#pragma once

#include "OneRing.h"

namespace lodsmith {

/// Which wedge of the destination each wedge of a collapsing vertex becomes.
///
/// A wedge that shares a face with the destination goes where that face says, so that both sides of a seam that runs
/// along the edge stay on their side. Any other takes the nearest wedge of its own submesh at the destination.
/// Across a split of motion (closed lips) nothing collapses.
class WedgeMap {
public:
    /// False when some wedge has nowhere to go.
    bool build(const CollapseMesh& mesh, const OneRing& ring, std::uint32_t neighbour);

    /// What the ring's i-th wedge becomes.
    std::uint32_t to(std::uint32_t i) const { return mTo[i]; }

private:
    void match(const CollapseMesh& mesh, const OneRing& ring, std::uint32_t neighbour);
    void match(const CollapseMesh& mesh, const OneRing& ring, const OneRing::RingFace& face, std::uint32_t neighbour);
    static std::uint32_t nearest(const CollapseMesh& mesh, std::uint32_t vertex, std::uint32_t wedge,
                                 std::uint32_t motion);
    static std::uint32_t motionThere(const CollapseMesh& mesh, const OneRing& ring, std::uint32_t neighbour,
                                     std::uint32_t wedge);
    static bool isSplit(const CollapseMesh& mesh, const OneRing& ring, std::uint32_t neighbour);
    static bool motionAllows(const CollapseMesh& mesh, const OneRing& ring, std::uint32_t neighbour);

    std::uint32_t mTo[OneRing::kMaxFaces];
};

} // namespace lodsmith
