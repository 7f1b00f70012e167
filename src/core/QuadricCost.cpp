// Garland, Heckbert: Surface Simplification Using Quadric Error Metrics. SIGGRAPH 1997.
// Lindstrom, Turk: Fast and Memory Efficient Polygonal Simplification. Visualization 1998.
// Hoppe: New Quadric Metric for Simplifying Meshes with Appearance Attributes. Visualization 1999.

#include "QuadricCost.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace lodsmith {

namespace {

constexpr int kNext[3] = {1, 2, 0};
constexpr float kBorderWeight = 1.0f;    // of a border's constraint plane against a face's, per squared edge length
constexpr float kMaterialWeight = 0.25f; // ... of a border between submeshes, where two unit normals are added
constexpr float kSeamWeight = 0.25f; // ... of a seam, likewise, across which attributes jump by an edge length or more
constexpr float kShortEdge = 1e-9f;  // share of area * length^2: among flat choices the shortest edge wins
constexpr float kFarthest = 4.0f;    // a face's attributes are continued no farther than this many of its edges
constexpr std::uint32_t kGuessFaces = 8; // more do not make a better guess
constexpr double kAttributeShare = 1.5;  // what attributes usually make of the cost of the geometry
constexpr float kDearest = 1e30f;        // but possible
constexpr float kLeastFloat = std::numeric_limits<float>::min();
constexpr float kThinnest = 0.1f; // slivers below this height to length do not steepen their gradients further

} // namespace

double QuadricCost::importanceFactor(const CollapseMesh& mesh, std::uint32_t vertex)
{
    const double importance = mesh.importance.empty() ? 0.0 : mesh.importance[vertex];
    return 1.0 / ((1.0 - importance) * (1.0 - importance));
}

/// The planes of the faces alone, as a matrix in floats (which is good enough for a guess), at the next corner of each.
float QuadricCost::guess(const CollapseMesh& mesh, std::uint32_t vertex) const
{
    const std::uint32_t* list = mesh.faceList(vertex);
    const std::uint32_t count = std::min(mesh.vertices[vertex].liveFaces, kGuessFaces);
    const float bonus = mesh.areaBonus();
    float xx = 0.0f, xy = 0.0f, xz = 0.0f, yy = 0.0f, yz = 0.0f, zz = 0.0f, shortEdge = 0.0f;
    for (std::uint32_t i = 0; i < count; ++i) {
        const CollapseMesh::Face& face = mesh.faces[list[i]];
        const float x = face.normal[0], y = face.normal[1], z = face.normal[2];
        const float weight = face.area + bonus, wx = weight * x, wy = weight * y, wz = weight * z;
        xx += wx * x;
        xy += wx * y;
        xz += wx * z;
        yy += wy * y;
        yz += wy * z;
        zz += wz * z;
        shortEdge += kShortEdge * weight;
    }
    const float* origin = mesh.vertices[vertex].position;
    float least = kNever;
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t* wedge = mesh.faces[list[i]].wedge;
        const int corner = (mesh.vertexOf(wedge[1]) == vertex ? 1 : 0) + (mesh.vertexOf(wedge[2]) == vertex ? 2 : 0);
        const float* next = mesh.vertices[mesh.vertexOf(wedge[kNext[corner]])].position;
        const float x = next[0] - origin[0], y = next[1] - origin[1], z = next[2] - origin[2];
        const float planes = x * (xx * x + 2.0f * (xy * y + xz * z)) + y * (yy * y + 2.0f * yz * z) + zz * z * z;
        least = std::min(least, std::max(planes, 0.0f) + shortEdge * (x * x + y * y + z * z));
    }
    return finite(kAttributeShare * least * importanceFactor(mesh, vertex));
}

void QuadricCost::begin(const CollapseMesh& mesh, const OneRing& ring)
{
    mMesh = &mesh;
    mRing = &ring;
    mArea = 0.0f;
    mPlaneCount = mHeldCount = 0;
    std::fill(mWedgeArea, mWedgeArea + ring.wedgeCount, 0.0f);
    const float bonus = mesh.areaBonus();
    for (std::uint32_t i = 0; i < ring.faceCount; ++i) {
        const CollapseMesh::Face& face = mesh.faces[ring.faces[i].face];
        mPlanes[mPlaneCount++] = {face.normal[0], face.normal[1], face.normal[2], face.area + bonus};
        mArea += face.area;
        mWedgeArea[ring.faces[i].own] += face.area;
    }
    if (!ring.isPlain || mesh.firstFaceOfSubMesh.size() > 2)
        addConstraints();
    mImportanceFactor = importanceFactor(mesh, ring.vertex);
    measurePlanes();
    if (ring.isPosed)
        measurePoses();
}

/// Squared distances of all neighbours to all planes, four neighbours at a time.
void QuadricCost::measurePlanes()
{
    const std::uint32_t count = mRing->neighbourCount;
    for (std::uint32_t i = 0; i < count; ++i) {
        const Vec3& edge = mRing->neighbours[i].edge;
        mX[i] = static_cast<float>(edge.x);
        mY[i] = static_cast<float>(edge.y);
        mZ[i] = static_cast<float>(edge.z);
        mExact[i] = false;
    }
    for (std::uint32_t first = 0; first < count; first += kLanes) // what lies beyond the last neighbour does no harm
        measurePlanes(first);
}

void QuadricCost::measurePlanes(std::size_t first)
{
    const float *x = mX + first, *y = mY + first, *z = mZ + first;
    float squared[kLanes], bound[kLanes];
    for (std::size_t i = 0; i < kLanes; ++i) {
        squared[i] = x[i] * x[i] + y[i] * y[i] + z[i] * z[i];
        bound[i] = kShortEdge * mArea * squared[i];
    }
    for (std::uint32_t p = 0; p < mPlaneCount; ++p) {
        const Plane plane = mPlanes[p];
        for (std::size_t i = 0; i < kLanes; ++i) {
            const float distance = plane.x * x[i] + plane.y * y[i] + plane.z * z[i];
            bound[i] += plane.weight * (distance * distance);
        }
    }
    for (std::size_t i = 0; i < kLanes; ++i) {
        mSquared[first + i] = squared[i];
        mInverse[first + i] = 1.0f / squared[i];
        mBound[first + i] = bound[i];
    }
}

void QuadricCost::measurePoses()
{
    const std::uint32_t count = mRing->neighbourCount;
    mPosedPlanes.measure(*mRing, mMesh->poses.groups(), mMesh->areaBonus(), mHeld, mHeldCount);
    const float share = 1.0f / static_cast<float>(1 + mMesh->poses.count());
    for (std::uint32_t i = 0; i < count; ++i)
        mBound[i] = share * (mBound[i] + mPosedPlanes.sum(i));
}

/// The neighbour of the least bound, the first of equal ones. In integers, which compilers compare without a branch.
std::uint32_t QuadricCost::leastBound() const
{
    std::uint64_t least = ~std::uint64_t{0};
    for (std::uint32_t i = 0; i < mRing->neighbourCount; ++i) {
        std::uint32_t bits; // of a number that is not negative: they order like it
        std::memcpy(&bits, &mBound[i], sizeof bits);
        least = std::min(least, std::uint64_t{bits} << 32 | i);
    }
    return static_cast<std::uint32_t>(least);
}

/// Attributes are looked at only where the geometry alone could still win.
Candidate QuadricCost::cheapest()
{
    while (true) {
        const std::uint32_t neighbour = leastBound();
        if (mBound[neighbour] == kNever)
            return {};
        if (mExact[neighbour])
            return {static_cast<int>(neighbour), finite(mBound[neighbour] * mImportanceFactor)};
        mExact[neighbour] = true;
        mBound[neighbour] += attributeCost(neighbour);
    }
}

double QuadricCost::lengthOf(float cost, const CollapseMesh& mesh, const OneRing& ring) const
{
    double area = ring.faceCount * static_cast<double>(mesh.areaBonus());
    for (std::uint32_t i = 0; i < ring.faceCount; ++i)
        area += mesh.faces[ring.faces[i].face].area;
    return area > 0.0 ? std::sqrt(cost / area) : 0.0;
}

float QuadricCost::attributeCost(std::uint32_t neighbour)
{
    if (!mWedges.build(*mMesh, *mRing, neighbour))
        return kNever;
    if (mMesh->attributeStride == 0)
        return 0.0f;
    const float x = mX[neighbour], y = mY[neighbour], z = mZ[neighbour];
    float along[OneRing::kMaxNeighbours]; // components along the edge, times its length
    for (std::uint32_t i = 0; i < mRing->neighbourCount; ++i)
        along[i] = x * mX[i] + y * mY[i] + z * mZ[i];
    const float sum = mRing->isFan && !mRing->isSeam() ? fanCost(along) : wedgesCost(along);
    return std::min(kDearest, sum); // a NaN, of absurd attributes, is dear too
}

/// Where no seam hides a face, the one behind is one of the two at the neighbour that lies most nearly opposite.
float QuadricCost::fanCost(const float* along) const
{
    std::uint32_t opposite = 0;
    float least = kNever;
    for (std::uint32_t i = 0; i < mRing->neighbourCount; ++i) {
        const float cosine = along[i] * std::abs(along[i]) * mInverse[i]; // its square and sign, to a common factor
        opposite = cosine < least ? i : opposite;
        least = std::min(cosine, least);
    }
    const Continuation first = continuation(mRing->neighbours[opposite].firstFace, along),
                       last = continuation(mRing->neighbours[opposite].lastFace, along);
    return wedgeCost(0, last.least() > first.least() ? last : first);
}

float QuadricCost::wedgesCost(const float* along)
{
    std::fill(mBehind, mBehind + mRing->wedgeCount, Continuation{});
    for (std::uint32_t i = 0; i < mRing->faceCount; ++i) {
        Continuation& best = mBehind[mRing->faces[i].own];
        if (best.least() >= 0.0f)
            continue;
        const Continuation here = continuation(i, along);
        if (here.least() > best.least())
            best = here;
    }
    float sum = 0.0f;
    for (std::uint32_t i = 0; i < mRing->wedgeCount; ++i)
        sum += wedgeCost(i, mBehind[i]);
    return sum;
}

/// The difference between the attributes that the ring's i-th wedge gets, and those of the face behind, continued.
float QuadricCost::wedgeCost(std::uint32_t i, const Continuation& behind) const
{
    const auto bounded = [](float t) { return std::clamp(t, -kFarthest, kFarthest); };
    const OneRing::RingFace& face = mRing->faces[behind.face];
    return mWedgeArea[i]
           * mMesh->secondDifference(mRing->wedges[i], mWedges.to(i), face.wedge[1], bounded(behind.second),
                                     face.wedge[2], bounded(behind.third));
}

/// The direction opposite to the edge in terms of a face's two sides. The face whose corner spans it, or comes nearest to
/// that, is the one behind.
/// @param along each neighbour's component along the edge, times its length
QuadricCost::Continuation QuadricCost::continuation(std::uint32_t face, const float* along) const
{
    const std::uint32_t i = mRing->faces[face].second, k = mRing->faces[face].third;
    const float ii = mSquared[i], kk = mSquared[k];
    const float ik = mX[i] * mX[k] + mY[i] * mY[k] + mZ[i] * mZ[k];
    const float doubled = 2.0f * mMesh->faces[mRing->faces[face].face].area;
    const float inverse = 1.0f / std::max(std::max(doubled, kThinnest * std::max(ii, kk)) * doubled, kLeastFloat);
    return {face, (ik * along[k] - kk * along[i]) * inverse, (ik * along[i] - ii * along[k]) * inverse};
}

/// Planes upright on the surface along borders, submesh borders and seams. The cross product carries the edge's length, so
/// that the weight is a squared length, like an area. Where two faces meet at an angle the plane stands between them and counts
/// for less: there each face's own plane keeps the other in place.
void QuadricCost::addConstraints()
{
    const bool manySubMeshes = mMesh->firstFaceOfSubMesh.size() > 2;
    for (std::uint32_t i = 0; i < mRing->neighbourCount; ++i) {
        const OneRing::RingFace &first = mRing->faces[mRing->neighbours[i].firstFace],
                                &last = mRing->faces[mRing->neighbours[i].lastFace];
        if (&first == &last)
            addPlane(i, kBorderWeight);
        else if (manySubMeshes && mMesh->subMeshOfWedge(first.wedge[0]) != mMesh->subMeshOfWedge(last.wedge[0]))
            addPlane(i, kMaterialWeight);
        else if (first.own != last.own || mRing->wedgeOf(first, i) != mRing->wedgeOf(last, i))
            addPlane(i, seamWeight(first, last, i));
    }
}

void QuadricCost::addPlane(std::uint32_t neighbour, float weight)
{
    const OneRing::Neighbour& end = mRing->neighbours[neighbour];
    Vec3 upright = CollapseMesh::normalOf(mMesh->faces[mRing->faces[end.firstFace].face]);
    if (end.firstFace != end.lastFace)
        upright += CollapseMesh::normalOf(mMesh->faces[mRing->faces[end.lastFace].face]);
    const Vec3 normal = cross(upright, end.edge);
    mPlanes[mPlaneCount++] = {static_cast<float>(normal.x), static_cast<float>(normal.y), static_cast<float>(normal.z),
                              weight};
    mHeld[mHeldCount++] = {neighbour, weight};
}

/// A seam's line is held as firmly as the attributes jump across it, at most like a material border: what lies
/// between the old and the new line gets the other side's attributes.
float QuadricCost::seamWeight(const OneRing::RingFace& a, const OneRing::RingFace& b, std::uint32_t neighbour) const
{
    const auto enough = static_cast<float>(lengthSquared(mRing->neighbours[neighbour].edge));
    float jump = mMesh->attributeDistance(a.wedge[0], b.wedge[0]);
    if (jump < enough)
        jump = std::max(jump, mMesh->attributeDistance(mRing->wedgeOf(a, neighbour), mRing->wedgeOf(b, neighbour)));
    return jump < enough ? kSeamWeight * jump / enough : kSeamWeight;
}

} // namespace lodsmith
