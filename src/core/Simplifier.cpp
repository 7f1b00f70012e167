#include "Simplifier.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lodsmith {

namespace {

constexpr std::uint32_t kCacheSize = 8192; // vertices of a mesh that fits the second-level cache whole

} // namespace

Simplifier::Simplifier(CollapseMesh& mesh, std::unique_ptr<CollapseCost> cost, const VertexLocks& locks)
    : mMesh(mesh), mCost(std::move(cost)), mCheck(mesh), mPieces(mesh), mState(mesh.vertexCount(), 0),
      mEntries(mesh.vertexCount())
{
    for (std::uint32_t v = 0; v < mesh.vertexCount(); ++v)
        if (mesh.isAlive(v))
            prepare(v, locks);
}

void Simplifier::prepare(std::uint32_t v, const VertexLocks& locks)
{
    const bool precious = !mMesh.importance.empty() && mMesh.importance[v] >= 1.0f;
    if (precious || (locks.seams && mMesh.vertices[v].hasSeam)
        || (locks.borders && mRing.build(mMesh, v) && mRing.isBorder())) {
        mState[v] = kLocked;
        return;
    }
    // Most vertices lose a neighbour before their turn comes: it would be too early to evaluate them.
    mState[v] = kStale;
    insert(v, mCost->guess(mMesh, v));
}

/// Sets aside a vertex that can neither be collapsed nor vanish.
void Simplifier::stall(std::uint32_t vertex)
{
    mState[vertex] = kStalled;
    mStalled.push_back(vertex);
}

void Simplifier::enqueue(std::uint32_t vertex, std::uint32_t target, float cost)
{
    mEntries[vertex].target = target;
    mState[vertex] = 0;
    insert(vertex, cost);
}

/// Gives a vertex its place in the queue. An entry that it has already counts no more.
void Simplifier::insert(std::uint32_t vertex, float cost)
{
    mState[vertex] |= kQueued;
    mEntries[vertex].cost = cost;
    mQueue.insert(cost, vertex);
}

bool Simplifier::reached(const CollapseLimits& limits) const
{
    return mMesh.liveVertices <= limits.vertices || mMesh.liveFaces <= limits.triangles;
}

/// Vertices whose collapses were beyond the last limits get another chance under new ones. (A change among a vertex's
/// neighbours queues it anyway.)
void Simplifier::requeueStalled()
{
    std::vector<std::uint32_t> stalled;
    stalled.swap(mStalled);
    for (std::uint32_t v : stalled) {
        if (!(mState[v] & kStalled) || !mMesh.isAlive(v))
            continue;
        mState[v] = kStale;
        insert(v, 0.0f);
    }
}

/// What is left are pieces larger than what is to be taken away: it may be one of them, then.
bool Simplifier::mayOvershoot()
{
    if (!mHeldBySize)
        return false;
    requeueStalled();
    mHeldBySize = false;
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
        prefetch(&mEntries[v]);
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
    if (!(mState[v] & kQueued) || mEntries[v].cost != front.cost || !mMesh.isAlive(v))
        return;
    mState[v] &= static_cast<std::uint8_t>(~kQueued);
    mFrontCost = front.cost;
    if (!mRing.build(mMesh, v)) {
        stall(v);
        return;
    }
    const bool stale = mState[v] & kStale;
    if ((!stale && mEntries[v].target == v) || isLoneTriangle()) {
        removePiece(limits);
        return;
    }
    Candidate candidate =
        stale ? evaluated() : Candidate{static_cast<int>(mRing.find(mMesh, mEntries[v].target)), front.cost};
    if (stale && candidate.neighbour >= 0 && !isFront(candidate.cost)) {
        enqueue(candidate);
        return;
    }
    if (candidate.neighbour >= 0 && allowed(limits, candidate)) {
        collapse(candidate);
        return;
    }
    if (!stale)
        candidate = evaluated();
    while (candidate.neighbour >= 0 && !allowed(limits, candidate)) {
        mCost->reject(candidate.neighbour);
        candidate = mCost->cheapest();
    }
    if (candidate.neighbour < 0) {
        removePiece(limits);
    } else if (isFront(candidate.cost)) {
        collapse(candidate);
    } else {
        enqueue(candidate);
        mState[v] |= kHeldBack;
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
        return mState[neighbour.vertex] == kQueued && mEntries[neighbour.vertex].target == neighbour.vertex;
    });
}

bool Simplifier::isPieceLocked() const
{
    return std::any_of(mPieces.vertices().begin(), mPieces.vertices().end(),
                       [this](std::uint32_t vertex) { return mState[vertex] & kLocked; });
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
    if (neighbourStandsForPiece() || !mPieces.find(mRing) || isPieceLocked()) {
        stall(v);
        return;
    }
    const double length = mPieces.distance() / (1.0 - importanceOfPiece());
    // It is compared with single collapses, so each that it saves bears its share.
    const float cost = mCost->costOf(length, mPieces.area() / collapsesSaved(limits));
    if (mPieces.deviation() > limits.deviation || length > limits.length) {
        mHeldByLimit = true;
        stall(v);
    } else if (!isFront(cost)) {
        enqueue(v, v, cost);
    } else if (overshoots(limits) && !mMayOvershoot) {
        mHeldBySize = true;
        stall(v);
    } else {
        mPieces.remove();
        mLargestDeviation = std::max(mLargestDeviation, mPieces.deviation());
        mLargestLength = std::max(mLargestLength, length);
    }
}

Candidate Simplifier::evaluated()
{
    mCost->begin(mMesh, mRing);
    if (mRing.isBorder()) // spares the costs of collapses that are sure to be refused
        for (std::uint32_t i = 0; i < mRing.neighbourCount; ++i)
            if (mRing.neighbours[i].faces != 1)
                mCost->reject(static_cast<int>(i));
    return mCost->cheapest();
}

bool Simplifier::allowed(const CollapseLimits& limits, const Candidate& candidate)
{
    return mCheck.allows(mRing, static_cast<std::uint32_t>(candidate.neighbour)) && withinLimits(limits, candidate);
}

bool Simplifier::withinLimits(const CollapseLimits& limits, const Candidate& candidate)
{
    mPatchDeviation.evaluate(mRing, mMesh, static_cast<std::uint32_t>(candidate.neighbour));
    mLength = mCost->lengthOf(candidate.cost, mMesh, mRing);
    const bool within = mPatchDeviation.largest() <= limits.deviation && mLength <= limits.length;
    mHeldByLimit |= !within;
    return within;
}

void Simplifier::collapse(const Candidate& candidate)
{
    const auto neighbour = static_cast<std::uint32_t>(candidate.neighbour);
    mWedges.build(mMesh, mRing, neighbour);
    moveFaces(neighbour);
    touchRing();
    mLargestDeviation = std::max(mLargestDeviation, mPatchDeviation.largest());
    mLargestLength = std::max(mLargestLength, mLength);
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
        if (mState[v] & kLocked)
            continue;
        const bool waits = (mState[v] & (kQueued | kHeldBack)) == kQueued;
        mState[v] = static_cast<std::uint8_t>((mState[v] & kQueued) | kStale);
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
    if (mState[vertex] & kLocked)
        return StopReason::Locked;
    if (mRing.build(mMesh, vertex))
        for (std::uint32_t i = 0; i < mRing.neighbourCount; ++i)
            if (!mWedges.build(mMesh, mRing, i) && mCheck.allows(mRing, i))
                return StopReason::Seam;
    return StopReason::Topology;
}

} // namespace lodsmith
