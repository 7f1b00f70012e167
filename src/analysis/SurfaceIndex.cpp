#include "SurfaceIndex.h"

#include <limits>
#include <utility>

namespace lodsmith::analysis {

namespace {

struct DeviceDeleter {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
struct GeometryDeleter {
    void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
};
using Device = std::unique_ptr<RTCDeviceTy, DeviceDeleter>;
using Geometry = std::unique_ptr<RTCGeometryTy, GeometryDeleter>;

Error embreeError(RTCDevice device)
{
    if (rtcGetDeviceError(device) == RTC_ERROR_UNSUPPORTED_CPU)
        return {ErrorCode::Unsupported, "Embree does not support this processor"};
    return {ErrorCode::OutOfMemory, "Embree has not enough memory to index the surface"};
}

bool fill(RTCGeometry geometry, const Surface& surface)
{
    const std::vector<Vec3>& points = surface.points();
    auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                                 3 * sizeof(float), points.size()));
    auto* indices = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), surface.triangleCount()));
    if (!vertices || !indices)
        return false;
    for (const Vec3& point : points)
        for (const double component : {point.x, point.y, point.z})
            *vertices++ = static_cast<float>(component);
    for (std::uint32_t i = 0; i < surface.triangleCount(); ++i)
        for (const std::uint32_t position : surface.triangle(i).position)
            *indices++ = position;
    return true;
}

} // namespace

Result<SurfaceIndex> SurfaceIndex::create(const Surface& surface)
{
    const Device device(rtcNewDevice("threads=1"));
    if (!device)
        return embreeError(nullptr);
    const Geometry geometry(rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_TRIANGLE));
    SurfaceIndex index(surface, rtcNewScene(device.get()));
    if (!geometry || !index.mScene || !fill(geometry.get(), surface))
        return embreeError(device.get());
    rtcCommitGeometry(geometry.get());
    rtcAttachGeometry(index.mScene.get(), geometry.get());
    rtcCommitScene(index.mScene.get());
    if (rtcGetDeviceError(device.get()) != RTC_ERROR_NONE)
        return Error{ErrorCode::OutOfMemory, "Embree has not enough memory to index the surface"};
    return Result<SurfaceIndex>(std::move(index));
}

float SurfaceIndex::safeRadius(double distance)
{
    // Corners and query point are rounded to float (by at most 2^-25 of the frame a coordinate), Embree's own
    // arithmetic loses a few bits more.
    return static_cast<float>(distance * (1.0 + 1e-5) + kTolerance);
}

RTCPointQuery SurfaceIndex::queryAt(const Vec3& point, double distance)
{
    RTCPointQuery query;
    query.x = static_cast<float>(point.x);
    query.y = static_cast<float>(point.y);
    query.z = static_cast<float>(point.z);
    query.time = 0.0f;
    query.radius = safeRadius(distance);
    return query;
}

void SurfaceIndex::query(RTCPointQuery& query, RTCPointQueryFunction visit, void* data) const
{
    RTCPointQueryContext context;
    rtcInitPointQueryContext(&context);
    rtcPointQuery(mScene.get(), &query, &context, visit, data);
}

template <class Accept>
void SurfaceIndex::improve(const Vec3& point, ClosestHit& best, Accept accept) const
{
    struct Search {
        const Surface& surface;
        Vec3 point;
        Accept accept;
        ClosestHit& best;
    } data{*mSurface, point, accept, best};

    RTCPointQuery around = queryAt(point, best.distance());
    query(
        around,
        [](RTCPointQueryFunctionArguments* arguments) {
            const Search& search = *static_cast<const Search*>(arguments->userPtr);
            const std::uint32_t triangle = arguments->primID;
            const Corners& corners = search.surface.corners(triangle);
            const double best = search.best.point.squaredDistance;
            if (!search.accept(triangle) || boxIsFarther(search.point, corners, best))
                return false;
            const TrianglePoint near = closestPointOnTriangle(search.point, corners);
            if (near.squaredDistance > best || (near.squaredDistance == best && triangle >= search.best.triangle))
                return false;
            search.best = {near, triangle};
            arguments->query->radius = safeRadius(search.best.distance());
            return true;
        },
        &data);
}

ClosestHit SurfaceIndex::closest(const Vec3& point, std::uint32_t guess) const
{
    ClosestHit best{closestPointOnTriangle(point, mSurface->corners(guess)), guess};
    improve(point, best, [](std::uint32_t) { return true; });
    return best;
}

ClosestHit SurfaceIndex::closestInSubMesh(const Vec3& point, std::uint32_t subMesh) const
{
    constexpr double kBeyondTheFrame = 16.0;
    ClosestHit best;
    best.point.squaredDistance = kBeyondTheFrame;
    best.triangle = std::numeric_limits<std::uint32_t>::max();
    improve(point, best, [this, subMesh](std::uint32_t triangle) { return mSurface->subMesh(triangle) == subMesh; });
    return best;
}

} // namespace lodsmith::analysis
