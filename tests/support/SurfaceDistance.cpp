#include "SurfaceDistance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lodsmith::test {

namespace {

Point along(const Point& start, const Point& direction, double share)
{
    return {start[0] + share * direction[0], start[1] + share * direction[1], start[2] + share * direction[2]};
}

double distanceToSegment(const Point& point, const Point& a, const Point& b)
{
    const Point direction = subtract(b, a);
    const double squared = dot(direction, direction);
    const double share = squared > 0 ? std::clamp(dot(subtract(point, a), direction) / squared, 0.0, 1.0) : 0.0;
    return length(subtract(point, along(a, direction, share)));
}

/// Distance to the inside of the triangle; infinite when the foot of the perpendicular is outside.
double distanceToInside(const Point& point, const Triangle& triangle)
{
    const Point u = subtract(triangle[1], triangle[0]);
    const Point v = subtract(triangle[2], triangle[0]);
    const Point w = subtract(point, triangle[0]);
    const double uu = dot(u, u);
    const double uv = dot(u, v);
    const double vv = dot(v, v);
    const double determinant = uu * vv - uv * uv;
    const double s = (vv * dot(w, u) - uv * dot(w, v)) / determinant;
    const double t = (uu * dot(w, v) - uv * dot(w, u)) / determinant;
    if (!(determinant > 0) || !(s >= 0) || !(t >= 0) || !(s + t <= 1))
        return std::numeric_limits<double>::infinity();
    return length(subtract(point, along(along(triangle[0], u, s), v, t)));
}

/// A lower bound on the distance that is cheap to take.
double distanceToBox(const Point& point, const Triangle& triangle)
{
    Point outside{};
    for (int i = 0; i < 3; ++i) {
        const auto [low, high] = std::minmax({triangle[0][i], triangle[1][i], triangle[2][i]});
        outside[i] = std::max({low - point[i], point[i] - high, 0.0});
    }
    return length(outside);
}

} // namespace

double dot(const Point& a, const Point& b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Point subtract(const Point& a, const Point& b)
{
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

double length(const Point& a)
{
    return std::sqrt(dot(a, a));
}

Point areaNormal(const Triangle& triangle)
{
    const Point u = subtract(triangle[1], triangle[0]);
    const Point v = subtract(triangle[2], triangle[0]);
    return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

double distanceToTriangle(const Point& point, const Triangle& triangle)
{
    return std::min({distanceToInside(point, triangle), distanceToSegment(point, triangle[0], triangle[1]),
                     distanceToSegment(point, triangle[1], triangle[2]),
                     distanceToSegment(point, triangle[2], triangle[0])});
}

double distanceToSurface(const Point& point, const std::vector<Triangle>& triangles)
{
    double nearest = std::numeric_limits<double>::infinity();
    for (const Triangle& triangle : triangles) {
        if (distanceToBox(point, triangle) < nearest)
            nearest = std::min(nearest, distanceToTriangle(point, triangle));
    }
    return nearest;
}

double sampledDistance(const std::vector<Triangle>& from, const std::vector<Triangle>& to, std::uint32_t maxSamples,
                       std::uint32_t seed)
{
    TestRandom random(seed);
    const std::size_t step = from.size() * 6 / (maxSamples + 1) + 1;
    double greatest = 0.0;
    for (std::size_t i = 0; i < from.size(); i += step) {
        for (const Point& corner : from[i])
            greatest = std::max(greatest, distanceToSurface(corner, to));
        for (int n = 0; n < 3; ++n) {
            const double root = std::sqrt(random.uniform());
            const Point edgePoint = along(from[i][1], subtract(from[i][2], from[i][1]), random.uniform());
            greatest =
                std::max(greatest, distanceToSurface(along(from[i][0], subtract(edgePoint, from[i][0]), root), to));
        }
    }
    return greatest;
}

} // namespace lodsmith::test
