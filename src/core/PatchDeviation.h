#pragma once

#include "OneRing.h"
#include "WedgeMap.h"

#include <initializer_list>

namespace lodsmith {

/// Bounds on how far the faces that one collapse makes are from the original surface, two-sided, scaled units.
///
/// The faces around the vertex and those that replace them are laid over each other in a plane and compared where their
/// edges cross: between crossings both are linear (Cohen, Manocha and Olano 1997, successive mappings). What a new face
/// is off by is added to the bounds of those old ones that it covers. A border is first drawn straight, and a fold that
/// has no such plane is cut in two along an edge that the collapse creates. Where nothing of this fits, the length of the
/// collapsed edge is a bound.
///
/// In a pose, what lies over one another at rest is taken to belong together: there too both are linear between crossings,
/// so that the distance of two points that belong together is largest at one of the same crossings.
class PatchDeviation {
public:
    /// The ring is aimed at this neighbour.
    void evaluate(const OneRing& ring, const CollapseMesh& mesh, std::uint32_t neighbour);

    /// Bound of the ring's i-th face after the collapse; meaningless for one that goes.
    double of(std::uint32_t i) const { return mAfter[i]; }
    double largest() const { return mLargest; }

    /// Bound of what is left of faces that go without one that takes their place: an edge of the destination. 0 for none.
    double lost() const { return mLost; }

private:
    /// Part of the ring in winding order: face i lies between spokes i and i + 1. Spoke 0 is the destination.
    struct Fan {
        std::uint32_t spokes[OneRing::kMaxNeighbours]; ///< neighbour numbers
        std::uint32_t faces[OneRing::kMaxFaces];       ///< ring faces
        std::uint32_t count = 0;                       ///< spokes
        bool closed = false;
        bool reversed = false; ///< against the winding order after all
    };

    /// A point that is a sum of shares of spokes' ends, from the vertex.
    struct Share {
        std::uint32_t spoke; ///< neighbour number
        double weight;
    };

    double farthestMove(std::uint32_t neighbour);
    double farthestSplitMove(std::uint32_t neighbour);
    double inPoses(std::initializer_list<Share> point) const;
    bool evaluateFans(std::uint32_t neighbour);
    bool walkFan(Fan& fan, std::uint32_t neighbour) const;
    bool collectFan(const Vec3& side, double sign, Fan& fan, std::uint32_t& taken) const;
    bool startAt(Fan& fan, std::uint32_t neighbour) const;
    bool evaluateFan(const Fan& fan);
    bool evaluateClosed(const Fan& fan);
    bool evaluateCut(const Fan& fan, std::uint32_t cut);
    std::uint32_t nearestCut(const Fan& fan) const;
    bool project(const Fan& fan, const Vec3& centre);
    bool faceOn(const Fan& fan, const Vec3& centre);
    bool compareAtCentre(const Fan& fan);
    void compareAtCrossings(const Fan& fan);
    void settle(const Fan& fan, double shift);
    double crossingInPoses(const Fan& fan, std::uint32_t i, double s, std::uint32_t j, double t) const;
    void cover(std::uint32_t newFace, double difference, double before);

    const OneRing* mRing = nullptr;
    const CollapseMesh* mMesh = nullptr;
    double mBefore[OneRing::kMaxFaces]; ///< bound of each ring face before
    double mAfter[OneRing::kMaxFaces];
    double mLargest = 0.0;
    double mLost = 0.0;
    std::uint32_t mCut = 0; ///< the spoke towards which the vertex has been moved,
    double mTowards = 0.0;  ///< how far from the destination, as a share,
    bool mIsMoved = false;  ///< if it has
    WedgeMap mWedges;
    double mU[OneRing::kMaxNeighbours], mV[OneRing::kMaxNeighbours],
        mZ[OneRing::kMaxNeighbours];        ///< spokes' ends in the plane, and above it
    double mOld[OneRing::kMaxFaces];        ///< of the fan's faces: bound before
    double mCovered[OneRing::kMaxFaces];    ///< ... largest bound of what it covers afterwards
    double mDifference[OneRing::kMaxFaces]; ///< ... largest difference to that
};

} // namespace lodsmith
