#include <lodsmith/analysis/ImageDifference.h>

#include "DistanceTransform.h"
#include "StructuralSimilarity.h"

#include <lodsmith/core/Assert.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace lodsmith {

namespace {

constexpr int kWall = 128;
constexpr std::uint8_t kInSilhouette = 128;

void assertSameSize(const Image& a, const Image& b)
{
    LODSMITH_ASSERT(a.width == b.width && a.height == b.height, "pictures of one size are compared");
    LODSMITH_ASSERT(a.rgba.size() == 4 * a.pixels() && b.rgba.size() == a.rgba.size(),
                    "pictures have all their pixels");
}

/// A channel as it is seen before the wall.
int seen(const std::uint8_t* pixel, int channel)
{
    return pixel[channel] + (kWall * (255 - pixel[3]) + 127) / 255;
}

Luminance luminance(const Image& image)
{
    Luminance result{image.width, image.height, std::vector<double>(image.pixels())};
    for (std::size_t i = 0; i < image.pixels(); ++i) {
        const std::uint8_t* pixel = image.rgba.data() + 4 * i;
        result.values[i] = 0.299 * seen(pixel, 0) + 0.587 * seen(pixel, 1) + 0.114 * seen(pixel, 2);
    }
    return result;
}

std::vector<bool> silhouette(const Image& image)
{
    std::vector<bool> inside(image.pixels());
    for (std::size_t i = 0; i < inside.size(); ++i)
        inside[i] = image.rgba[4 * i + 3] >= kInSilhouette;
    return inside;
}

std::vector<bool> outline(const std::vector<bool>& inside, std::size_t width, std::size_t height)
{
    std::vector<bool> edge(inside.size());
    for (std::size_t y = 0, i = 0; y < height; ++y)
        for (std::size_t x = 0; x < width; ++x, ++i)
            edge[i] = inside[i]
                      && (x == 0 || x + 1 == width || y == 0 || y + 1 == height || !inside[i - 1] || !inside[i + 1]
                          || !inside[i - width] || !inside[i + width]);
    return edge;
}

/// How far the farthest pixel of one outline is from the other.
double farthest(const std::vector<bool>& from, const std::vector<double>& distances)
{
    double result = 0;
    for (std::size_t i = 0; i < from.size(); ++i)
        if (from[i])
            result = std::max(result, distances[i]);
    return result;
}

double outlineDistance(const std::vector<bool>& a, const std::vector<bool>& b, std::size_t width, std::size_t height)
{
    const std::vector<bool> edgeA = outline(a, width, height), edgeB = outline(b, width, height);
    const double distance = std::max(farthest(edgeA, distancesToMarked(edgeB, width, height)),
                                     farthest(edgeB, distancesToMarked(edgeA, width, height)));
    return std::isfinite(distance) ? distance : std::hypot(static_cast<double>(width), static_cast<double>(height));
}

/// Differences of the colours, pixel by pixel.
void compareColours(const Image& original, const Image& other, const std::vector<double>& similarity,
                    ImageDifference& difference)
{
    double sum = 0, similaritySum = 0;
    std::size_t pixels = 0;
    for (std::size_t i = 0; i < original.pixels(); ++i) {
        const std::uint8_t *a = original.rgba.data() + 4 * i, *b = other.rgba.data() + 4 * i;
        if (a[3] == 0 && b[3] == 0)
            continue;
        ++pixels;
        similaritySum += similarity[i];
        for (int channel = 0; channel < 3; ++channel) {
            const int off = std::abs(seen(a, channel) - seen(b, channel));
            difference.largest = std::max(difference.largest, static_cast<double>(off));
            sum += off;
        }
    }
    if (pixels == 0)
        return;
    difference.mean = sum / (3.0 * static_cast<double>(pixels));
    difference.ssim = similaritySum / static_cast<double>(pixels);
}

} // namespace

double coveredPixels(const Image& image)
{
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < image.pixels(); ++i)
        sum += image.rgba[4 * i + 3];
    return static_cast<double>(sum) / 255;
}

SilhouetteDifference compareSilhouettes(const Image& original, const Image& other)
{
    assertSameSize(original, other);
    const std::vector<bool> a = silhouette(original), b = silhouette(other);
    SilhouetteDifference difference;
    std::size_t inOriginal = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        difference.pixels += a[i] != b[i] ? 1 : 0;
        inOriginal += a[i] ? 1 : 0;
    }
    if (difference.pixels == 0)
        return difference;
    difference.share =
        static_cast<double>(difference.pixels) / static_cast<double>(std::max<std::size_t>(inOriginal, 1));
    difference.distance = outlineDistance(a, b, original.width, original.height);
    return difference;
}

ImageDifference compareImages(const Image& original, const Image& other)
{
    ImageDifference difference;
    difference.silhouette = compareSilhouettes(original, other);
    if (original.rgba == other.rgba)
        return difference;
    compareColours(original, other, structuralSimilarity(luminance(original), luminance(other)), difference);
    difference.coverage = coveredPixels(other) / std::max(coveredPixels(original), 1.0);
    return difference;
}

} // namespace lodsmith
