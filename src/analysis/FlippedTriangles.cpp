#include "FlippedTriangles.h"

#include <algorithm>

namespace lodsmith::analysis {

namespace {

constexpr Barycentric kCentre{1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0};

bool isThin(const Corners& corners, const Vec3& normal)
{
    const double longest =
        std::max({length(corners[1] - corners[0]), length(corners[2] - corners[1]), length(corners[0] - corners[2])});
    return length(normal) <= longest * kTolerance;
}

bool facesAgainstAll(const Vec3& normal, const Vec3& centre, double radius, const SurfaceIndex& original)
{
    bool against = false;
    original.visitWithin(centre, radius, [&](std::uint32_t near, const TrianglePoint&) {
        const Vec3 other = original.surface().faceNormal(near);
        if (lengthSquared(other) == 0.0)
            return true;
        against = dot(normal, other) < -1e-9 * length(normal) * length(other);
        return against;
    });
    return against;
}

} // namespace

Result<std::uint32_t> countFlippedTriangles(const Surface& simplified, const SurfaceIndex& original,
                                            const std::vector<double>& reach, ComparisonProgress& progress)
{
    std::uint32_t flipped = 0;
    std::uint32_t guess = 0;
    for (std::uint32_t i = 0; i < simplified.triangleCount(); ++i) {
        if (!progress.step())
            return ComparisonProgress::cancelled();
        const Corners& corners = simplified.corners(i);
        const Vec3 normal = simplified.faceNormal(i);
        if (isThin(corners, normal))
            continue;
        const Vec3 centre = pointAt(corners, kCentre);
        const ClosestHit hit = original.closest(centre, guess);
        guess = hit.triangle;
        if (facesAgainstAll(normal, centre, std::max(reach[i], hit.distance()) + kTolerance, original))
            ++flipped;
    }
    return flipped;
}

} // namespace lodsmith::analysis
