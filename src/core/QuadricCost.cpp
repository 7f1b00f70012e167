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
constexpr double kSeamWeight = 0.5;     // ... of each side of a seam across which attributes jump by an edge length or more
constexpr double kShortEdge = 1e-9;     // share of area * length^2: among flat choices the shortest edge wins
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
    mHasDualBases = false;
    for (std::uint32_t i = 0; i < ring.faceCount; ++i) {
        const CollapseMesh::Face& face = mesh.faces[ring.faces[i].face];
        mQuadric.addSquare(normalOf(face), face.area);
        mArea += face.area;
    }
    addConstraints();
    const double importance = mesh.importance.empty() ? 0.0 : mesh.importance[ring.vertex];
    mImportanceFactor = 1.0 / ((1.0 - importance) * (1.0 - importance));
    for (std::uint32_t i = 0; i < ring.neighbourCount; ++i) {
        const Vec3& edge = ring.edge[i];
        mBound[i] = std::max(mQuadric.at(edge), 0.0) + kShortEdge * mArea * lengthSquared(edge);
        mExact[i] = false;
    }
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
            return candidate(static_cast<int>(neighbour), *best * mImportanceFactor);
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
    findDualBases();
    const Vec3& edge = mRing->edge[neighbour];
    if (!mRing->isSeam)
        return wedgeCost(edge, mRing->faces[0].wedge[0], mWedges(mRing->faces[0].wedge[0]));
    double sum = 0.0;
    for (std::uint32_t i = 0; i < mWedges.count(); ++i)
        sum += wedgeCost(edge, mWedges.from(i), mWedges.to(i));
    return sum;
}

void QuadricCost::findDualBases()
{
    if (mHasDualBases)
        return;
    mHasDualBases = true;
    for (std::uint32_t i = 0; i < mRing->faceCount; ++i) {
        const CollapseMesh::Face& face = mMesh->faces[mRing->faces[i].face];
        const Vec3 normal = normalOf(face);
        const Vec3& second = mRing->edge[mRing->faces[i].second];
        const Vec3& third = mRing->edge[mRing->faces[i].third];
        const double thinnest = kThinnest * std::max(lengthSquared(second), lengthSquared(third));
        const double inverse = 1.0 / std::max(2.0 * face.area, thinnest);
        mDualSecond[i] = cross(third, normal) * inverse;
        mDualThird[i] = cross(normal, second) * inverse;
    }
}

/// The face of this wedge that lies behind, seen along the edge, is continued to the destination.
double QuadricCost::wedgeCost(const Vec3& edge, std::uint32_t wedge, std::uint32_t target) const
{
    std::uint32_t behind = 0;
    double second = 0.0, third = 0.0, deepest = -kImpossible, area = 0.0;
    for (std::uint32_t i = 0; i < mRing->faceCount; ++i) {
        if (mRing->faces[i].wedge[0] != wedge)
            continue;
        area += mMesh->faces[mRing->faces[i].face].area;
        const double s = -dot(mDualSecond[i], edge), t = -dot(mDualThird[i], edge);
        if (std::min(s, t) > deepest) {
            deepest = std::min(s, t);
            behind = i;
            second = s;
            third = t;
        }
    }
    const float s = static_cast<float>(second), t = static_cast<float>(third);
    const float* here = mMesh->attributesOf(wedge);
    const float* there = mMesh->attributesOf(target);
    const float* atSecond = mMesh->attributesOf(mRing->faces[behind].wedge[1]);
    const float* atThird = mMesh->attributesOf(mRing->faces[behind].wedge[2]);
    float sum[2] = {0.0f, 0.0f};
    for (std::size_t k = 0; k < mMesh->attributeStride; k += 2)
        for (std::size_t lane = 0; lane < 2; ++lane) {
            const float h = here[k + lane];
            const float difference = there[k + lane] - h + s * (atSecond[k + lane] - h) + t * (atThird[k + lane] - h);
            sum[lane] += difference * difference;
        }
    return area * (double{sum[0]} + sum[1]);
}

/// Planes upright on the faces along borders, submesh borders and seams. The cross product carries the edge's length, so that
/// the weight is a squared length, like an area.
void QuadricCost::addConstraints()
{
    const bool mixed = touchesSeveralSubMeshes();
    for (std::uint32_t i = 0; i < mRing->faceCount; ++i) {
        const OneRing::RingFace& face = mRing->faces[i];
        for (const std::uint32_t neighbour : {std::uint32_t{face.second}, std::uint32_t{face.third}}) {
            double weight = 0.0;
            if (mRing->facesOn(neighbour) == 1)
                weight = kBorderWeight;
            else if (mixed && isMaterialBorder(i, neighbour))
                weight = kMaterialWeight;
            else if (mRing->touchesSeam)
                weight = seamWeight(i, neighbour);
            if (weight > 0.0)
                mQuadric.addSquare(cross(normalOf(mMesh->faces[face.face]), mRing->edge[neighbour]), weight);
        }
    }
}

bool QuadricCost::touchesSeveralSubMeshes() const
{
    if (mMesh->firstFaceOfSubMesh.size() <= 2)
        return false;
    const std::uint32_t first = mMesh->subMeshOf(mRing->faces[0].face);
    return std::any_of(mRing->faces, mRing->faces + mRing->faceCount,
                       [&](const OneRing::RingFace& face) { return mMesh->subMeshOf(face.face) != first; });
}

bool QuadricCost::isMaterialBorder(std::uint32_t face, std::uint32_t neighbour) const
{
    const std::uint32_t here = mMesh->subMeshOf(mRing->faces[face].face);
    return std::any_of(mRing->faces, mRing->faces + mRing->faceCount, [&](const OneRing::RingFace& other) {
        return mRing->contains(other, neighbour) && mMesh->subMeshOf(other.face) != here;
    });
}

/// A seam's line is held as firmly as the attributes jump across it, at most like a material border: what lies
/// between the old and the new line gets the other side's attributes.
double QuadricCost::seamWeight(std::uint32_t faceIndex, std::uint32_t neighbour) const
{
    const OneRing::RingFace& face = mRing->faces[faceIndex];
    const std::uint32_t there = face.second == neighbour ? face.wedge[1] : face.wedge[2];
    double jump = 0.0;
    for (std::uint32_t i = 0; i < mRing->faceCount; ++i) {
        const OneRing::RingFace& other = mRing->faces[i];
        if (i == faceIndex || !mRing->contains(other, neighbour))
            continue;
        const std::uint32_t otherThere = other.second == neighbour ? other.wedge[1] : other.wedge[2];
        jump = std::max({jump, mMesh->attributeDistance(face.wedge[0], other.wedge[0]), mMesh->attributeDistance(there, otherThere)});
    }
    return kSeamWeight * std::min(1.0, jump / lengthSquared(mRing->edge[neighbour]));
}

} // namespace lodsmith
