#include <lodsmith/analysis/Coverage.h>

#include "SilhouetteScan.h"
#include "WeldedMesh.h"

#include <lodsmith/core/Assert.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <utility>

namespace lodsmith {

namespace {

using analysis::Position;
using analysis::PositionTable;
using analysis::SilhouetteFrame;
using analysis::SilhouettePoint;
using analysis::WeldedTriangle;

constexpr std::size_t kWordBits = 64;
constexpr float kFarthest = 1e18f;

unsigned bitsIn(std::uint64_t word)
{
    unsigned count = 0;
    for (; word != 0; word &= word - 1)
        ++count;
    return count;
}

struct Counts {
    double original = 0.0; ///< pixels
    double kept = 0.0;
    double gained = 0.0;
};

/// Compares two pictures, a range of words.
Counts compare(const std::vector<std::uint64_t>& original, const std::vector<std::uint64_t>& level, std::size_t first,
               std::size_t last)
{
    Counts counts;
    for (std::size_t word = first; word < last; ++word) {
        counts.original += bitsIn(original[word]);
        counts.kept += bitsIn(original[word] & level[word]);
        counts.gained += bitsIn(level[word] & ~original[word]);
    }
    return counts;
}

void setBits(std::vector<std::uint64_t>& words, std::size_t first, std::size_t last)
{
    while (first < last) {
        const std::size_t end = std::min(last, (first / kWordBits + 1) * kWordBits);
        const std::uint64_t ones = ~std::uint64_t(0) >> (kWordBits - (end - first));
        words[first / kWordBits] |= ones << (first % kWordBits);
        first = end;
    }
}

struct Welded {
    PositionTable table;
    std::vector<WeldedTriangle> triangles;
};

Result<Welded> weld(const MeshView& mesh)
{
    Welded welded;
    Result<std::vector<WeldedTriangle>> triangles = weldTriangles(mesh, welded.table);
    if (!triangles)
        return triangles.error();
    welded.triangles = std::move(triangles).value();
    for (const WeldedTriangle& triangle : welded.triangles)
        for (std::size_t corner = 0; corner < 3; ++corner)
            for (const float component : welded.table.positions()[triangle.position[corner]])
                if (std::abs(component) > kFarthest) {
                    Error error{ErrorCode::InvalidGeometry, "a vertex position is beyond 1e18"};
                    error.subMesh = static_cast<int>(triangle.subMesh);
                    error.item = triangle.vertex[corner];
                    return error;
                }
    return welded;
}

std::array<double, 3> centreOf(const std::vector<Position>& positions)
{
    std::array<double, 3> centre = {0.0, 0.0, 0.0};
    for (std::size_t axis = 0; axis < 3 && !positions.empty(); ++axis) {
        const auto [low, high] =
            std::minmax_element(positions.begin(), positions.end(),
                                [axis](const Position& a, const Position& b) { return a[axis] < b[axis]; });
        centre[axis] = (double((*low)[axis]) + double((*high)[axis])) / 2.0;
    }
    return centre;
}

double radiusAround(const std::array<double, 3>& centre, const std::vector<Position>& positions)
{
    double radius = 0.0;
    for (const Position& position : positions) {
        double square = 0.0;
        for (std::size_t axis = 0; axis < 3; ++axis)
            square += (double(position[axis]) - centre[axis]) * (double(position[axis]) - centre[axis]);
        radius = std::max(radius, square);
    }
    return std::sqrt(radius);
}

Result<std::vector<std::uint64_t>> draw(const MeshView& mesh, const SilhouetteFrame& frame)
{
    const Result<Welded> welded = weld(mesh);
    if (!welded)
        return welded.error();
    std::vector<SilhouettePoint> points;
    points.reserve(welded.value().table.size());
    for (const Position& position : welded.value().table.positions())
        points.push_back(analysis::project(frame, {position[0], position[1], position[2]}));
    std::vector<std::uint64_t> pictures(frame.pixels() / kWordBits, 0);
    for (const WeldedTriangle& triangle : welded.value().triangles)
        analysis::forEachRun(frame,
                             {points[triangle.position[0]], points[triangle.position[1]], points[triangle.position[2]]},
                             [&](std::size_t first, std::size_t last) { setBits(pictures, first, last); });
    return pictures;
}

template <class Work>
auto guarded(Work&& work) -> decltype(work())
{
    try {
        return work();
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::OutOfMemory, "there is not enough memory to draw the mesh"};
    }
}

} // namespace

Result<CoverageMeter> CoverageMeter::of(const MeshView& original, unsigned pixels)
{
    LODSMITH_ASSERT(pixels >= kMinPixels && pixels <= kMaxPixels, "a CoverageMeter has 8 to 4096 pixels");
    return guarded([&]() -> Result<CoverageMeter> {
        const Result<Welded> welded = weld(original);
        if (!welded)
            return welded.error();
        CoverageMeter meter;
        const std::vector<Position>& positions = welded.value().table.positions();
        meter.mCentre = centreOf(positions);
        const double radius = radiusAround(meter.mCentre, positions);
        meter.mPixelsPerUnit = radius > 0.0 ? double(pixels) / (2.0 * radius) : 0.0;
        meter.mSide = (pixels + pixels / 4 + 7) / 8 * 8; // a picture is a whole number of words
        Result<std::vector<std::uint64_t>> pictures =
            draw(original, {meter.mCentre, meter.mPixelsPerUnit, meter.mSide});
        if (!pictures)
            return pictures.error();
        meter.mOriginal = std::move(pictures).value();
        return meter;
    });
}

Result<Coverage> CoverageMeter::measure(const MeshView& level) const
{
    return guarded([&]() -> Result<Coverage> {
        const Result<std::vector<std::uint64_t>> pictures = draw(level, {mCentre, mPixelsPerUnit, mSide});
        if (!pictures)
            return pictures.error();
        Coverage coverage{0.0, 0.0, 1.0};
        for (std::size_t i = 0; i < analysis::kSilhouetteDirections; ++i) {
            const Counts counts = compare(mOriginal, pictures.value(), i * mSide * mSide / kWordBits,
                                          (i + 1) * mSide * mSide / kWordBits);
            const double kept = counts.original > 0.0 ? counts.kept / counts.original : 1.0;
            coverage.kept += kept / double(analysis::kSilhouetteDirections);
            coverage.gained +=
                counts.original > 0.0 ? counts.gained / counts.original / double(analysis::kSilhouetteDirections) : 0.0;
            coverage.leastKept = std::min(coverage.leastKept, kept);
        }
        return coverage;
    });
}

} // namespace lodsmith
