#pragma once

#include "CollapseCost.h"
#include "SymmetricMatrix.h"
#include "WedgeMap.h"

namespace lodsmith {

/// Metric::Quadric: the area-weighted squared distance of the destination to the planes around the vertex and to planes
/// that hold borders, seams and material borders (Garland and Heckbert 1997), memoryless (Lindstrom and Turk 1998): made of the
/// faces as they are now. To this is added, for each wedge, the squared difference between the attributes that it
/// gets at the destination and those that it would have there if the face behind it went on (Hoppe 1999, who takes the
/// sum over all faces; the face opposite to the collapse tells as much at a fifth of the time, see docs/simplifier.md).
///
/// All is relative to the vertex, where a face's plane and its attributes are exactly zero: no constants, no cancellation.
class QuadricCost final : public CollapseCost {
public:
    void begin(const CollapseMesh& mesh, const OneRing& ring) override;
    float guess() override;
    Candidate cheapest() override;
    void reject(int neighbour) override { mBound[neighbour] = kImpossible; }
    double lengthOf(float cost, const CollapseMesh& mesh, const OneRing& ring) const override;
    float costOf(double length, double area) const override { return finite(area * length * length); }

private:
    void addConstraints();
    double seamWeight(const OneRing::RingFace& a, const OneRing::RingFace& b, std::uint32_t neighbour) const;
    double attributeCost(std::uint32_t neighbour);
    double wedgeCost(const Vec3& edge, const double* along, std::uint32_t wedge, std::uint32_t target) const;

    const CollapseMesh* mMesh = nullptr;
    const OneRing* mRing = nullptr;
    SymmetricMatrix mQuadric;
    double mArea = 0.0;
    double mImportanceFactor = 1.0;
    bool mExact[OneRing::kMaxNeighbours];   ///< whether mBound has the attributes in it
    double mBound[OneRing::kMaxNeighbours]; ///< of each neighbour's cost, from below; kImpossible when rejected
    WedgeMap mWedges;
};

} // namespace lodsmith
