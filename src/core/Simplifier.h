#pragma once

#include "CollapseCheck.h"
#include "CollapseCost.h"
#include "CollapseMesh.h"
#include "CostMultiset.h"
#include "OneRing.h"
#include "PatchDeviation.h"
#include "PieceRemoval.h"
#include "QueueStates.h"
#include "WedgeMap.h"

#include <lodsmith/core/LodChain.h>

#include <limits>
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

/// What became of a mesh, or of a part of it, so far.
struct CollapseOutcome {
    double largestDeviation = 0.0; ///< of all collapses, scaled
    double largestLength = 0.0;    ///< their costs as lengths, scaled
    bool heldByLimit = false;      ///< some collapse was refused by the limits, whatever else may be against it
    bool heldBySize = false;       ///< some piece was larger than what is left to take away
    bool heldByScope = false;      ///< some piece waits until the mesh is looked at as a whole

    void add(const CollapseOutcome& other);
};

/// What of a mesh a simplifier looks after. The rest is looked at and stays as it is.
struct CollapseScope {
    std::uint32_t vertices = kNone;                      ///< those with smaller numbers may be collapsed
    float cost = std::numeric_limits<float>::infinity(); ///< and only entries that cost no more than this are
    bool isWhole() const { return vertices == kNone; }
};

/// Collapses half-edges, cheapest first, until told to stop; then again, further.
///
/// Costs are evaluated lazily: a collapse only marks its neighbours, and a marked vertex is evaluated again when it comes to
/// the front of the queue. Whether a collapse is allowed is asked of the one in front alone.
class Simplifier {
public:
    Simplifier(CollapseMesh& mesh, std::unique_ptr<CollapseCost> cost, QueueStates& states,
               const CollapseScope& scope = {});

    /// Finds locked vertices and gives every other one a first entry. The queue itself stays empty.
    void prepare(const VertexLocks& locks);

    /// Fills the queue, which is empty, with the entries of all vertices that it looks after. Those whose pieces waited for
    /// that are looked at again.
    void fillQueue();

    /// Gives the queue's memory back.
    void clearQueue();

    /// Lets vertices whose collapses the last limits forbade be looked at again, where the new ones may allow them; to be
    /// called before a run with these.
    void changeLimits(const CollapseLimits& limits);

    /// Continues until the limits are met or nothing is left to collapse. `step` is called now and then; false stops.
    template <class Step>
    StopReason run(const CollapseLimits& limits, Step&& step)
    {
        collapseAll(limits, step);
        return reached(limits) || mOutcome.heldByLimit ? StopReason::TargetReached : whyStuck();
    }

    /// The same without finding out why it stopped.
    template <class Step>
    void collapseAll(const CollapseLimits& limits, Step&& step)
    {
        for (std::uint32_t steps = 0; !reached(limits); ++steps) {
            if (steps % 1024 == 0 && !step())
                break;
            if (mQueue.empty() && !mayOvershoot())
                break;
            advance(limits);
        }
    }

    const CollapseOutcome& outcome() const { return mOutcome; }
    CollapseOutcome& outcome() { return mOutcome; }

private:
    using Flag = QueueStates::Flag;

    void prepare(std::uint32_t vertex, const VertexLocks& locks);
    bool reached(const CollapseLimits& limits) const;
    void requeueStalled(float limit);
    bool mayOvershoot();
    bool overshoots(const CollapseLimits& limits) const;
    void advance(const CollapseLimits& limits);
    void prefetchAhead() const;
    void stall(std::uint32_t vertex, double needed);
    void enqueue(std::uint32_t vertex, std::uint32_t target, float cost);
    void insert(std::uint32_t vertex, float cost);
    void enqueue(const Candidate& candidate)
    {
        enqueue(mRing.vertex, mRing.neighbours[candidate.neighbour].vertex, candidate.cost);
    }
    bool isLoneTriangle() const;
    bool neighbourStandsForPiece() const;
    bool isPieceLocked() const;
    bool exceedsScope() const;
    double importanceOfPiece() const;
    double collapsesSaved(const CollapseLimits& limits) const;
    void removePiece(const CollapseLimits& limits);
    Candidate evaluated(const CollapseLimits& limits);
    Candidate cheapestWithin(const CollapseLimits& limits);
    bool allowed(const CollapseLimits& limits, const Candidate& candidate);
    bool withinLength(const CollapseLimits& limits, const Candidate& candidate);
    bool withinDeviation(const CollapseLimits& limits, std::uint32_t neighbour);
    bool refuse(double needed);
    /// Whether a collapse may go ahead although others look cheaper by less than half: looking at those first costs more
    /// evaluations than it gains.
    bool isFront(float cost) { return cost <= 1.5f * (mQueue.empty() ? mScope.cost : mQueue.top().cost); }
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
    QueueStates& mStates;
    CollapseScope mScope;
    std::vector<std::uint32_t> mStalled;
    CollapseOutcome mOutcome;
    float mFrontCost = 0.0f;    ///< of the entry looked at last
    double mLength = 0.0;       ///< the candidate's cost as a length
    double mNeeded = 0.0;       ///< the vertex in front stays while both limits are smaller; infinite when none helps
    bool mMayOvershoot = false; ///< a piece larger than what is left to take away goes all the same: nothing else can
};

} // namespace lodsmith
