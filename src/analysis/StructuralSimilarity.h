#pragma once

#include <cstddef>
#include <vector>

namespace lodsmith {

/// Brightness of each pixel, 0..255, rows from the top.
struct Luminance {
    std::size_t width = 0;
    std::size_t height = 0;
    std::vector<double> values;
};

/// Structural similarity around each pixel, -1..1, of two pictures of one size; ImageDifference::ssim says how.
std::vector<double> structuralSimilarity(const Luminance& a, const Luminance& b);

} // namespace lodsmith
