#include "PieceRemoval.h"

#include <algorithm>
#include <cmath>

namespace lodsmith {

namespace {

constexpr double kNearEnough = 0.25; // of the piece's radius: a nearer face would hardly cost less

} // namespace

bool PieceRemoval::find(std::uint32_t vertex)
{
    if (!collect(vertex) || mFaces.size() == mMesh.liveFaces)
        return false;
    if (mVertices.size() == 3 && vertex != *std::min_element(mVertices.begin(), mVertices.end()))
        return false; // the three know of each other, and one is enough
    Vec3 centre;
    for (std::uint32_t v : mVertices)
        centre += mMesh.position(v) * (1.0 / static_cast<double>(mVertices.size()));
    double squaredRadius = 0.0;
    for (std::uint32_t v : mVertices)
        squaredRadius = std::max(squaredRadius, lengthSquared(mMesh.position(v) - centre));
    mHeir = mIndex.nearest(centre, kNearEnough * std::sqrt(squaredRadius), mFaces);
    measure();
    return true;
}

void PieceRemoval::measure()
{
    const Corners heir = mMesh.cornersOf(mMesh.faces[mHeir]);
    double sum = 0.0, largest = 0.0, before = 0.0;
    for (std::uint32_t vertex : mVertices) {
        const double squared = closestPointOnTriangle(mMesh.position(vertex), heir).squaredDistance;
        sum += squared;
        largest = std::max(largest, squared);
    }
    mArea = 0.0;
    for (std::uint32_t face : mFaces) {
        mArea += mMesh.faces[face].area;
        before = std::max<double>(before, mMesh.faces[face].deviation);
    }
    mDistance = std::sqrt(sum / static_cast<double>(mVertices.size()));
    mDeviation = before + std::sqrt(largest);
}

void PieceRemoval::remove()
{
    mMesh.raiseFaceDeviation(mHeir, mDeviation);
    for (std::uint32_t face : mFaces)
        mMesh.removeFace(face);
}

/// Everything that hangs together with the vertex. False when that is too much.
bool PieceRemoval::collect(std::uint32_t vertex)
{
    mFaces.clear();
    mVertices.assign(1, vertex);
    std::size_t done = 0; // the list grows meanwhile
    while (done < mVertices.size())
        if (!addVertex(mVertices[done++]))
            return false;
    return true;
}

bool PieceRemoval::addVertex(std::uint32_t vertex)
{
    const std::uint32_t count = mMesh.vertices[vertex].liveFaces;
    if (count > kMaxFaces)
        return false;
    mMesh.compactFaceList(vertex);
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t face = mMesh.faceList(vertex)[i];
        if (std::find(mFaces.begin(), mFaces.end(), face) != mFaces.end())
            continue;
        if (mFaces.size() == kMaxFaces)
            return false;
        mFaces.push_back(face);
        for (std::uint32_t wedge : mMesh.faces[face].wedge)
            if (!isInPiece(mMesh.vertexOf(wedge)))
                mVertices.push_back(mMesh.vertexOf(wedge));
    }
    return true;
}

bool PieceRemoval::isInPiece(std::uint32_t vertex) const
{
    return std::find(mVertices.begin(), mVertices.end(), vertex) != mVertices.end();
}

} // namespace lodsmith
