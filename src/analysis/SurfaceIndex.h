#pragma once

#include "Surface.h"

#include <lodsmith/core/Result.h>

#include <embree3/rtcore.h>

#include <cmath>
#include <cstdint>
#include <memory>

namespace lodsmith::analysis {

/// The point of a surface that is closest to another point.
struct ClosestHit {
    TrianglePoint point;
    std::uint32_t triangle = 0;

    double distance() const { return std::sqrt(point.squaredDistance); } ///< in the surface's frame
};

/// Finds the triangles of a surface that are near a point, by Embree's bounding volume hierarchy.
///
/// Embree holds the surface in float and only says which triangles may be near enough; every distance is computed here,
/// in double. What is found does not depend on the order in which Embree visits: of equal distances the lower triangle
/// number wins.
class SurfaceIndex {
public:
    /// The surface must stay where it is. Errors: OutOfMemory, Unsupported when Embree does not run on this machine.
    static Result<SurfaceIndex> create(const Surface& surface);

    const Surface& surface() const { return *mSurface; }

    /// The closest point; the surface must have a triangle.
    /// @param guess a triangle that is probably near: costs or saves time, changes nothing else
    ClosestHit closest(const Vec3& point, std::uint32_t guess) const;
    /// The closest point among the triangles of one submesh, which must have one.
    ClosestHit closestInSubMesh(const Vec3& point, std::uint32_t subMesh) const;

    /// Calls `bool visit(std::uint32_t triangle, const TrianglePoint& closest)` for each triangle that reaches within
    /// `radius` of the point, in any order, until one call returns false.
    template <class Visitor>
    void visitWithin(const Vec3& point, double radius, Visitor visit) const;

private:
    struct SceneDeleter {
        void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
    };

    SurfaceIndex(const Surface& surface, RTCScene scene) : mSurface(&surface), mScene(scene) {}

    /// A point query radius for Embree that misses nothing within `distance`.
    static float safeRadius(double distance);
    static RTCPointQuery queryAt(const Vec3& point, double distance);
    template <class Accept>
    void improve(const Vec3& point, ClosestHit& best, Accept accept) const;
    void query(RTCPointQuery& query, RTCPointQueryFunction visit, void* data) const;

    const Surface* mSurface;
    std::unique_ptr<RTCSceneTy, SceneDeleter> mScene;
};

template <class Visitor>
void SurfaceIndex::visitWithin(const Vec3& point, double radius, Visitor visit) const
{
    struct Visit {
        const Surface& surface;
        Vec3 point;
        double squaredRadius;
        Visitor& visit;
        bool done = false;
    } data{*mSurface, point, radius * radius, visit};

    RTCPointQuery around = queryAt(point, radius);
    query(
        around,
        [](RTCPointQueryFunctionArguments* arguments) {
            Visit& visit = *static_cast<Visit*>(arguments->userPtr);
            const Corners& corners = visit.surface.corners(arguments->primID);
            if (visit.done || boxIsFarther(visit.point, corners, visit.squaredRadius))
                return false;
            const TrianglePoint near = closestPointOnTriangle(visit.point, corners);
            if (near.squaredDistance > visit.squaredRadius || visit.visit(arguments->primID, near))
                return false;
            visit.done = true;
            arguments->query->radius = 0.0f;
            return true;
        },
        &data);
}

} // namespace lodsmith::analysis
