#include "PieceRemoval.h"

#include <algorithm>
#include <cmath>

namespace lodsmith {

namespace {

constexpr std::uint32_t kMaxFaces = 8, kMaxCorners = 3 * kMaxFaces; // of a piece that counts as small
constexpr double kNearEnough = 0.25; // of the piece's radius: a nearer face would hardly cost less

} // namespace

bool PieceRemoval::find(const OneRing& ring)
{
    if (!collect(ring) || mFaces.size() == mMesh.liveFaces)
        return false;
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
    sum /= static_cast<double>(mVertices.size());
    if (mMesh.poses.count() != 0)
        measureInPoses(sum, largest);
    mArea = 0.0;
    for (std::uint32_t face : mFaces) {
        mArea += mMesh.faces[face].area;
        before = std::max<double>(before, mMesh.faces[face].deviation);
    }
    mDistance = std::sqrt(sum);
    mDeviation = before + std::sqrt(largest);
}

/// @param squares mean squared distance at rest; afterwards over rest and all poses
/// @param largest squared, of any so far
void PieceRemoval::measureInPoses(double& squares, double& largest) const
{
    const auto cornerOf = [this](std::uint32_t wedge, std::size_t pose) {
        return mMesh.poses.of(mMesh.placeOf(wedge))[pose / Poses::kLanes].at(pose % Poses::kLanes);
    };
    const std::uint32_t* to = mMesh.faces[mHeir].wedge;
    for (std::size_t pose = 0; pose < mMesh.poses.count(); ++pose) {
        const Corners heir{cornerOf(to[0], pose), cornerOf(to[1], pose), cornerOf(to[2], pose)};
        double sum = 0.0;
        for (std::uint32_t face : mFaces)
            for (std::uint32_t wedge : mMesh.faces[face].wedge) {
                const double squared = closestPointOnTriangle(cornerOf(wedge, pose), heir).squaredDistance;
                sum += squared;
                largest = std::max(largest, squared);
            }
        squares += sum / static_cast<double>(3 * mFaces.size());
    }
    squares /= static_cast<double>(1 + mMesh.poses.count());
}

void PieceRemoval::remove()
{
    mMesh.raiseFaceDeviation(mHeir, mDeviation);
    for (std::uint32_t face : mFaces)
        mMesh.removeFace(face);
}

/// Everything that hangs together with the ring. False when that is too much, which the number of corners tells early.
bool PieceRemoval::collect(const OneRing& ring)
{
    mFaces.clear();
    mVertices.assign(1, ring.vertex);
    std::uint32_t corners = ring.faceCount;
    for (std::uint32_t i = 0; i < ring.faceCount; ++i)
        mFaces.push_back(ring.faces[i].face);
    for (std::uint32_t i = 0; i < ring.neighbourCount; ++i)
        corners += add(ring.neighbours[i].vertex);
    for (std::size_t done = 1; done < mVertices.size() && corners <= kMaxCorners; ++done) // the list grows meanwhile
        corners += addNeighbours(mVertices[done]);
    return corners <= kMaxCorners;
}

/// Tells how many corners that adds.
std::uint32_t PieceRemoval::add(std::uint32_t vertex)
{
    mVertices.push_back(vertex);
    return mMesh.vertices[vertex].liveFaces;
}

std::uint32_t PieceRemoval::addNeighbours(std::uint32_t vertex)
{
    std::uint32_t corners = 0;
    mMesh.compactFaceList(vertex);
    for (std::uint32_t i = 0; i < mMesh.vertices[vertex].liveFaces; ++i) {
        const std::uint32_t face = mMesh.faceList(vertex)[i];
        if (std::find(mFaces.begin(), mFaces.end(), face) != mFaces.end())
            continue;
        mFaces.push_back(face);
        for (std::uint32_t wedge : mMesh.faces[face].wedge)
            if (!isInPiece(mMesh.vertexOf(wedge)))
                corners += add(mMesh.vertexOf(wedge));
    }
    return corners;
}

bool PieceRemoval::isInPiece(std::uint32_t vertex) const
{
    return std::find(mVertices.begin(), mVertices.end(), vertex) != mVertices.end();
}

} // namespace lodsmith
