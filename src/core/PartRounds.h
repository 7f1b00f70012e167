#pragma once

#include "CollapseCost.h"
#include "CollapseMesh.h"
#include "MeshPart.h"
#include "Partition.h"
#include "QueueStates.h"
#include "Simplifier.h"
#include "Watch.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace lodsmith {

using CostMaker = std::function<std::unique_ptr<CollapseCost>()>;

/// Takes a large mesh most of the way to a level in parts, which several threads collapse at once.
///
/// Each round cuts the mesh anew, so that what was a rim becomes the middle of a part. A round goes up to a cost that all parts
/// share: that of the dearest collapse still wanted if no cost changed on the way. What is left then, a small share, is done on the
/// mesh as a whole. Parts and costs follow from the mesh alone: results do not depend on the number of threads.
class PartRounds {
public:
    PartRounds(CollapseMesh& mesh, QueueStates& states, CostMaker makeCost, unsigned threads, const Watch& watch)
        : mMesh(mesh), mStates(states), mMakeCost(std::move(makeCost)), mThreads(threads), mWatch(watch)
    {
    }

    /// Whether a mesh is large enough for this, and has no poses, which parts do not carry.
    static bool isFor(const CollapseMesh& mesh);

    /// Simplifier::prepare(), in parts.
    void prepare(const VertexLocks& locks);

    /// Goes towards the limits. The simplifier is that of the whole, whose queue is filled anew.
    void run(const CollapseLimits& limits, Simplifier& simplifier);

private:
    /// What one part has done in one round.
    struct PartOutcome {
        CollapseOutcome outcome;
        std::vector<std::pair<std::uint32_t, float>> raised;
        std::uint32_t vertices = 0, faces = 0; ///< taken away
    };

    /// What all parts may do in one round.
    struct Round {
        CollapseLimits limits; ///< of the whole
        float cheap;           ///< there are about as many entries up to this cost as collapses wanted
        double share;          ///< of the cheap ones of a part: as many collapses it may make
        float dearest;         ///< entries that cost more wait
    };

    bool runRound(const CollapseLimits& limits, bool isFirst, CollapseOutcome& outcome);
    Round plan(const CollapseLimits& limits, double wanted, double overcommit) const;
    static CollapseLimits limitsOf(MeshPart& part, const Round& round);
    PartOutcome runPart(const Partition& partition, std::size_t number, const Round& round,
                        const std::function<bool(std::uint32_t)>& step);
    Partition cut();

    CollapseMesh& mMesh;
    QueueStates& mStates;
    CostMaker mMakeCost;
    unsigned mThreads;
    const Watch& mWatch;
    unsigned mCuts = 0;
    bool mIsQueued = false; ///< the simplifier's queue and the mesh's face lists are there
};

} // namespace lodsmith
