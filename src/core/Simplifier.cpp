#include "Simplifier.h"

#include <algorithm>

namespace lodsmith {

Simplifier::Simplifier(CollapseMesh& mesh, std::unique_ptr<CollapseCost> cost)
    : mMesh(mesh), mCost(std::move(cost)), mOnBorder(mesh.vertexCount(), 0), mCheck(mesh, mOnBorder),
      mState(mesh.vertexCount(), 0)
{
    for (std::uint32_t v = 0; v < mesh.vertexCount(); ++v)
        mOnBorder[v] = mRing.build(mesh, v) && mRing.isBorder();
}

void Simplifier::evaluateAll()
{
    for (std::uint32_t v = 0; v < mMesh.vertexCount(); ++v) {
        if (!mMesh.isAlive(v) || (mState[v] & kLocked))
            continue;
        if (mRing.build(mMesh, v)) {
            mCost->begin(mMesh, mRing);
            enqueue(v, mCost->cheapest());
        } else {
            enqueue(v, {});
        }
    }
}

void Simplifier::enqueue(std::uint32_t vertex, const Candidate& candidate)
{
    mState[vertex] &= static_cast<std::uint8_t>(~(kStale | kStalled));
    if (candidate.neighbour < 0) {
        mState[vertex] |= kStalled;
        mStalled.push_back(vertex);
        return;
    }
    mMesh.vertices[vertex].target = mRing.neighbour[candidate.neighbour];
    mState[vertex] |= kQueued;
    mQueue.insert(candidate.cost, vertex);
}

bool Simplifier::reached(const CollapseLimits& limits) const
{
    return mMesh.liveVertices <= limits.vertices || mMesh.liveFaces <= limits.triangles;
}

/// Vertices that could not be collapsed get another chance once others have been.
bool Simplifier::requeueStalled()
{
    if (!mProgressed && !mHeldByLimit)
        return false;
    mProgressed = mHeldByLimit = false;
    std::vector<std::uint32_t> stalled;
    stalled.swap(mStalled);
    for (std::uint32_t v : stalled) {
        if (!(mState[v] & kStalled) || !mMesh.isAlive(v))
            continue;
        mState[v] = static_cast<std::uint8_t>((mState[v] & ~kStalled) | kStale | kQueued);
        mQueue.insert(mFrontCost, v);
    }
    return !mQueue.empty();
}

/// Takes the front of the queue and collapses it, or puts it back where it belongs.
void Simplifier::advance(const CollapseLimits& limits)
{
    const CostMultiset::Entry front = mQueue.pop();
    const std::uint32_t v = front.vertex;
    mState[v] &= static_cast<std::uint8_t>(~kQueued);
    if (!mMesh.isAlive(v))
        return;
    mFrontCost = front.cost;
    if (!mRing.build(mMesh, v)) {
        enqueue(v, {});
        return;
    }
    Candidate candidate;
    mCost->begin(mMesh, mRing);
    candidate = mCost->cheapest();
    if (candidate.neighbour >= 0 && candidate.cost > front.cost && !mQueue.empty() && candidate.cost > mQueue.top().cost) {
        enqueue(v, candidate);
        return;
    }
    candidate = nextAllowed(limits, candidate);
    const bool stillFirst = candidate.neighbour >= 0 && (mQueue.empty() || candidate.cost <= std::max(front.cost, mQueue.top().cost));
    if (stillFirst)
        collapse(candidate);
    else
        enqueue(v, candidate);
}

Candidate Simplifier::nextAllowed(const CollapseLimits& limits, Candidate candidate)
{
    while (candidate.neighbour >= 0 &&
           !(mCheck.allows(mRing, static_cast<std::uint32_t>(candidate.neighbour)) && withinLimits(limits, candidate))) {
        mCost->reject(candidate.neighbour);
        candidate = mCost->cheapest();
    }
    return candidate;
}

bool Simplifier::withinLimits(const CollapseLimits& limits, const Candidate& candidate)
{
    double before = 0.0;
    for (std::uint32_t i = 0; i < mRing.faceCount; ++i)
        before = std::max<double>(before, mMesh.faces[mRing.faces[i].face].deviation);
    mPatchBound = before + mPatchDeviation.bound(mRing, mMesh, static_cast<std::uint32_t>(candidate.neighbour));
    const bool within = mPatchBound <= limits.deviation && candidate.length <= limits.length;
    mHeldByLimit |= !within;
    return within;
}

void Simplifier::collapse(const Candidate& candidate)
{
    const auto neighbour = static_cast<std::uint32_t>(candidate.neighbour);
    const std::uint32_t destination = mRing.neighbour[neighbour];
    mWedges.build(mMesh, mRing, neighbour);
    moveFaces(neighbour);
    mOnBorder[destination] |= mOnBorder[mRing.vertex];
    touchRing();
    mLargestDeviation = std::max(mLargestDeviation, mPatchBound);
    mLargestLength = std::max(mLargestLength, candidate.length);
    mProgressed = true;
}

void Simplifier::moveFaces(std::uint32_t neighbour)
{
    std::uint32_t moved[OneRing::kMaxFaces];
    std::uint32_t count = 0;
    for (std::uint32_t i = 0; i < mRing.faceCount; ++i)
        if (!mRing.contains(mRing.faces[i], neighbour))
            moved[count++] = mRing.faces[i].face;
    mMesh.appendFaces(mRing.neighbour[neighbour], moved, count);
    for (std::uint32_t i = 0; i < mRing.faceCount; ++i) {
        const OneRing::RingFace& ringFace = mRing.faces[i];
        if (mRing.contains(ringFace, neighbour)) {
            mMesh.removeFace(ringFace.face);
            continue;
        }
        CollapseMesh::Face& face = mMesh.faces[ringFace.face];
        face.wedge[ringFace.corner] = mWedges(ringFace.wedge[0]);
        face.deviation = static_cast<float>(mPatchBound);
        mMesh.updatePlane(face);
    }
    CollapseMesh::Vertex& vertex = mMesh.vertices[mRing.vertex];
    if (vertex.liveFaces != 0)
        --mMesh.liveVertices;
    vertex.liveFaces = vertex.faceSlots = 0;
}

void Simplifier::touchRing()
{
    for (std::uint32_t i = 0; i < mRing.neighbourCount; ++i) {
        const std::uint32_t v = mRing.neighbour[i];
        if (mState[v] & kLocked)
            continue;
        mState[v] |= kStale;
        if (mState[v] & kQueued)
            continue;
        mState[v] = static_cast<std::uint8_t>((mState[v] & ~kStalled) | kQueued);
        mQueue.insert(mFrontCost, v);
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
