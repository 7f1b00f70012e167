#pragma once

#include "CollapseCheck.h"
#include "CollapseCost.h"
#include "CollapseMesh.h"
#include "CostMultiset.h"
#include "OneRing.h"
#include "PatchDeviation.h"
#include "PieceRemoval.h"
#include "WedgeMap.h"

#include <lodsmith/core/LodChain.h>

#include <memory>
#include <vector>

namespace lodsmith {

/// How far a run goes: it stops at the first count that is met, and makes no collapse beyond either limit. Scaled units.
struct CollapseLimits {
    std::uint32_t vertices = 0;
    std::uint32_t triangles = 0;
    double deviation = 0.0;
    double length = 0.0;
};

/// Which vertices are never removed, besides those of importance 1.
struct VertexLocks {
    bool borders = false;
    bool seams = false;
};

/// Collapses half-edges, cheapest first, until told to stop; then again, further.
///
/// Costs are evaluated lazily: a collapse only marks its neighbours, and a marked vertex is evaluated again when it comes to
/// the front of the queue. Whether a collapse is allowed is asked of the one in front alone.
class Simplifier {
public:
    /// Finds locked vertices and queues every other one.
    Simplifier(CollapseMesh& mesh, std::unique_ptr<CollapseCost> cost, const VertexLocks& locks);

    /// Continues until the limits are met or nothing is left to collapse. `step` is called now and then; false stops.
    template <class Step>
    StopReason run(const CollapseLimits& limits, Step&& step)
    {
        if (mHeldByLimit || mHeldBySize)
            requeueStalled();
        mHeldByLimit = mHeldBySize = mMayOvershoot = false;
        for (std::uint32_t steps = 0; !reached(limits); ++steps) {
            if (steps % 1024 == 0 && !step())
                break;
            if (mQueue.empty() && !mayOvershoot())
                break;
            advance(limits);
        }
        return reached(limits) || mHeldByLimit ? StopReason::TargetReached : whyStuck();
    }

    double largestDeviation() const { return mLargestDeviation; }
    double largestLength() const { return mLargestLength; }

private:
    enum State : std::uint8_t {
        kQueued = 1, ///< has an entry in the queue
        kStale = 2,  ///< its neighbourhood changed since it was evaluated
        kLocked = 4,
        kStalled = 8,   ///< had no allowed collapse when last looked at
        kHeldBack = 16, ///< a cheaper collapse than that of its entry was forbidden when last looked at
    };

    struct QueueEntry {
        float cost = 0.0f; ///< an entry with another cost counts no more
        std::uint32_t target =
            kNone; ///< of the cheapest collapse, as last evaluated; itself when its piece is to vanish
    };

    void prepare(std::uint32_t vertex, const VertexLocks& locks);
    bool reached(const CollapseLimits& limits) const;
    void requeueStalled();
    bool mayOvershoot();
    bool overshoots(const CollapseLimits& limits) const;
    void advance(const CollapseLimits& limits);
    void prefetchAhead() const;
    void stall(std::uint32_t vertex);
    void enqueue(std::uint32_t vertex, std::uint32_t target, float cost);
    void insert(std::uint32_t vertex, float cost);
    void enqueue(const Candidate& candidate)
    {
        enqueue(mRing.vertex, mRing.neighbours[candidate.neighbour].vertex, candidate.cost);
    }
    bool isLoneTriangle() const;
    bool neighbourStandsForPiece() const;
    bool isPieceLocked() const;
    double importanceOfPiece() const;
    double collapsesSaved(const CollapseLimits& limits) const;
    void removePiece(const CollapseLimits& limits);
    Candidate evaluated();
    bool allowed(const CollapseLimits& limits, const Candidate& candidate);
    bool withinLimits(const CollapseLimits& limits, const Candidate& candidate);
    /// Whether a collapse may go ahead although others look cheaper by less than half: looking at those first costs more
    /// evaluations than it gains.
    bool isFront(float cost) { return mQueue.empty() || cost <= 1.5f * mQueue.top().cost; }
    void collapse(const Candidate& candidate);
    void moveFaces(std::uint32_t neighbour);
    void touchRing();
    StopReason whyStuck();
    StopReason whyStuck(std::uint32_t vertex);

    CollapseMesh& mMesh;
    std::unique_ptr<CollapseCost> mCost;
    CollapseCheck mCheck;
    PieceRemoval mPieces;
    CostMultiset mQueue;
    PatchDeviation mPatchDeviation;
    OneRing mRing;
    WedgeMap mWedges;
    std::vector<std::uint8_t> mState;
    std::vector<QueueEntry> mEntries; ///< of each vertex
    std::vector<std::uint32_t> mStalled;
    float mFrontCost = 0.0f; ///< of the entry looked at last
    double mLength = 0.0;    ///< the candidate's cost as a length
    double mLargestDeviation = 0.0;
    double mLargestLength = 0.0;
    bool mHeldByLimit = false;  ///< some collapse was refused by this run's limits alone
    bool mHeldBySize = false;   ///< some piece was larger than what is left to take away
    bool mMayOvershoot = false; ///< ... and is taken all the same, as nothing else can be
};

} // namespace lodsmith
