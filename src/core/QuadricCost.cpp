// Garland, Heckbert: Surface Simplification Using Quadric Error Metrics. SIGGRAPH 1997.
// Lindstrom, Turk: Fast and Memory Efficient Polygonal Simplification. Visualization 1998.
// Hoppe: New Quadric Metric for Simplifying Meshes with Appearance Attributes. Visualization 1999.

#include "QuadricCost.h"

#include <algorithm>
#include <cmath>

namespace lodsmith {

namespace {

constexpr double kBorderWeight = 1.0;   // of a border's constraint plane against a face's, per squared edge length
constexpr double kMaterialWeight = 0.5; // ... of each side of a border between submeshes
constexpr double kSeamWeight = 0.5; // ... of each side of a seam across which attributes jump by an edge length or more
constexpr double kShortEdge = 1e-9; // share of area * length^2: among flat choices the shortest edge wins
constexpr double kFarthest = 4.0;   // a face's attributes are continued no farther than this many of its edges
constexpr double kAttributeShare = 1.5; // what attributes usually make of the cost of the geometry
constexpr double kThinnest = 0.1;       // slivers below this height to length do not steepen their gradients further

Vec3 normalOf(const CollapseMesh::Face& face)
{
    return {face.normal[0], face.normal[1], face.normal[2]};
}

} // namespace

void QuadricCost::begin(const CollapseMesh& mesh, const OneRing& ring)
{
    mMesh = &mesh;
    mRing = &ring;
    mQuadric = {};
    mArea = 0.0;
    for (std::uint32_t i = 0; i < ring.faceCount; ++i) {
        const CollapseMesh::Face& face = mesh.faces[ring.faces[i].face];
        mQuadric.addSquare(normalOf(face), face.area);
        mArea += face.area;
    }
    if (!ring.isPlain || mesh.firstFaceOfSubMesh.size() > 2)
        addConstraints();
    const double importance = mesh.importance.empty() ? 0.0 : mesh.importance[ring.vertex];
    mImportanceFactor = 1.0 / ((1.0 - importance) * (1.0 - importance));
    mQuadric.addIdentity(kShortEdge * mArea);
    for (std::uint32_t i = 0; i < ring.neighbourCount; ++i) {
        mBound[i] = std::max(mQuadric.at(ring.neighbours[i].edge), 0.0);
        mExact[i] = false;
    }
}

float QuadricCost::guess()
{
    return finite(kAttributeShare * *std::min_element(mBound, mBound + mRing->neighbourCount) * mImportanceFactor);
}

/// Attributes are looked at only where the geometry alone could still win.
Candidate QuadricCost::cheapest()
{
    while (true) {
        const double* best = std::min_element(mBound, mBound + mRing->neighbourCount);
        if (*best == kImpossible)
            return {};
        const auto neighbour = static_cast<std::uint32_t>(best - mBound);
        if (mExact[neighbour])
            return {static_cast<int>(neighbour), finite(*best * mImportanceFactor)};
        mExact[neighbour] = true;
        mBound[neighbour] += attributeCost(neighbour);
    }
}

double QuadricCost::lengthOf(float cost, const CollapseMesh& mesh, const OneRing& ring) const
{
    double area = 0.0;
    for (std::uint32_t i = 0; i < ring.faceCount; ++i)
        area += mesh.faces[ring.faces[i].face].area;
    return area > 0.0 ? std::sqrt(cost / area) : 0.0;
}

double QuadricCost::attributeCost(std::uint32_t neighbour)
{
    if (!mWedges.build(*mMesh, *mRing, neighbour))
        return kImpossible;
    if (mMesh->attributeStride == 0)
        return 0.0;
    const Vec3& edge = mRing->neighbours[neighbour].edge;
    double along[OneRing::kMaxNeighbours];
    for (std::uint32_t i = 0; i < mRing->neighbourCount; ++i)
        along[i] = dot(edge, mRing->neighbours[i].edge);
    double sum = 0.0;
    for (std::uint32_t i = 0; i < mWedges.count(); ++i)
        sum += wedgeCost(edge, along, mWedges.from(i), mWedges.to(i));
    return sum;
}

/// The face of this wedge that lies behind, seen along the edge, is continued to the destination. `along` has each
/// neighbour's component along the edge, times its length.
double QuadricCost::wedgeCost(const Vec3& edge, const double* along, std::uint32_t wedge, std::uint32_t target) const
{
    const bool isOnly = !mRing->isSeam;
    double least = kImpossible, area = isOnly ? mArea : 0.0;
    const OneRing::RingFace* behind = nullptr;
    for (std::uint32_t i = 0; i < mRing->faceCount; ++i) {
        const OneRing::RingFace& face = mRing->faces[i];
        if (face.wedge[0] != wedge)
            continue;
        if (!isOnly)
            area += mMesh->faces[face.face].area;
        const double sum = along[face.second] + along[face.third];
        behind = sum < least ? &face : behind;
        least = std::min(sum, least);
    }
    // Barycentric coordinates of the second and third corner at the point opposite to the destination.
    const CollapseMesh::Face& face = mMesh->faces[behind->face];
    const Vec3 &second = mRing->neighbours[behind->second].edge, &third = mRing->neighbours[behind->third].edge;
    const Vec3 across = cross(edge, normalOf(face));
    const double inverse =
        1.0 / std::max(2.0 * face.area, kThinnest * std::max(lengthSquared(second), lengthSquared(third)));
    const auto bounded = [](double t) { return static_cast<float>(std::clamp(t, -kFarthest, kFarthest)); };
    return area
           * mMesh->secondDifference(wedge, target, behind->wedge[1], bounded(dot(across, third) * inverse),
                                     behind->wedge[2], bounded(-dot(across, second) * inverse));
}

/// Planes upright on the faces along borders, submesh borders and seams. The cross product carries the edge's length, so
/// that the weight is a squared length, like an area.
void QuadricCost::addConstraints()
{
    const bool manySubMeshes = mMesh->firstFaceOfSubMesh.size() > 2;
    for (std::uint32_t i = 0; i < mRing->neighbourCount; ++i) {
        const OneRing::RingFace &first = mRing->faces[mRing->neighbours[i].firstFace],
                                &last = mRing->faces[mRing->neighbours[i].lastFace];
        double weight = 0.0;
        if (&first == &last)
            weight = kBorderWeight;
        else if (manySubMeshes && mMesh->subMeshOfWedge(first.wedge[0]) != mMesh->subMeshOfWedge(last.wedge[0]))
            weight = kMaterialWeight;
        else if (first.wedge[0] != last.wedge[0] || mRing->wedgeOf(first, i) != mRing->wedgeOf(last, i))
            weight = seamWeight(first, last, i);
        if (weight > 0.0) {
            mQuadric.addSquare(cross(normalOf(mMesh->faces[first.face]), mRing->neighbours[i].edge), weight);
            if (&first != &last)
                mQuadric.addSquare(cross(normalOf(mMesh->faces[last.face]), mRing->neighbours[i].edge), weight);
        }
    }
}

/// A seam's line is held as firmly as the attributes jump across it, at most like a material border: what lies
/// between the old and the new line gets the other side's attributes.
double QuadricCost::seamWeight(const OneRing::RingFace& a, const OneRing::RingFace& b, std::uint32_t neighbour) const
{
    const double jump = std::max(mMesh->attributeDistance(a.wedge[0], b.wedge[0]),
                                 mMesh->attributeDistance(mRing->wedgeOf(a, neighbour), mRing->wedgeOf(b, neighbour)));
    return kSeamWeight * std::min(1.0, jump / lengthSquared(mRing->neighbours[neighbour].edge));
}

} // namespace lodsmith
