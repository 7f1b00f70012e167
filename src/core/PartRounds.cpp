#include "PartRounds.h"

#include "MeshPart.h"
#include "Parallel.h"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <iterator>
#include <limits>
#include <thread>

namespace lodsmith {

namespace {

#ifdef LODSMITH_TINY_PARTS // with which tests see small meshes cut up as well
constexpr std::uint32_t kLargeMesh = 30, kPartVertices = 64;
#else
constexpr std::uint32_t kLargeMesh = 50000;   // vertices; with fewer, rounds cost what they bring
constexpr std::uint32_t kPartVertices = 8192; // of a part, so that it fits the second-level cache
#endif
constexpr double kCuts[] = {0.5, 0.38}; // shares of the vertices before a cut, in turn, so that rims differ
constexpr double kOvercommit =
    1.4; // entries looked at for each collapse wanted; more cost accuracy at a level's start,
constexpr double kLaterOvercommit = 2.0; // ... where later rounds do little, they have to get it done
constexpr double kMostOfRound = 0.75;    // of the vertices
constexpr double kCertain = 0.98; // of the collapses wanted: the last one of a part may take more away than is left
constexpr double kLeastOfRound = 0.05; // of the vertices: for less a round is too dear
constexpr double kLeastGain = 0.1;     // of what was wanted: otherwise the next round would not come far either
constexpr int kCostShift = 16;         // exponent and seven bits of the mantissa

/// Collapses that a level still needs, at least.
double collapsesTo(const CollapseLimits& limits, const CollapseMesh& mesh)
{
    if (limits.triangles != 0)
        return 0.5 * (double(mesh.liveFaces) - limits.triangles);
    return double(mesh.liveVertices) - limits.vertices;
}

bool isWorthARound(const CollapseLimits& limits, const CollapseMesh& mesh)
{
    return mesh.liveVertices > kLargeMesh && collapsesTo(limits, mesh) > kLeastOfRound * mesh.liveVertices;
}

std::uint32_t bitsOf(float cost)
{
    std::uint32_t bits;
    std::memcpy(&bits, &cost, sizeof bits);
    return bits;
}

float costOf(std::uint32_t bits)
{
    float cost;
    std::memcpy(&cost, &bits, sizeof cost);
    return cost;
}

} // namespace

bool PartRounds::isFor(const CollapseMesh& mesh)
{
    return mesh.vertexCount() > kLargeMesh && mesh.poses.count() == 0;
}

Partition PartRounds::cut()
{
    return {mMesh, kPartVertices, kCuts[mCuts++ % std::size(kCuts)], mThreads};
}

void PartRounds::prepare(const VertexLocks& locks)
{
    mMesh.countFaces();
    const Partition partition = cut();
    inParallel(mThreads, partition.count(), [&](std::size_t i) {
        MeshPart part(mMesh, mStates, partition, i);
        Simplifier(part.mesh(), mMakeCost(), part.states()).prepare(locks);
        part.writeTo(mMesh, mStates);
    });
}

void PartRounds::run(const CollapseLimits& limits, Simplifier& simplifier)
{
    for (bool isFirst = true; isWorthARound(limits, mMesh); isFirst = false) {
        if (mIsQueued) {
            simplifier.clearQueue();
            mMesh.dropFaceLists();
            mIsQueued = false;
        }
        if (!runRound(limits, isFirst, simplifier.outcome()) || mWatch.isCancelled())
            break;
    }
    if (mIsQueued || mWatch.isCancelled())
        return;
    mMesh.buildFaceLists();
    simplifier.fillQueue();
    mIsQueued = true;
}

/// False when it did not come far, so that another one would not either.
bool PartRounds::runRound(const CollapseLimits& limits, bool isFirst, CollapseOutcome& outcome)
{
    const double wanted = collapsesTo(limits, mMesh);
    const Round round = plan(limits, wanted, isFirst ? kOvercommit : kLaterOvercommit);
    const Partition partition = cut();
    std::vector<PartOutcome> outcomes(partition.count());
    std::atomic<std::uint32_t> gone{0};
    const auto caller = std::this_thread::get_id();
    const auto step = [&](std::uint32_t newlyGone) {
        gone += newlyGone;
        return std::this_thread::get_id() == caller ? mWatch.report(mMesh.liveVertices - gone) : !mWatch.isCancelled();
    };
    inParallel(mThreads, partition.count(), [&](std::size_t i) { outcomes[i] = runPart(partition, i, round, step); });
    const std::uint32_t before = mMesh.liveVertices;
    for (const PartOutcome& part : outcomes) {
        outcome.add(part.outcome);
        mMesh.liveVertices -= part.vertices;
        mMesh.liveFaces -= part.faces;
        for (const auto& [face, bound] : part.raised)
            mMesh.raiseFaceDeviation(face, bound);
    }
    return before - mMesh.liveVertices > kLeastGain * wanted;
}

/// If no cost changed on the way, the cheapest entries, as many as are wanted, would go: how many of them a part has is what it may
/// take away. Since many come to cost more, it may look at dearer ones for that.
PartRounds::Round PartRounds::plan(const CollapseLimits& limits, double wanted, double overcommit) const
{
    std::vector<std::uint32_t> counts(bitsOf(std::numeric_limits<float>::infinity()) >> kCostShift, 0);
    for (std::uint32_t v = 0; v < mMesh.vertexCount(); ++v)
        if (mMesh.isAlive(v) && mStates.flags[v] & QueueStates::kQueued)
            ++counts[bitsOf(mStates.entries[v].cost) >> kCostShift];
    std::uint32_t last = 0;
    double sum = counts[0];
    const auto costOfFirst = [&](double enough) {
        while (sum < enough && last + 1 < counts.size())
            sum += counts[++last];
        return costOf((last << kCostShift) | ((1u << kCostShift) - 1));
    };
    Round round{limits, costOfFirst(wanted), std::min(1.0, kCertain * wanted / sum), 0.0f};
    round.dearest = costOfFirst(std::min(overcommit * wanted, kMostOfRound * mMesh.liveVertices));
    return round;
}

/// Of the round's limits, the part's share.
CollapseLimits PartRounds::limitsOf(MeshPart& part, const Round& round)
{
    std::uint32_t cheap = 0;
    for (std::uint32_t v = 0; v < part.ownCount(); ++v)
        cheap += (part.states().flags[v] & QueueStates::kQueued) != 0 && part.states().entries[v].cost <= round.cheap;
    const auto allowed = static_cast<std::uint32_t>(round.share * cheap);
    CollapseLimits limits = round.limits;
    limits.vertices = part.mesh().liveVertices - allowed;
    if (limits.triangles != 0) {
        limits.vertices = 0;
        limits.triangles = part.mesh().liveFaces - std::min(2 * allowed, part.mesh().liveFaces - 1);
    }
    return limits;
}

PartRounds::PartOutcome PartRounds::runPart(const Partition& partition, std::size_t number, const Round& round,
                                            const std::function<bool(std::uint32_t)>& step)
{
    if (mWatch.isCancelled())
        return {};
    MeshPart part(mMesh, mStates, partition, number);
    Simplifier simplifier(part.mesh(), mMakeCost(), part.states(), {part.innerCount(), round.dearest});
    const std::uint32_t vertices = part.mesh().liveVertices, faces = part.mesh().liveFaces;
    std::uint32_t told = vertices;
    simplifier.fillQueue();
    simplifier.collapseAll(limitsOf(part, round), [&] {
        const std::uint32_t newlyGone = told - part.mesh().liveVertices;
        told -= newlyGone;
        return step(newlyGone);
    });
    part.writeTo(mMesh, mStates);
    return {simplifier.outcome(), part.raisedBeyond(mMesh), vertices - part.mesh().liveVertices,
            faces - part.mesh().liveFaces};
}

} // namespace lodsmith
