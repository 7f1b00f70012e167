#include "ClosestPoint.h"

#include <algorithm>
#include <limits>

namespace lodsmith {

namespace {

TrianglePoint measured(const Vec3& point, const Corners& corners, const Barycentric& weights)
{
    return {lengthSquared(point - pointAt(corners, weights)), weights};
}

TrianglePoint closestPointOnSide(const Vec3& point, const Corners& corners, int side)
{
    const int next = (side + 1) % 3;
    const Vec3 along = corners[next] - corners[side];
    const double squaredLength = lengthSquared(along);
    const double share = squaredLength > 0.0 ? dot(point - corners[side], along) / squaredLength : 0.0;
    Barycentric weights{};
    weights[next] = std::clamp(share, 0.0, 1.0);
    weights[side] = 1.0 - weights[next];
    return measured(point, corners, weights);
}

/// Side i goes from corner i to the next. A point that is outside of some sides is closest to a point of one of those.
TrianglePoint closestPointOnSides(const Vec3& point, const Corners& corners, const std::array<bool, 3>& isOutsideOf)
{
    TrianglePoint best{std::numeric_limits<double>::infinity(), {}};
    for (int side = 0; side < 3; ++side) {
        if (!isOutsideOf[static_cast<std::size_t>(side)])
            continue;
        const TrianglePoint candidate = closestPointOnSide(point, corners, side);
        if (candidate.squaredDistance < best.squaredDistance)
            best = candidate;
    }
    return best;
}

double outside(double value, double a, double b, double c)
{
    const double low = std::min(std::min(a, b), c), high = std::max(std::max(a, b), c);
    return std::max(std::max(low - value, value - high), 0.0);
}

} // namespace

bool boxIsFarther(const Vec3& point, const Corners& corners, double squaredDistance)
{
    const Vec3 gap{outside(point.x, corners[0].x, corners[1].x, corners[2].x),
                   outside(point.y, corners[0].y, corners[1].y, corners[2].y),
                   outside(point.z, corners[0].z, corners[1].z, corners[2].z)};
    return lengthSquared(gap) > squaredDistance;
}

TrianglePoint closestPointOnTriangle(const Vec3& point, const Corners& corners)
{
    const Vec3 ab = corners[1] - corners[0], ac = corners[2] - corners[0], ap = point - corners[0];
    const Vec3 normal = cross(ab, ac);
    const double squaredArea = lengthSquared(normal);
    const double scale = lengthSquared(ab) * lengthSquared(ac);
    if (squaredArea <= scale * 1e-24)
        return closestPointOnSides(point, corners, {true, true, true});

    const double towardsB = dot(cross(ap, ac), normal) / squaredArea;
    const double towardsC = dot(cross(ab, ap), normal) / squaredArea;
    const double towardsA = 1.0 - towardsB - towardsC;
    const bool isInside = towardsA >= 0.0 && towardsB >= 0.0 && towardsC >= 0.0;
    const bool isThin = squaredArea <= scale * 1e-12;
    if (!isInside)
        return isThin ? closestPointOnSides(point, corners, {true, true, true})
                      : closestPointOnSides(point, corners, {towardsC < 0.0, towardsA < 0.0, towardsB < 0.0});
    const TrianglePoint inside = measured(point, corners, {towardsA, towardsB, towardsC});
    if (!isThin)
        return inside;
    const TrianglePoint onSides = closestPointOnSides(point, corners, {true, true, true});
    return inside.squaredDistance <= onSides.squaredDistance ? inside : onSides;
}

} // namespace lodsmith
