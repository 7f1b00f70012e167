#pragma once

#include "Surface.h"

#include <cstdint>
#include <vector>

namespace lodsmith::analysis {

/// A point on a surface.
struct SurfaceSample {
    std::uint32_t triangle = 0;
    Barycentric weights{};
};

/// `count` points spread evenly over the area: one at random in each of `count` equal shares of it, taken triangle
/// after triangle, so that neighbours in the list are neighbours on most surfaces. A surface without area has equal
/// shares by triangle.
/// The same seed gives the same points everywhere. The surface must have a triangle.
std::vector<SurfaceSample> sampleArea(const Surface& surface, std::uint32_t count, std::uint64_t seed);

/// One point for each buffer vertex that the surface uses, so each wedge of a welded position once.
std::vector<SurfaceSample> sampleVertices(const Surface& surface);

} // namespace lodsmith::analysis
