#include "MeshPart.h"

#include <algorithm>

namespace lodsmith {

MeshPart::MeshPart(const CollapseMesh& whole, const QueueStates& states, const Partition& partition, std::size_t part)
    : mPlace(partition.place.data()), mVertices(partition.vertices.data() + partition.firstVertex[part]),
      mFaces(partition.faces.data() + partition.firstFace[part]), mFirst(partition.firstVertex[part]),
      mOwn(partition.firstVertex[part + 1] - mFirst),
      mFaceCount(partition.firstFace[part + 1] - partition.firstFace[part])
{
    mMesh.attributeStride = whole.attributeStride;
    mMesh.area = whole.area;
    mMesh.scale = whole.scale;
    mMesh.firstFaceOfSubMesh = whole.firstFaceOfSubMesh; // only whether there are several is asked of a part
    numberVertices(whole);
    addVertices(whole);
    addWedges(whole);
    addFaces(whole);
    addStates(states);
}

bool MeshPart::isOwn(const CollapseMesh& whole, const CollapseMesh::Face& face) const
{
    return isOwn(whole.vertexOf(face.wedge[0])) && isOwn(whole.vertexOf(face.wedge[1]))
           && isOwn(whole.vertexOf(face.wedge[2]));
}

/// Finds out which vertices are inner ones and which lie beyond the rim.
void MeshPart::numberVertices(const CollapseMesh& whole)
{
    std::vector<std::uint8_t> isRim(mOwn, 0);
    for (std::uint32_t i = 0; i < mFaceCount; ++i) {
        const CollapseMesh::Face& face = whole.faces[mFaces[i]];
        if (isOwn(whole, face))
            continue;
        for (const std::uint32_t wedge : face.wedge) {
            const std::uint32_t vertex = whole.vertexOf(wedge);
            if (isOwn(vertex))
                isRim[mPlace[vertex] - mFirst] = 1;
            else
                mBeyond.push_back(vertex);
        }
    }
    std::sort(mBeyond.begin(), mBeyond.end());
    mBeyond.erase(std::unique(mBeyond.begin(), mBeyond.end()), mBeyond.end());
    mInner = static_cast<std::uint32_t>(std::count(isRim.begin(), isRim.end(), 0));
    mNumbers.resize(mOwn);
    std::uint32_t next[2] = {0, mInner};
    for (std::uint32_t i = 0; i < mOwn; ++i)
        mNumbers[i] = next[isRim[i]]++;
}

std::uint32_t MeshPart::numberOf(std::uint32_t vertex) const
{
    if (isOwn(vertex))
        return mNumbers[mPlace[vertex] - mFirst];
    const auto at = std::lower_bound(mBeyond.begin(), mBeyond.end(), vertex) - mBeyond.begin();
    return mOwn + static_cast<std::uint32_t>(at);
}

void MeshPart::addVertices(const CollapseMesh& whole)
{
    const std::size_t count = mOwn + mBeyond.size();
    mMesh.vertices.resize(count);
    mMesh.meanNormals.resize(count);
    mMesh.importance.resize(whole.importance.empty() ? 0 : count);
    mWedges.resize(count);
    const auto add = [&](std::uint32_t vertex, std::uint32_t number) {
        // Not the counts: of a vertex beyond the rim, another thread may be writing them.
        std::copy_n(whole.vertices[vertex].position, 3, mMesh.vertices[number].position);
        mMesh.vertices[number].hasSeam = whole.vertices[vertex].hasSeam;
        mMesh.meanNormals[number] = whole.meanNormals[vertex];
        if (!whole.importance.empty())
            mMesh.importance[number] = whole.importance[vertex];
        mWedges[number] = vertex;
    };
    for (std::uint32_t i = 0; i < mOwn; ++i)
        add(mVertices[i], mNumbers[i]);
    for (std::uint32_t i = 0; i < mBeyond.size(); ++i)
        add(mBeyond[i], mOwn + i);
}

/// Beyond the rim nobody asks for wedges: one a vertex will do.
void MeshPart::addWedges(const CollapseMesh& whole)
{
    const std::uint32_t vertices = mMesh.vertexCount();
    mMesh.nextWedge.assign(vertices, kNone);
    for (std::uint32_t number = 0; number < mOwn; ++number) {
        if (!mMesh.vertices[number].hasSeam)
            continue;
        std::uint32_t last = number;
        for (std::uint32_t wedge = whole.nextWedge[mWedges[number]]; wedge != kNone; wedge = whole.nextWedge[wedge]) {
            last = mMesh.nextWedge[last] = static_cast<std::uint32_t>(mWedges.size());
            mMesh.nextWedge.push_back(kNone);
            mMesh.extraWedgeVertex.push_back(number);
            mWedges.push_back(wedge);
        }
    }
    const std::size_t stride = whole.attributeStride;
    mMesh.attributes.resize(mWedges.size() * stride);
    mMesh.wedgeSubMesh.resize(whole.wedgeSubMesh.empty() ? 0 : mWedges.size());
    mMesh.wedgeMotion.resize(whole.wedgeMotion.empty() ? 0 : mWedges.size());
    for (std::uint32_t number = 0; number < mWedges.size(); ++number) {
        const std::uint32_t wedge = mWedges[number];
        std::copy_n(whole.attributesOf(wedge), stride, mMesh.attributes.data() + number * stride);
        if (!whole.wedgeSubMesh.empty())
            mMesh.wedgeSubMesh[number] = whole.wedgeSubMesh[wedge];
        if (!whole.wedgeMotion.empty())
            mMesh.wedgeMotion[number] = whole.wedgeMotion[wedge];
    }
}

/// Both chains of a vertex's wedges are walked side by side.
std::uint32_t MeshPart::wedgeNumberOf(const CollapseMesh& whole, std::uint32_t wedge) const
{
    std::uint32_t there = whole.vertexOf(wedge), here = numberOf(there);
    for (; there != wedge; there = whole.nextWedge[there])
        here = mMesh.nextWedge[here];
    return here;
}

void MeshPart::addFaces(const CollapseMesh& whole)
{
    mMesh.faces.resize(mFaceCount);
    for (std::uint32_t i = 0; i < mFaceCount; ++i) {
        CollapseMesh::Face& face = mMesh.faces[i];
        face = whole.faces[mFaces[i]];
        const bool own = isOwn(whole, face);
        if (!own)
            mShared.push_back(i);
        for (std::uint32_t& wedge : face.wedge)
            wedge = own ? wedgeNumberOf(whole, wedge) : numberOf(whole.vertexOf(wedge));
    }
    mMesh.countFaces();
    mMesh.buildFaceLists();
    mMesh.facesElsewhere = whole.liveFaces - mMesh.liveFaces;
}

void MeshPart::addStates(const QueueStates& states)
{
    mStates = QueueStates(mMesh.vertexCount());
    for (std::uint32_t number = 0; number < mOwn; ++number) {
        const std::uint32_t vertex = mWedges[number];
        mStates.flags[number] = states.flags[vertex];
        mStates.entries[number].cost = states.entries[vertex].cost;
        const bool isEvaluated = states.flags[vertex] == QueueStates::kQueued
                                 || states.flags[vertex] == (QueueStates::kQueued | QueueStates::kHeldBack);
        if (isEvaluated && number < mInner)
            mStates.entries[number].target = numberOf(states.entries[vertex].target);
    }
}

void MeshPart::writeTo(CollapseMesh& whole, QueueStates& states) const
{
    writeFaces(whole);
    for (std::uint32_t number = 0; number < mOwn; ++number) {
        const std::uint32_t vertex = mWedges[number];
        whole.vertices[vertex].liveFaces = mMesh.vertices[number].liveFaces;
        const std::uint8_t flags = mStates.flags[number];
        if (number >= mInner && !(flags & (QueueStates::kStale | QueueStates::kLocked)))
            continue; // nothing near it has changed, and its collapse may lead out of the part
        states.flags[vertex] = flags;
        states.entries[vertex] = {mStates.entries[number].cost, mWedges[mStates.entries[number].target]};
    }
}

void MeshPart::writeFaces(CollapseMesh& whole) const
{
    auto shared = mShared.begin();
    for (std::uint32_t i = 0; i < mFaceCount; ++i) {
        if (shared != mShared.end() && *shared == i) {
            ++shared;
            continue;
        }
        CollapseMesh::Face& face = whole.faces[mFaces[i]];
        face = mMesh.faces[i];
        if (!mMesh.isGone(face))
            for (std::uint32_t& wedge : face.wedge)
                wedge = mWedges[wedge];
    }
}

std::vector<std::pair<std::uint32_t, float>> MeshPart::raisedBeyond(const CollapseMesh& whole) const
{
    std::vector<std::pair<std::uint32_t, float>> raised;
    for (const std::uint32_t i : mShared)
        if (mMesh.faces[i].deviation > whole.faces[mFaces[i]].deviation)
            raised.emplace_back(mFaces[i], mMesh.faces[i].deviation);
    return raised;
}

} // namespace lodsmith
