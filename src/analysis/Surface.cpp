#include "Surface.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lodsmith::analysis {

namespace {

Vec3 normalized(const Vec3& v)
{
    const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    if (largest == 0.0)
        return {};
    const Vec3 safe = v * (1.0 / largest); // the square of a tiny component would vanish
    return safe * (1.0 / length(safe));
}

/// `count` floats of the three corners, weighted.
void interpolate(const FloatStream& stream, const WeldedTriangle& triangle, const Barycentric& weights, int count,
                 double* out)
{
    std::fill_n(out, count, 0.0);
    for (int corner = 0; corner < 3; ++corner) {
        float values[4];
        stream.read(triangle.vertex[corner], count, values);
        for (int i = 0; i < count; ++i)
            out[i] += weights[corner] * values[i];
    }
}

} // namespace

LocalFrame::LocalFrame(const std::vector<Position>& positions)
{
    if (positions.empty())
        return;
    Position low = positions.front(), high = low;
    for (const Position& position : positions)
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], position[axis]);
            high[axis] = std::max(high[axis], position[axis]);
        }
    double half[3], longest = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
        half[axis] = (static_cast<double>(low[axis]) + high[axis]) / 2.0;
        longest = std::max(longest, static_cast<double>(high[axis]) - low[axis]);
    }
    mCentre = {half[0], half[1], half[2]};
    std::frexp(longest, &mExponent);
    mExponent = longest > 0.0 ? -mExponent : 0;
}

Vec3 LocalFrame::toLocal(const Position& position) const
{
    const double scale = std::ldexp(1.0, mExponent);
    return (Vec3{position[0], position[1], position[2]} - mCentre) * scale;
}

double LocalFrame::toWorld(double localLength) const
{
    return std::ldexp(localLength, -mExponent);
}

Surface::Surface(const MeshView& mesh, const std::vector<WeldedTriangle>& triangles, const std::vector<Vec3>& points)
    : mMesh(mesh), mPoints(points), mDraws(mesh.subMeshes.size(), false)
{
    mTriangles.reserve(triangles.size());
    mCorners.reserve(triangles.size());
    for (const WeldedTriangle& triangle : triangles) {
        if (triangle.collapsed())
            continue;
        mTriangles.push_back(triangle);
        mCorners.push_back({points[triangle.position[0]], points[triangle.position[1]], points[triangle.position[2]]});
        mDraws[triangle.subMesh] = true;
    }
}

Vec3 Surface::faceNormal(std::uint32_t triangle) const
{
    const Corners& p = corners(triangle);
    return cross(p[1] - p[0], p[2] - p[0]);
}

Vec3 Surface::shadingNormal(std::uint32_t triangle, const Barycentric& weights) const
{
    const FloatStream& normals = bufferOf(triangle).normals;
    if (normals) {
        double sum[3];
        interpolate(normals, mTriangles[triangle], weights, 3, sum);
        const Vec3 normal = normalized({sum[0], sum[1], sum[2]});
        if (lengthSquared(normal) > 0.0)
            return normal;
    }
    return normalized(faceNormal(triangle));
}

std::optional<UvPoint> Surface::uv(std::uint32_t triangle, const Barycentric& weights) const
{
    const std::vector<UvStream>& sets = bufferOf(triangle).uvSets;
    if (sets.empty() || !sets[0].stream)
        return std::nullopt;
    UvPoint point;
    point.components = sets[0].components;
    interpolate(sets[0].stream, mTriangles[triangle], weights, point.components, point.value.data());
    return point;
}

const VertexBufferView& Surface::bufferOf(std::uint32_t triangle) const
{
    return mMesh.vertexBuffers[vertexBuffer(triangle)];
}

} // namespace lodsmith::analysis
