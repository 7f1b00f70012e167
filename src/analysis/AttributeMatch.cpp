#include "AttributeMatch.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lodsmith::analysis {

namespace {

/// Precise for small angles, where an arc cosine is not.
double angleBetween(const Vec3& a, const Vec3& b)
{
    return std::atan2(length(cross(a, b)), dot(a, b));
}

double distanceBetween(const UvPoint& a, const UvPoint& b)
{
    double squares = 0.0;
    for (int i = 0; i < std::min(a.components, b.components); ++i)
        squares += (a.value[i] - b.value[i]) * (a.value[i] - b.value[i]);
    return std::sqrt(squares);
}

/// UV units that the texture moves along a unit of length, at most, along the triangle's sides.
double uvStretch(const Surface& surface, std::uint32_t triangle)
{
    const Corners& corners = surface.corners(triangle);
    double stretch = 0.0;
    for (int i = 0; i < 3; ++i) {
        Barycentric here{}, next{};
        here[i] = next[(i + 1) % 3] = 1.0;
        const double side = length(corners[(i + 1) % 3] - corners[i]);
        stretch = std::max(stretch, distanceBetween(*surface.uv(triangle, here), *surface.uv(triangle, next)) / side);
    }
    return stretch;
}

class AttributeMatch {
public:
    AttributeMatch(const Surface& from, const SurfaceSample& sample, const SurfaceIndex& to, std::uint32_t subMesh)
        : mIndex(to), mTo(to.surface()), mSubMesh(subMesh),
          mPoint(pointAt(from.corners(sample.triangle), sample.weights)), mFace(from.faceNormal(sample.triangle)),
          mNormal(from.shadingNormal(sample.triangle, sample.weights)), mUv(from.uv(sample.triangle, sample.weights))
    {
    }

    AttributeDifference match(double distance)
    {
        considerWithin(distance + kTolerance);
        if (!mFound) {
            distance = mIndex.closestInSubMesh(mPoint, mSubMesh).distance();
            considerWithin(distance + kTolerance);
        }
        if (mDifference.uv)
            lookAcrossSeams(distance);
        return mDifference;
    }

private:
    bool isOfSubMesh(std::uint32_t triangle) const
    {
        return mSubMesh == kAnySubMesh || mTo.subMesh(triangle) == mSubMesh;
    }
    bool facesTheSameWay(std::uint32_t triangle) const { return dot(mFace, mTo.faceNormal(triangle)) > 0.0; }

    void considerWithin(double radius)
    {
        mIndex.visitWithin(mPoint, radius, [this](std::uint32_t triangle, const TrianglePoint& near) {
            if (isOfSubMesh(triangle))
                consider(triangle, near.weights);
            return true;
        });
    }

    void consider(std::uint32_t triangle, const Barycentric& weights)
    {
        const bool agrees = facesTheSameWay(triangle);
        if (mFound && agrees < mAgrees)
            return;
        if (agrees > mAgrees)
            mDifference = {};
        mFound = true;
        mAgrees = agrees;
        considerNormal(mTo.shadingNormal(triangle, weights));
        considerUv(triangle, weights);
    }

    void considerNormal(const Vec3& normal)
    {
        if (lengthSquared(mNormal) == 0.0 || lengthSquared(normal) == 0.0)
            return;
        const double angle = angleBetween(mNormal, normal);
        mDifference.normal = std::min(angle, mDifference.normal.value_or(angle));
    }

    void considerUv(std::uint32_t triangle, const Barycentric& weights)
    {
        const std::optional<UvPoint> uv = mUv ? mTo.uv(triangle, weights) : std::nullopt;
        if (!uv)
            return;
        const double difference = distanceBetween(*mUv, *uv);
        if (mDifference.uv
            && (difference > *mDifference.uv || (difference == *mDifference.uv && triangle >= mUvTriangle)))
            return;
        mDifference.uv = difference;
        mUvTriangle = triangle;
        mUvWeights = weights;
    }

    void lookAcrossSeams(double distance)
    {
        const double stretch = uvStretch(mTo, mUvTriangle);
        const double shift = 2.0 * distance + kTolerance;
        if (*mDifference.uv <= shift * stretch)
            return;
        const UvPoint here = *mTo.uv(mUvTriangle, mUvWeights);
        const Vec3 place = pointAt(mTo.corners(mUvTriangle), mUvWeights);
        double nearest = std::numeric_limits<double>::max();
        mIndex.visitWithin(mPoint, shift, [&](std::uint32_t triangle, const TrianglePoint& near) {
            const std::optional<UvPoint> uv = mTo.uv(triangle, near.weights);
            if (!uv || !isOfSubMesh(triangle) || facesTheSameWay(triangle) != mAgrees)
                return true;
            const double steepest = std::max(stretch, uvStretch(mTo, triangle));
            const double difference = distanceBetween(*mUv, *uv);
            const double apart = length(pointAt(mTo.corners(triangle), near.weights) - place) + kTolerance;
            const bool acrossSeam = distanceBetween(here, *uv) > 2.0 * apart * steepest;
            if (!acrossSeam || difference > shift * steepest || near.squaredDistance > nearest)
                return true;
            mDifference.uv = near.squaredDistance < nearest ? difference : std::min(difference, *mDifference.uv);
            nearest = near.squaredDistance;
            return true;
        });
    }

    const SurfaceIndex& mIndex;
    const Surface& mTo;
    const std::uint32_t mSubMesh;
    const Vec3 mPoint;
    const Vec3 mFace;
    const Vec3 mNormal;
    const std::optional<UvPoint> mUv;

    bool mFound = false;
    bool mAgrees = false;
    AttributeDifference mDifference;
    std::uint32_t mUvTriangle = 0; ///< where the UV difference was found
    Barycentric mUvWeights{};
};

} // namespace

AttributeDifference matchAttributes(const Surface& from, const SurfaceSample& sample, const SurfaceIndex& to,
                                    std::uint32_t subMesh, double distance)
{
    return AttributeMatch(from, sample, to, subMesh).match(distance);
}

} // namespace lodsmith::analysis
