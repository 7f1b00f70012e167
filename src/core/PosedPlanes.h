#pragma once

#include "PosedRing.h"

namespace lodsmith {

/// The part of Metric::Quadric that comes of planes, in the poses of a mesh: squared distances of a vertex's neighbours
/// to the planes of its faces, and to those upright on edges that are held, four poses at a time.
class PosedPlanes {
public:
    /// An edge of the ring with a plane upright on it, and how much that counts.
    struct HeldEdge {
        std::uint32_t neighbour;
        float weight;
    };

    /// @param ring  has to be posed
    /// @param bonus added to each face's area
    void measure(const OneRing& ring, std::size_t groups, float bonus, const HeldEdge* held, std::uint32_t heldCount);

    /// What the i-th neighbour costs, added over all poses.
    float sum(std::uint32_t i) const { return mSum[i]; }

private:
    struct Plane {
        Lanes3 normal;
        Lanes weight;
    };

    void addFaces(const PosedRing& posed, const OneRing& ring, float bonus);
    void addHeld(const PosedRing& posed, const OneRing& ring, const HeldEdge& held);

    std::uint32_t mCount = 0;
    Plane mPlanes[OneRing::kMaxFaces + OneRing::kMaxNeighbours]; ///< those of the faces, then those of the edges
    float mSum[OneRing::kMaxNeighbours];
};

} // namespace lodsmith
