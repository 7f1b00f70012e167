#pragma once

#include "Vec3.h"

#include <lodsmith/core/Export.h>

#include <array>

namespace lodsmith {

/// Shares of a triangle's three corners in a point of it: none negative, sum 1.
using Barycentric = std::array<double, 3>;
using Corners = std::array<Vec3, 3>;

inline Vec3 pointAt(const Corners& corners, const Barycentric& weights)
{
    return corners[0] * weights[0] + corners[1] * weights[1] + corners[2] * weights[2];
}

struct TrianglePoint {
    double squaredDistance = 0.0;
    Barycentric weights{};
};

/// The point of a triangle that is closest to `point`. Works on slivers and on triangles without area: the distance is
/// always that of a point of the triangle, so it is never too small; on slivers it may be too large by up to 1e-8 of
/// the triangle's length, on others it is right to double precision.
/// After Ericson, "Real-Time Collision Detection" (2005), section 5.1.5; the three sides are searched besides where the
/// triangle is so thin that the regions cannot be trusted.
LODSMITH_API TrianglePoint closestPointOnTriangle(const Vec3& point, const Corners& corners);

/// Whether the box around a triangle is farther away than this: a quick way to leave a triangle out.
LODSMITH_API bool boxIsFarther(const Vec3& point, const Corners& corners, double squaredDistance);

} // namespace lodsmith
