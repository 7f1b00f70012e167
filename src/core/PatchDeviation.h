#pragma once

#include "OneRing.h"

namespace lodsmith {

/// A bound on how far one collapse moves the surface, two-sided, scaled units.
///
/// The faces around the vertex and those that replace them are laid over each other in a plane and compared where their
/// edges cross: between crossings both are linear (Cohen, Manocha and Olano 1997, successive mappings). A border is
/// first drawn straight, and a fold that has no such plane is cut in two along the edge that the collapse creates. Where
/// nothing of this fits, the length of the collapsed edge is a bound.
class PatchDeviation {
public:
    double bound(const OneRing& ring, const CollapseMesh& mesh, std::uint32_t neighbour);

private:
    /// Part of the ring in winding order: spokes from first to last.
    struct Fan {
        std::uint32_t spokes[OneRing::kMaxNeighbours]; ///< neighbour numbers
        Vec3 normal;                                  ///< area-weighted sum of the faces' normals
        std::uint32_t count = 0;
        bool closed = false;
    };

    bool collectFan(const OneRing& ring, const CollapseMesh& mesh, const Vec3& side, double sign, Fan& fan, std::uint32_t& taken) const;
    double fanBound(const OneRing& ring, Fan& fan, std::uint32_t neighbour);
    double closedBound(const OneRing& ring, const Fan& fan);
    double cutBound(const OneRing& ring, const std::uint32_t* spokes, std::uint32_t count, bool closed, std::uint32_t cut);
    bool project(const OneRing& ring, const std::uint32_t* spokes, std::uint32_t count, const Vec3& centre, const Vec3& normal, bool closed);
    double largestDifference(std::uint32_t count, bool closed) const;
    double differenceAtCentre(std::uint32_t count) const;

    double mU[OneRing::kMaxNeighbours], mV[OneRing::kMaxNeighbours], mZ[OneRing::kMaxNeighbours]; ///< spokes' ends in the plane, and above it
};

} // namespace lodsmith
