#pragma once

#include "OneRing.h"

#include <algorithm>
#include <limits>

namespace lodsmith {

/// A possible collapse of the vertex of a one-ring.
struct Candidate {
    int neighbour = -1; ///< destination, as numbered in the ring; -1 for none
    float cost = 0.0f;  ///< orders the queue; >= 0
};

/// What a collapse costs. Given a ring, it hands out the possible collapses from the cheapest on; those that turn out
/// to be forbidden are rejected one by one.
class CollapseCost {
public:
    virtual ~CollapseCost() = default;

    /// A quick guess at what the cheapest collapse of a vertex costs, for the first order of the queue; 0 to have it
    /// evaluated before anything else. The vertex is in use.
    virtual float guess(const CollapseMesh& mesh, std::uint32_t vertex) const = 0;

    /// Prepares for one vertex. The ring and the mesh stay unchanged until the next call.
    virtual void begin(const CollapseMesh& mesh, const OneRing& ring) = 0;

    /// The cheapest collapse not rejected; of equal ones the first in the ring.
    virtual Candidate cheapest() = 0;

    virtual void reject(int neighbour) = 0;

    /// A cost as a length, scaled units.
    virtual double lengthOf(float cost, const CollapseMesh& mesh, const OneRing& ring) const = 0;

    /// The other way round: what it costs when `area` of the surface is off by this length, scaled units.
    virtual float costOf(double length, double area) const = 0;

protected:
    static constexpr double kImpossible = std::numeric_limits<double>::infinity();

    static float finite(double cost)
    {
        constexpr double dearest = 1e30;                            // still a finite float
        return static_cast<float>(cost < dearest ? cost : dearest); // a NaN, of absurd attributes, is dear too
    }
};

} // namespace lodsmith
