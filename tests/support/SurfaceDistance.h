#pragma once

#include "WeldedMesh.h"

#include <array>
#include <cstdint>
#include <vector>

namespace lodsmith::test {

using Triangle = std::array<Point, 3>;

/// Distance from a point to a triangle, exact up to rounding; slivers and points are triangles too.
double distanceToTriangle(const Point& point, const Triangle& triangle);

/// Distance from a point to the nearest of `triangles`, by trying them all; infinite when there are none.
double distanceToSurface(const Point& point, const std::vector<Triangle>& triangles);

/// The greatest distance from sampled points of `from` to `to`: all corners of `from`, and random points on its triangles.
/// Never more than the true one-sided (Hausdorff) distance. At most about `maxSamples` points are tried.
double sampledDistance(const std::vector<Triangle>& from, const std::vector<Triangle>& to, std::uint32_t maxSamples,
                       std::uint32_t seed);

/// The cross product of two edges: twice the area long, towards the front.
Point areaNormal(const Triangle& triangle);

double dot(const Point& a, const Point& b);
Point subtract(const Point& a, const Point& b);
double length(const Point& a);

} // namespace lodsmith::test
