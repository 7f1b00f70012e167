#pragma once

#include <lodsmith/core/Export.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace lodsmith {

/// Red, green, blue, alpha.
using Rgba = std::array<std::uint8_t, 4>;

/// A picture in memory that is painted pixel by pixel: rows from the top, 4 bytes a pixel. Pixel (x, y) covers x..x+1 and y..y+1,
/// so that its centre is at (x + 0.5, y + 0.5). What is beyond the edges is left out.
class LODSMITH_API Canvas {
public:
    /// Filled with transparent black.
    Canvas(unsigned width, unsigned height);

    unsigned width() const { return mWidth; }
    unsigned height() const { return mHeight; }
    const std::uint8_t* data() const { return mPixels.front().data(); }
    Rgba pixel(unsigned x, unsigned y) const { return mPixels[std::size_t(y) * mWidth + x]; }

    void fill(const Rgba& colour);
    /// A line with round ends, `thickness` pixels, smoothed. Nothing for coordinates that are no numbers.
    void line(float fromX, float fromY, float toX, float toY, float thickness, const Rgba& colour);
    /// A filled circle, smoothed.
    void disc(float x, float y, float radius, const Rgba& colour) { line(x, y, x, y, 2 * radius, colour); }

private:
    void blend(unsigned x, unsigned y, float coverage, const Rgba& colour);

    unsigned mWidth;
    unsigned mHeight;
    std::vector<Rgba> mPixels;
};

} // namespace lodsmith
