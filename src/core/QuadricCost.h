#pragma once

#include "CollapseCost.h"
#include "WedgeMap.h"

namespace lodsmith {

/// Metric::Quadric: the area-weighted squared distance of the destination to the planes around the vertex, to planes that
/// hold borders and material borders (Garland and Heckbert 1997), and to the attributes that each face would have
/// there if it went on linearly (Hoppe 1999). Memoryless (Lindstrom and Turk 1998): made of the faces as they are now.
///
/// All is relative to the vertex, where a face's plane and its attributes are exactly zero: no constants, no cancellation.
class QuadricCost final : public CollapseCost {
public:
    void begin(const CollapseMesh& mesh, const OneRing& ring) override;
    Candidate cheapest() override;
    void reject(int neighbour) override;

private:
    void addPlane(const Vec3& normal, double weight);
    void addConstraints();
    double geometricCost(const Vec3& edge) const;
    double attributeCost(std::uint32_t neighbour, double limit);
    double faceAttributeCost(const OneRing::RingFace& face, const Vec3& edge, std::uint32_t target) const;
    int nextByGeometry() const;

    const CollapseMesh* mMesh = nullptr;
    const OneRing* mRing = nullptr;
    double mXX = 0, mXY = 0, mXZ = 0, mYY = 0, mYZ = 0, mZZ = 0; ///< sum of weight * normal * normal^T
    double mArea = 0;
    double mImportanceFactor = 1;
    double mGeometric[2 * OneRing::kMaxFaces]; ///< lower bound of each neighbour's cost: at first, that without attributes
    double mTotal[2 * OneRing::kMaxFaces];     ///< with attributes; negative while not known, infinite when rejected
    WedgeMap mWedges;
};

} // namespace lodsmith
