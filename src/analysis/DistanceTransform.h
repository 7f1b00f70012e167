#pragma once

#include <cstddef>
#include <vector>

namespace lodsmith {

/// For each pixel of a picture the distance to the nearest marked one, in pixels; infinite without any. Exact
/// (Felzenszwalb and Huttenlocher 2012, "Distance transforms of sampled functions"), in time proportional to the number
/// of pixels.
///
/// @param marked one number a pixel, rows from the top
std::vector<double> distancesToMarked(const std::vector<bool>& marked, std::size_t width, std::size_t height);

} // namespace lodsmith
