#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lodsmith {

/// A picture of something before nothing: 8 bits each of red, green, blue and alpha, rows from the top, no gaps. Alpha
/// is the share of the pixel that is covered, 0..255, and the colours are multiplied by it, so that none is greater
/// than alpha.
struct Image {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::vector<std::uint8_t> rgba; ///< 4 * width * height bytes

    /// Nothing, of a size.
    static Image empty(std::uint32_t width, std::uint32_t height)
    {
        return {width, height, std::vector<std::uint8_t>(std::size_t(4) * width * height)};
    }

    std::size_t pixels() const { return std::size_t(width) * height; }
    std::uint8_t* pixel(std::size_t x, std::size_t y) { return rgba.data() + 4 * (y * width + x); }
    const std::uint8_t* pixel(std::size_t x, std::size_t y) const { return rgba.data() + 4 * (y * width + x); }
};

} // namespace lodsmith
