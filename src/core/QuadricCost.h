#pragma once

#include "CollapseCost.h"
#include "PosedPlanes.h"
#include "WedgeMap.h"

namespace lodsmith {

/// Metric::Quadric: the area-weighted squared distance of the destination to the planes around the vertex and to planes
/// that hold borders, seams and material borders (Garland and Heckbert 1997), memoryless (Lindstrom and Turk 1998): made of the
/// faces as they are now. To this is added, for each wedge, the squared difference between the attributes that it
/// gets at the destination and those that it would have there if the face behind it went on (Hoppe 1999, who takes the
/// sum over all faces; the face opposite to the collapse tells as much at a fifth of the time, see docs/simplifier.md).
///
/// Of a mesh with poses, the part of the planes is the mean over rest and all poses (Mohr and Gleicher 2003).
///
/// All is relative to the vertex, where a face's plane and its attributes are exactly zero: no constants, no cancellation, and
/// distances to planes rather than a matrix, so that floats are enough.
class QuadricCost final : public CollapseCost {
public:
    float guess(const CollapseMesh& mesh, std::uint32_t vertex) const override;
    void begin(const CollapseMesh& mesh, const OneRing& ring) override;
    Candidate cheapest() override;
    void reject(int neighbour) override { mBound[neighbour] = kNever; }
    double lengthOf(float cost, const CollapseMesh& mesh, const OneRing& ring) const override;
    float costOf(double length, double area) const override { return finite(area * length * length); }

private:
    static constexpr std::uint32_t kLanes = 4;
    static constexpr float kNever = std::numeric_limits<float>::infinity();

    /// A plane through the vertex; the normal's length counts.
    struct Plane {
        float x, y, z, weight;
    };

    static double importanceFactor(const CollapseMesh& mesh, std::uint32_t vertex);
    /// A point in the plane of a ring's face, as shares of the two sides at the vertex.
    struct Continuation {
        std::uint32_t face = 0;
        float second = -kNever, third = -kNever;

        float least() const { return std::min(second, third); }
    };

    void measurePlanes();
    void measurePlanes(std::size_t firstNeighbour);
    void measurePoses();
    std::uint32_t leastBound() const;
    void addConstraints();
    void addPlane(std::uint32_t neighbour, float weight);
    float seamWeight(const OneRing::RingFace& a, const OneRing::RingFace& b, std::uint32_t neighbour) const;
    float attributeCost(std::uint32_t neighbour);
    float fanCost(const float* along) const;
    float wedgesCost(const float* along);
    float wedgeCost(std::uint32_t wedge, const Continuation& behind) const;
    Continuation continuation(std::uint32_t face, const float* along) const;

    const CollapseMesh* mMesh = nullptr;
    const OneRing* mRing = nullptr;
    float mArea = 0.0f;
    float mWedgeArea[OneRing::kMaxFaces]; ///< of the faces of each wedge
    double mImportanceFactor = 1.0;
    std::uint32_t mPlaneCount = 0;
    Plane mPlanes[OneRing::kMaxFaces + OneRing::kMaxNeighbours]; ///< those of the faces, then the constraints
    std::uint32_t mHeldCount = 0;
    PosedPlanes::HeldEdge mHeld[OneRing::kMaxNeighbours]; ///< edges with a constraint
    PosedPlanes mPosedPlanes;
    float mX[OneRing::kMaxNeighbours] = {}, mY[OneRing::kMaxNeighbours] = {},
          mZ[OneRing::kMaxNeighbours] = {};   ///< edges to the neighbours
    float mSquared[OneRing::kMaxNeighbours];  ///< lengths of the edges
    float mInverse[OneRing::kMaxNeighbours];  ///< ... and one over them
    bool mExact[OneRing::kMaxNeighbours];     ///< whether mBound has the attributes in it
    float mBound[OneRing::kMaxNeighbours];    ///< of each neighbour's cost, from below; kNever when rejected
    Continuation mBehind[OneRing::kMaxFaces]; ///< of each wedge
    WedgeMap mWedges;
};

} // namespace lodsmith
