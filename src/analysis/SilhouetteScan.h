#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

/// Square pictures of triangles from the side. Header only, for other rooms to use.
namespace lodsmith::analysis {

constexpr std::size_t kSilhouetteDirections = 8;

/// Where the pictures look: orthographically, at a sphere, from eight directions at right angles to +y, 22.5 degrees
/// apart, over half a turn, since opposite directions show the same outline.
struct SilhouetteFrame {
    std::array<double, 3> centre = {0.0, 0.0, 0.0};
    double pixelsPerUnit = 0.0;
    std::size_t side = 0; ///< pixels a row, and rows of a picture

    std::size_t pixels() const { return kSilhouetteDirections * side * side; } ///< of all pictures
};

/// A place in all pictures: pixels from the left and from the top, the latter the same in each.
struct SilhouettePoint {
    std::array<double, kSilhouetteDirections> x;
    double y;
};

inline SilhouettePoint project(const SilhouetteFrame& frame, const std::array<double, 3>& point)
{
    // Square roots are the same everywhere, sines are not.
    static const double kHalf = std::sqrt(0.5);
    static const double kCos = std::sqrt(2.0 + std::sqrt(2.0)) / 2.0, kSin = std::sqrt(2.0 - std::sqrt(2.0)) / 2.0;
    const double middle = static_cast<double>(frame.side) / 2.0;
    const double x = (point[0] - frame.centre[0]) * frame.pixelsPerUnit;
    const double z = (point[2] - frame.centre[2]) * frame.pixelsPerUnit;
    return {{middle + x, middle + kCos * x + kSin * z, middle + kHalf * (x + z), middle + kSin * x + kCos * z,
             middle + z, middle - kSin * x + kCos * z, middle + kHalf * (z - x), middle - kCos * x + kSin * z},
            middle + (frame.centre[1] - point[1]) * frame.pixelsPerUnit};
}

/// The first pixel, 0 to side, whose centre is not before a place.
inline std::size_t firstCentre(double place, double side)
{
    const double clamped = std::min(std::max(place - 0.5, 0.0), side);
    const auto whole = static_cast<std::size_t>(clamped);
    return static_cast<double>(whole) < clamped ? whole + 1 : whole;
}

/// Calls visit(first, last) for each run of pixels whose centres a triangle covers, row by row in all pictures. Pixels
/// are numbered through, picture after picture. Triangles that share an edge share no pixel.
template <class Visitor>
void forEachRun(const SilhouetteFrame& frame, const std::array<SilhouettePoint, 3>& triangle, Visitor&& visit)
{
    std::array<const SilhouettePoint*, 3> corner = {&triangle[0], &triangle[1], &triangle[2]};
    const auto order = [&corner](std::size_t a, std::size_t b) {
        if (corner[b]->y < corner[a]->y)
            std::swap(corner[a], corner[b]);
    };
    order(0, 1);
    order(1, 2);
    order(0, 1);
    const auto side = static_cast<double>(frame.side);
    const std::size_t lastRow = firstCentre(corner[2]->y, side);
    for (std::size_t row = firstCentre(corner[0]->y, side); row < lastRow; ++row) {
        const double y = static_cast<double>(row) + 0.5;
        const SilhouettePoint& from = y < corner[1]->y ? *corner[0] : *corner[1];
        const SilhouettePoint& to = y < corner[1]->y ? *corner[1] : *corner[2];
        const double along = (y - from.y) / (to.y - from.y);
        const double alongLong = (y - corner[0]->y) / (corner[2]->y - corner[0]->y);
        for (std::size_t i = 0; i < kSilhouetteDirections; ++i) {
            const double a = corner[0]->x[i] + (corner[2]->x[i] - corner[0]->x[i]) * alongLong;
            const double b = from.x[i] + (to.x[i] - from.x[i]) * along;
            const std::size_t start = (i * frame.side + row) * frame.side;
            const std::size_t first = firstCentre(std::min(a, b), side), last = firstCentre(std::max(a, b), side);
            if (first < last)
                visit(start + first, start + last);
        }
    }
}

} // namespace lodsmith::analysis
