#include "Simplifier.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lodsmith {

namespace {

constexpr std::uint32_t kCacheSize = 8192; // vertices of a mesh that fits the second-level cache whole

} // namespace

void CollapseOutcome::add(const CollapseOutcome& other)
{
    largestDeviation = std::max(largestDeviation, other.largestDeviation);
    largestLength = std::max(largestLength, other.largestLength);
    heldByLimit |= other.heldByLimit;
    heldBySize |= other.heldBySize;
    heldByScope |= other.heldByScope;
}

Simplifier::Simplifier(CollapseMesh& mesh, std::unique_ptr<CollapseCost> cost, QueueStates& states,
                       const CollapseScope& scope)
    : mMesh(mesh), mCost(std::move(cost)), mCheck(mesh), mPieces(mesh), mStates(states), mScope(scope)
{
}

void Simplifier::prepare(const VertexLocks& locks)
{
    for (std::uint32_t v = 0; v < mMesh.vertexCount(); ++v)
        if (mMesh.isAlive(v))
            prepare(v, locks);
}

void Simplifier::prepare(std::uint32_t v, const VertexLocks& locks)
{
    const bool precious = !mMesh.importance.empty() && mMesh.importance[v] >= 1.0f;
    if (precious || (locks.seams && mMesh.vertices[v].hasSeam)
        || (locks.borders && mRing.build(mMesh, v) && mRing.isBorder())) {
        mStates.flags[v] = Flag::kLocked;
        return;
    }
    // Most vertices lose a neighbour before their turn comes: it would be too early to evaluate them.
    mStates.flags[v] = Flag::kStale | Flag::kQueued;
    mStates.entries[v].cost = mCost->guess(mMesh, v);
}

void Simplifier::fillQueue()
{
    const std::uint32_t count = std::min(mScope.vertices, mMesh.vertexCount());
    for (std::uint32_t v = 0; v < count; ++v) {
        if (!mMesh.isAlive(v))
            continue;
        if (mStates.flags[v] & Flag::kQueued)
            insert(v, mStates.entries[v].cost);
        else if (mStates.flags[v] & Flag::kStalled)
            mStalled.push_back(v);
    }
    if (mOutcome.heldByScope)
        requeueStalled(0.0f);
    mOutcome.heldByScope = false;
}

void Simplifier::clearQueue()
{
    mQueue = {};
    std::vector<std::uint32_t>().swap(mStalled);
}

/// Sets aside a vertex that can neither be collapsed nor vanish, until one of the limits is as large as this.
void Simplifier::stall(std::uint32_t vertex, double needed)
{
    mStates.flags[vertex] = Flag::kStalled;
    mStates.entries[vertex].cost = static_cast<float>(needed);
    mStalled.push_back(vertex);
}

void Simplifier::enqueue(std::uint32_t vertex, std::uint32_t target, float cost)
{
    mStates.entries[vertex].target = target;
    mStates.flags[vertex] = 0;
    insert(vertex, cost);
}

/// Gives a vertex its place in the queue. An entry that it has already counts no more.
void Simplifier::insert(std::uint32_t vertex, float cost)
{
    mStates.flags[vertex] |= Flag::kQueued;
    mStates.entries[vertex].cost = cost;
    if (vertex < mScope.vertices && cost <= mScope.cost)
        mQueue.insert(cost, vertex);
}

bool Simplifier::reached(const CollapseLimits& limits) const
{
    return mMesh.liveVertices <= limits.vertices || mMesh.liveFaces <= limits.triangles;
}

/// (A change among a vertex's neighbours queues it anyway.)
void Simplifier::changeLimits(const CollapseLimits& limits)
{
    const bool held = mOutcome.heldByLimit || mOutcome.heldBySize;
    mOutcome.heldByLimit = mOutcome.heldBySize = mMayOvershoot = false;
    if (held)
        requeueStalled(static_cast<float>(std::max(limits.deviation, limits.length)));
}

void Simplifier::requeueStalled(float limit)
{
    std::vector<std::uint32_t> stalled;
    stalled.swap(mStalled);
    for (std::uint32_t v : stalled) {
        if (!(mStates.flags[v] & Flag::kStalled) || !mMesh.isAlive(v))
            continue;
        if (const float needed = mStates.entries[v].cost; needed > limit) {
            mOutcome.heldByLimit |= std::isfinite(needed);
            mStalled.push_back(v);
            continue;
        }
        mStates.flags[v] = Flag::kStale;
        insert(v, 0.0f);
    }
}

/// What is left are pieces larger than what is to be taken away: it may be one of them, then.
bool Simplifier::mayOvershoot()
{
    if (!mOutcome.heldBySize)
        return false;
    requeueStalled(0.0f);
    mOutcome.heldBySize = false;
    mMayOvershoot = true;
    return true;
}

/// The queue jumps about in the mesh: each step asks for what the next ones will read, one link of the chain at a time.
void Simplifier::prefetchAhead() const
{
    if (mMesh.vertexCount() < kCacheSize)
        return;
    std::uint32_t v;
    if (mQueue.expected(11, v)) {
        mMesh.prefetchVertex(v);
        prefetch(&mStates.entries[v]);
    }
    if (mQueue.expected(8, v))
        mMesh.prefetchFaceList(v);
    if (mQueue.expected(5, v))
        mMesh.prefetchFaces(v);
    if (mQueue.expected(2, v))
        mMesh.prefetchNeighbours(v);
}

/// Takes the front of the queue and collapses it, or puts it back where it belongs.
void Simplifier::advance(const CollapseLimits& limits)
{
    const CostMultiset::Entry front = mQueue.pop();
    prefetchAhead();
    const std::uint32_t v = front.vertex;
    if (!(mStates.flags[v] & Flag::kQueued) || mStates.entries[v].cost != front.cost || !mMesh.isAlive(v))
        return;
    mStates.flags[v] &= static_cast<std::uint8_t>(~Flag::kQueued);
    mFrontCost = front.cost;
    mNeeded = std::numeric_limits<double>::infinity();
    if (!mRing.build(mMesh, v)) {
        stall(v, mNeeded);
        return;
    }
    const bool stale = mStates.flags[v] & Flag::kStale;
    if ((!stale && mStates.entries[v].target == v) || isLoneTriangle()) {
        removePiece(limits);
        return;
    }
    Candidate candidate = stale ? evaluated(limits)
                                : Candidate{static_cast<int>(mRing.find(mMesh, mStates.entries[v].target)), front.cost};
    if (stale && candidate.neighbour >= 0 && !isFront(candidate.cost)) {
        enqueue(candidate);
        return;
    }
    if (candidate.neighbour >= 0 && allowed(limits, candidate)) {
        collapse(candidate);
        return;
    }
    if (!stale)
        candidate = evaluated(limits);
    while (candidate.neighbour >= 0 && !allowed(limits, candidate)) {
        mCost->reject(candidate.neighbour);
        candidate = cheapestWithin(limits);
    }
    if (candidate.neighbour < 0) {
        removePiece(limits);
    } else if (isFront(candidate.cost)) {
        collapse(candidate);
    } else {
        enqueue(candidate);
        mStates.flags[v] |= Flag::kHeldBack;
    }
}

/// A shortcut: of the commonest pieces that no collapse can make smaller, this need not be found out.
bool Simplifier::isLoneTriangle() const
{
    return mRing.faceCount == 1 && mMesh.vertices[mRing.neighbours[0].vertex].liveFaces == 1
           && mMesh.vertices[mRing.neighbours[1].vertex].liveFaces == 1;
}

/// Whether the piece has its place in the queue already, as an entry of another vertex.
bool Simplifier::neighbourStandsForPiece() const
{
    return std::any_of(mRing.neighbours, mRing.neighbours + mRing.neighbourCount, [this](const auto& neighbour) {
        return mStates.flags[neighbour.vertex] == Flag::kQueued
               && mStates.entries[neighbour.vertex].target == neighbour.vertex;
    });
}

bool Simplifier::isPieceLocked() const
{
    return std::any_of(mPieces.vertices().begin(), mPieces.vertices().end(),
                       [this](std::uint32_t vertex) { return mStates.flags[vertex] & Flag::kLocked; });
}

/// Whether a piece is the only one in a part of the mesh, or lies in another as well.
bool Simplifier::exceedsScope() const
{
    const auto isOutside = [this](std::uint32_t vertex) { return vertex >= mScope.vertices; };
    return !mScope.isWhole()
           && (mPieces.faces().size() == mMesh.liveFaces
               || std::any_of(mPieces.vertices().begin(), mPieces.vertices().end(), isOutside));
}

double Simplifier::importanceOfPiece() const
{
    float largest = 0.0f;
    if (!mMesh.importance.empty())
        for (std::uint32_t vertex : mPieces.vertices())
            largest = std::max(largest, mMesh.importance[vertex]);
    return largest;
}

/// How many collapses take as much away as the piece that was found: vertices, or pairs of triangles.
double Simplifier::collapsesSaved(const CollapseLimits& limits) const
{
    return limits.triangles != 0 ? 0.5 * static_cast<double>(mPieces.faces().size())
                                 : static_cast<double>(mPieces.vertices().size());
}

bool Simplifier::overshoots(const CollapseLimits& limits) const
{
    return mMesh.liveVertices < limits.vertices + mPieces.vertices().size()
           || mMesh.liveFaces < limits.triangles + mPieces.faces().size();
}

/// What no collapse can make smaller may vanish as a whole. Such an entry of the queue has its own vertex for a target.
void Simplifier::removePiece(const CollapseLimits& limits)
{
    const std::uint32_t v = mRing.vertex;
    const bool isPiece = !neighbourStandsForPiece() && mPieces.find(mRing);
    if (!isPiece || isPieceLocked() || exceedsScope()) {
        const bool waits = exceedsScope();
        mOutcome.heldByScope |= waits;
        stall(v, waits ? 0.0 : mNeeded);
        return;
    }
    const double length = mPieces.distance() / (1.0 - importanceOfPiece());
    // It is compared with single collapses, so each that it saves bears its share.
    const float cost = mCost->costOf(length, mPieces.area() / collapsesSaved(limits));
    if (mPieces.deviation() > limits.deviation || length > limits.length) {
        // In a part the nearest face may be farther away than it is in the whole.
        (mScope.isWhole() ? mOutcome.heldByLimit : mOutcome.heldByScope) = true;
        stall(v, mScope.isWhole() ? std::min(mNeeded, std::max(mPieces.deviation(), length)) : 0.0);
    } else if (!isFront(cost)) {
        enqueue(v, v, cost);
    } else if (overshoots(limits) && !mMayOvershoot) {
        (mScope.isWhole() ? mOutcome.heldBySize : mOutcome.heldByScope) = true;
        stall(v, 0.0);
    } else {
        mPieces.remove();
        mOutcome.largestDeviation = std::max(mOutcome.largestDeviation, mPieces.deviation());
        mOutcome.largestLength = std::max(mOutcome.largestLength, length);
    }
}

Candidate Simplifier::evaluated(const CollapseLimits& limits)
{
    mCost->begin(mMesh, mRing);
    if (mRing.isBorder()) // spares the costs of collapses that are sure to be refused
        for (std::uint32_t i = 0; i < mRing.neighbourCount; ++i)
            if (mRing.neighbours[i].faces != 1)
                mCost->reject(static_cast<int>(i));
    return cheapestWithin(limits);
}

/// No candidate when the cheapest one is too dear: so are the others, then.
Candidate Simplifier::cheapestWithin(const CollapseLimits& limits)
{
    const Candidate cheapest = mCost->cheapest();
    return cheapest.neighbour < 0 || withinLength(limits, cheapest) ? cheapest : Candidate{};
}

/// From the cheapest question to the dearest.
bool Simplifier::allowed(const CollapseLimits& limits, const Candidate& candidate)
{
    const auto neighbour = static_cast<std::uint32_t>(candidate.neighbour);
    return withinLength(limits, candidate) && mCheck.allows(mRing, neighbour) && withinDeviation(limits, neighbour)
           && mCheck.allowsInPoses(mRing, neighbour);
}

bool Simplifier::withinLength(const CollapseLimits& limits, const Candidate& candidate)
{
    mLength = mCost->lengthOf(candidate.cost, mMesh, mRing);
    return mLength <= limits.length || refuse(mLength);
}

bool Simplifier::withinDeviation(const CollapseLimits& limits, std::uint32_t neighbour)
{
    mPatchDeviation.evaluate(mRing, mMesh, neighbour);
    return mPatchDeviation.largest() <= limits.deviation || refuse(std::max(mPatchDeviation.largest(), mLength));
}

/// @param needed a limit below which it would be refused again
bool Simplifier::refuse(double needed)
{
    mOutcome.heldByLimit = true;
    mNeeded = std::min(mNeeded, needed);
    return false;
}

void Simplifier::collapse(const Candidate& candidate)
{
    const auto neighbour = static_cast<std::uint32_t>(candidate.neighbour);
    mWedges.build(mMesh, mRing, neighbour);
    moveFaces(neighbour);
    touchRing();
    mOutcome.largestDeviation = std::max(mOutcome.largestDeviation, mPatchDeviation.largest());
    mOutcome.largestLength = std::max(mOutcome.largestLength, mLength);
}

void Simplifier::moveFaces(std::uint32_t neighbour)
{
    for (std::uint32_t i = 0; i < mRing.faceCount - mRing.survivorCount; ++i)
        mMesh.removeFace(mRing.faces[mRing.onEdge[i]].face);
    std::uint32_t moved[OneRing::kMaxFaces];
    for (std::uint32_t i = 0; i < mRing.survivorCount; ++i) {
        const OneRing::RingFace& ringFace = mRing.faces[mRing.survivors[i]];
        CollapseMesh::Face& face = mMesh.faces[ringFace.face];
        face.wedge[ringFace.corner] = mWedges.to(ringFace.own);
        face.deviation = 0.0f;
        mMesh.raiseFaceDeviation(ringFace.face, mPatchDeviation.of(mRing.survivors[i]));
        CollapseMesh::setPlane(face, mRing.areaAfter[mRing.survivors[i]]);
        moved[i] = ringFace.face;
    }
    const std::uint32_t destination = mRing.neighbours[neighbour].vertex;
    mMesh.moveFaces(mRing.vertex, destination, moved, mRing.survivorCount);
    if (mPatchDeviation.lost() > 0.0)
        mMesh.raiseDeviation(destination, mPatchDeviation.lost());
}

/// Lets all neighbours be evaluated again: at their turn, or now if a cheaper collapse of theirs may no longer be forbidden.
void Simplifier::touchRing()
{
    for (std::uint32_t i = 0; i < mRing.neighbourCount; ++i) {
        const std::uint32_t v = mRing.neighbours[i].vertex;
        if (mStates.flags[v] & Flag::kLocked)
            continue;
        const bool waits = (mStates.flags[v] & (Flag::kQueued | Flag::kHeldBack)) == Flag::kQueued;
        mStates.flags[v] = static_cast<std::uint8_t>((mStates.flags[v] & Flag::kQueued) | Flag::kStale);
        if (!waits)
            insert(v, mFrontCost);
    }
}

/// The commonest reason among the vertices that are left; the first in the enumeration wins a tie.
StopReason Simplifier::whyStuck()
{
    std::uint32_t count[4] = {0, 0, 0, 0};
    for (std::uint32_t v = 0; v < mMesh.vertexCount(); ++v)
        if (mMesh.isAlive(v))
            ++count[static_cast<int>(whyStuck(v))];
    return static_cast<StopReason>(std::max_element(count, count + 4) - count);
}

StopReason Simplifier::whyStuck(std::uint32_t vertex)
{
    if (mStates.flags[vertex] & Flag::kLocked)
        return StopReason::Locked;
    if (mRing.build(mMesh, vertex))
        for (std::uint32_t i = 0; i < mRing.neighbourCount; ++i)
            if (!mWedges.build(mMesh, mRing, i) && mCheck.allows(mRing, i) && mCheck.allowsInPoses(mRing, i))
                return StopReason::Seam;
    return StopReason::Topology;
}

} // namespace lodsmith
