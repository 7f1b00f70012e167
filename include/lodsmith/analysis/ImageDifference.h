#pragma once

#include <lodsmith/analysis/Image.h>
#include <lodsmith/core/Export.h>

#include <cstddef>

namespace lodsmith {

/// How the silhouettes of two pictures differ. A pixel belongs to a silhouette when at least half of it is covered
/// (alpha 128).
struct SilhouetteDifference {
    std::size_t pixels = 0; ///< in one silhouette and not in the other
    /// `pixels` as a share of the original's silhouette, of 1 pixel when that is empty. 0 and up.
    double share = 0.0;
    /// Pixels, 0 and up: how far the farthest outline pixel of either silhouette is from the nearest outline pixel of
    /// the other one (Hausdorff distance of the outlines). Outline pixels are those of the silhouette that have a
    /// neighbour left, right, above or below which is none; the picture's edge counts as one. The picture's diagonal
    /// when one silhouette is empty and the other is not; 0 when both are.
    double distance = 0.0;
};

/// How a picture differs from the original, as far as both are seen before a grey wall (128, 128, 128). Means are over
/// those pixels of which either picture covers anything.
struct ImageDifference {
    double largest = 0.0; ///< 0..255: the largest difference of red, green or blue in a pixel
    double mean = 0.0;    ///< 0..255: mean of the differences of red, green and blue
    /// -1..1, 1 for pictures that are the same: mean structural similarity of the luminance (Rec. 601), of Wang, Bovik,
    /// Sheikh and Simoncelli 2004, "Image quality assessment: from error visibility to structural similarity", with
    /// their window of 11 x 11 pixels (Gaussian, sigma 1.5) and constants (0.01 and 0.03 of 255). Unlike theirs the
    /// mean leaves out empty pixels, and windows that stick out of the picture count with the part inside.
    double ssim = 1.0;
    SilhouetteDifference silhouette;
    /// coveredPixels() as a share of the original's; of 1 pixel when that covers less, and 1 when both cover nothing. 0
    /// and up.
    double coverage = 1.0;
};

/// Pixels that are covered, partly covered ones as that part: the sum of alpha / 255.
LODSMITH_API double coveredPixels(const Image& image);

/// Compares two pictures of one size; others are misuse. Thread-safe.
LODSMITH_API SilhouetteDifference compareSilhouettes(const Image& original, const Image& other);
LODSMITH_API ImageDifference compareImages(const Image& original, const Image& other);

} // namespace lodsmith
