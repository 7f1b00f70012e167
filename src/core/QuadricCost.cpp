// Garland, Heckbert: Surface Simplification Using Quadric Error Metrics. SIGGRAPH 1997.
// Lindstrom, Turk: Fast and Memory Efficient Polygonal Simplification. Visualization 1998.
// Hoppe: New Quadric Metric for Simplifying Meshes with Appearance Attributes. Visualization 1999.

#include "QuadricCost.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lodsmith {

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kBorderWeight = 1.0;   // of a border's constraint plane against a face's, per squared edge length
constexpr double kMaterialWeight = 0.5; // ... of each side of a border between submeshes
constexpr double kShortEdge = 1e-9;     // share of area * length^2: among flat choices the shortest edge wins
constexpr double kExtrapolation = 4.0;  // a sliver's attributes are continued no farther than this many of its edges

} // namespace

void QuadricCost::begin(const CollapseMesh& mesh, const OneRing& ring)
{
    mMesh = &mesh;
    mRing = &ring;
    mXX = mXY = mXZ = mYY = mYZ = mZZ = mArea = 0.0;
    for (std::uint32_t i = 0; i < ring.faceCount; ++i) {
        const CollapseMesh::Face& face = mesh.faces[ring.faces[i].face];
        addPlane({face.normal[0], face.normal[1], face.normal[2]}, face.area);
        mArea += face.area;
    }
    addConstraints();
    const double importance = mesh.importance.empty() ? 0.0 : mesh.importance[ring.vertex];
    mImportanceFactor = importance < 1.0 ? 1.0 / ((1.0 - importance) * (1.0 - importance)) : kInfinite;
    for (std::uint32_t i = 0; i < ring.neighbourCount; ++i) {
        mGeometric[i] = geometricCost(ring.edge[i]);
        mTotal[i] = -1.0;
    }
}

void QuadricCost::addPlane(const Vec3& n, double weight)
{
    mXX += weight * n.x * n.x;
    mXY += weight * n.x * n.y;
    mXZ += weight * n.x * n.z;
    mYY += weight * n.y * n.y;
    mYZ += weight * n.y * n.z;
    mZZ += weight * n.z * n.z;
}

/// Planes upright on the faces along borders and submesh borders. The cross product carries the edge's length, so that
/// the weight is a squared length, like an area.
void QuadricCost::addConstraints()
{
    const bool manySubMeshes = mMesh->firstFaceOfSubMesh.size() > 2;
    const std::uint32_t firstSubMesh = manySubMeshes ? mMesh->subMeshOf(mRing->faces[0].face) : 0;
    bool mixed = false;
    for (std::uint32_t i = 1; manySubMeshes && i < mRing->faceCount && !mixed; ++i)
        mixed = mMesh->subMeshOf(mRing->faces[i].face) != firstSubMesh;
    for (std::uint32_t i = 0; i < mRing->faceCount; ++i) {
        const OneRing::RingFace& ringFace = mRing->faces[i];
        const CollapseMesh::Face& face = mMesh->faces[ringFace.face];
        const Vec3 normal{face.normal[0], face.normal[1], face.normal[2]};
        for (const std::uint32_t neighbour : {std::uint32_t{ringFace.second}, std::uint32_t{ringFace.third}}) {
            if (mRing->facesOn(neighbour) == 1) {
                addPlane(cross(normal, mRing->edge[neighbour]), kBorderWeight);
            } else if (mixed) {
                const std::uint32_t here = mMesh->subMeshOf(ringFace.face);
                for (std::uint32_t k = 0; k < mRing->faceCount; ++k)
                    if (mRing->contains(mRing->faces[k], neighbour) && mMesh->subMeshOf(mRing->faces[k].face) != here) {
                        addPlane(cross(normal, mRing->edge[neighbour]), kMaterialWeight);
                        break;
                    }
            }
        }
    }
}

double QuadricCost::geometricCost(const Vec3& e) const
{
    const double planes = e.x * (mXX * e.x + 2.0 * (mXY * e.y + mXZ * e.z)) + e.y * (mYY * e.y + 2.0 * mYZ * e.z) + mZZ * e.z * e.z;
    return std::max(planes, 0.0) + kShortEdge * mArea * lengthSquared(e);
}

Candidate QuadricCost::cheapest()
{
    int best = -1;
    double bestCost = kInfinite;
    for (std::uint32_t i = 0; i < mRing->neighbourCount; ++i)
        if (mTotal[i] >= 0.0 && mTotal[i] < bestCost) {
            bestCost = mTotal[i];
            best = static_cast<int>(i);
        }
    for (int i = nextByGeometry(); i >= 0 && mGeometric[i] < bestCost; i = nextByGeometry()) {
        const double limit = bestCost - mGeometric[i];
        const double attributes = attributeCost(static_cast<std::uint32_t>(i), limit);
        mGeometric[i] += attributes; // a sum given up half-way is a closer lower bound for next time
        if (attributes < limit || attributes == kInfinite)
            mTotal[i] = mGeometric[i];
        if (attributes < limit) {
            bestCost = mTotal[i];
            best = i;
        }
    }
    if (best < 0)
        return {};
    const double cost = bestCost * mImportanceFactor;
    return {best, static_cast<float>(std::min(cost, 1e30)), mArea > 0.0 ? std::sqrt(cost / mArea) : 0.0};
}

int QuadricCost::nextByGeometry() const
{
    int best = -1;
    for (std::uint32_t i = 0; i < mRing->neighbourCount; ++i)
        if (mTotal[i] < 0.0 && (best < 0 || mGeometric[i] < mGeometric[best]))
            best = static_cast<int>(i);
    return best;
}

void QuadricCost::reject(int neighbour)
{
    mTotal[neighbour] = kInfinite;
}

double QuadricCost::attributeCost(std::uint32_t neighbour, double limit)
{
    if (!mWedges.build(*mMesh, *mRing, neighbour))
        return kInfinite;
    double sum = 0.0;
    if (mMesh->attributeStride != 0)
        for (std::uint32_t i = 0; i < mRing->faceCount && sum < limit; ++i) {
            const OneRing::RingFace& face = mRing->faces[i];
            sum += faceAttributeCost(face, mRing->edge[neighbour], mWedges(face.wedge[0]));
        }
    return sum;
}

double QuadricCost::faceAttributeCost(const OneRing::RingFace& ringFace, const Vec3& edge, std::uint32_t target) const
{
    const CollapseMesh::Face& face = mMesh->faces[ringFace.face];
    if (!(face.area > 0.0f))
        return 0.0;
    const Vec3 normal{face.normal[0], face.normal[1], face.normal[2]};
    const Vec3 across = cross(normal, edge);
    const double inverse = 0.5 / face.area;
    const auto bounded = [](double t) { return static_cast<float>(std::clamp(t, -kExtrapolation, kExtrapolation)); };
    const float second = bounded(dot(across, mRing->edge[ringFace.third]) * inverse);
    const float third = bounded(-dot(across, mRing->edge[ringFace.second]) * inverse);
    const float* here = mMesh->attributesOf(ringFace.wedge[0]);
    const float* there = mMesh->attributesOf(target);
    const float* atSecond = mMesh->attributesOf(ringFace.wedge[1]);
    const float* atThird = mMesh->attributesOf(ringFace.wedge[2]);
    float lanes[4] = {0.0f, 0.0f, 0.0f, 0.0f};
    for (std::size_t k = 0; k < mMesh->attributeStride; k += 4)
        for (std::size_t lane = 0; lane < 4; ++lane) {
            const float h = here[k + lane];
            const float difference = second * (atSecond[k + lane] - h) + third * (atThird[k + lane] - h) - (there[k + lane] - h);
            lanes[lane] += difference * difference;
        }
    return face.area * (double{lanes[0] + lanes[1]} + double{lanes[2] + lanes[3]});
}

} // namespace lodsmith
