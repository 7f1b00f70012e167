#pragma once

#include "OneRing.h"

namespace lodsmith {

/// A possible collapse of the vertex of a one-ring.
struct Candidate {
    int neighbour = -1;  ///< destination, as numbered in the ring; -1 for none
    float cost = 0.0f;   ///< orders the queue; >= 0
    double length = 0.0; ///< the cost as a length, scaled units
};

/// What a collapse costs. Given a ring, it hands out the possible collapses from the cheapest on; those that turn out
/// to be forbidden are rejected one by one.
class CollapseCost {
public:
    virtual ~CollapseCost() = default;

    /// Prepares for one vertex. The ring and the mesh stay unchanged until the next call.
    virtual void begin(const CollapseMesh& mesh, const OneRing& ring) = 0;

    /// The cheapest collapse not rejected; equal ones by ring order.
    virtual Candidate cheapest() = 0;

    virtual void reject(int neighbour) = 0;
};

} // namespace lodsmith
