#include <lodsmith/analysis/ImageDifference.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace lodsmith {
namespace {

constexpr double kTiny = 1e-9;

using Rgba = std::array<std::uint8_t, 4>;

constexpr Rgba kRed = {200, 0, 0, 255};

/// Paints the rectangle from (left, top) on.
void paint(Image& image, std::size_t left, std::size_t top, std::size_t width, std::size_t height, const Rgba& colour)
{
    for (std::size_t y = top; y < top + height; ++y)
        for (std::size_t x = left; x < left + width; ++x)
            std::copy(colour.begin(), colour.end(), image.pixel(x, y));
}

Image rectangle(std::size_t left, std::size_t top, std::size_t width, std::size_t height, const Rgba& colour = kRed)
{
    Image image = Image::empty(40, 30);
    paint(image, left, top, width, height, colour);
    return image;
}

TEST(ImageDifference, OfAPictureFromItselfIsNone)
{
    const Image image = rectangle(3, 4, 20, 10);
    const ImageDifference difference = compareImages(image, image);
    EXPECT_EQ(difference.largest, 0);
    EXPECT_EQ(difference.mean, 0);
    EXPECT_EQ(difference.ssim, 1);
    EXPECT_EQ(difference.coverage, 1);
    EXPECT_EQ(difference.silhouette.pixels, 0u);
    EXPECT_EQ(difference.silhouette.share, 0);
    EXPECT_EQ(difference.silhouette.distance, 0);
}

TEST(ImageDifference, IsThatOfChannelsOverCoveredPixels)
{
    const Image original = rectangle(10, 10, 5, 4);
    Image other = original;
    paint(other, 12, 11, 1, 1, {190, 60, 0, 255});
    const ImageDifference difference = compareImages(original, other);
    EXPECT_EQ(difference.largest, 60);
    EXPECT_NEAR(difference.mean, 70.0 / (3 * 20), kTiny);
    EXPECT_LT(difference.ssim, 1);
    EXPECT_EQ(difference.coverage, 1);
    EXPECT_EQ(difference.silhouette.pixels, 0u);
}

TEST(ImageDifference, SeesColoursBeforeAGreyWall)
{
    // A black pixel less is 128 in each channel, a grey one like the wall nothing.
    const Image nothing = Image::empty(40, 30);
    const ImageDifference black = compareImages(rectangle(10, 10, 2, 2, {0, 0, 0, 255}), nothing);
    EXPECT_EQ(black.largest, 128);
    EXPECT_NEAR(black.mean, 128, kTiny);
    const ImageDifference grey = compareImages(rectangle(10, 10, 2, 2, {128, 128, 128, 255}), nothing);
    EXPECT_EQ(grey.largest, 0);
    EXPECT_NEAR(grey.ssim, 1, kTiny);
    // Half covered by white: half of 255, and half of the wall.
    const ImageDifference half = compareImages(rectangle(10, 10, 2, 2, {128, 128, 128, 128}), nothing);
    EXPECT_EQ(half.largest, 128 + 64 - 128);
}

TEST(ImageDifference, CoverageIsASumOfShares)
{
    EXPECT_NEAR(coveredPixels(rectangle(0, 0, 4, 5, {0, 0, 0, 51})), 20 * 0.2, kTiny);
    EXPECT_NEAR(compareImages(rectangle(2, 2, 10, 10), rectangle(2, 2, 10, 9)).coverage, 0.9, kTiny);
    EXPECT_EQ(compareImages(Image::empty(40, 30), rectangle(2, 2, 3, 3)).coverage, 9);
    EXPECT_EQ(compareImages(rectangle(2, 2, 3, 3), Image::empty(40, 30)).coverage, 0);
}

TEST(SilhouetteDifference, OfAShiftIsTheShift)
{
    const SilhouetteDifference difference = compareSilhouettes(rectangle(5, 5, 10, 8), rectangle(8, 5, 10, 8));
    EXPECT_EQ(difference.pixels, 2u * 3 * 8);
    EXPECT_NEAR(difference.share, 48.0 / 80, kTiny);
    EXPECT_NEAR(difference.distance, 3, kTiny);
}

TEST(SilhouetteDifference, OfAFrameAroundIsFarthestAtTheCorners)
{
    const Image small = rectangle(10, 10, 8, 8), large = rectangle(8, 8, 12, 12);
    const SilhouetteDifference difference = compareSilhouettes(small, large);
    EXPECT_EQ(difference.pixels, 12u * 12 - 8 * 8);
    EXPECT_NEAR(difference.share, 80.0 / 64, kTiny);
    EXPECT_NEAR(difference.distance, std::sqrt(8.0), kTiny);
    const SilhouetteDifference turned = compareSilhouettes(large, small);
    EXPECT_EQ(turned.pixels, difference.pixels);
    EXPECT_NEAR(turned.share, 80.0 / 144, kTiny);
    EXPECT_EQ(turned.distance, difference.distance);
}

TEST(SilhouetteDifference, SeesHoles)
{
    // The rim of a hole is an outline: its pixels beside the hole are 4 and more from the edge.
    Image holed = rectangle(5, 5, 11, 11);
    paint(holed, 10, 10, 1, 1, {0, 0, 0, 0});
    const SilhouetteDifference difference = compareSilhouettes(rectangle(5, 5, 11, 11), holed);
    EXPECT_EQ(difference.pixels, 1u);
    EXPECT_NEAR(difference.distance, 4, kTiny);
}

TEST(SilhouetteDifference, CountsPixelsThatAreHalfCovered)
{
    const Image half = rectangle(5, 5, 4, 4, {64, 0, 0, 128}), less = rectangle(5, 5, 4, 4, {64, 0, 0, 127});
    EXPECT_EQ(compareSilhouettes(rectangle(5, 5, 4, 4), half).pixels, 0u);
    EXPECT_EQ(compareSilhouettes(rectangle(5, 5, 4, 4), less).pixels, 16u);
}

TEST(SilhouetteDifference, FromNothingIsThePicturesDiagonal)
{
    const Image nothing = Image::empty(40, 30), something = rectangle(5, 5, 4, 4);
    EXPECT_NEAR(compareSilhouettes(nothing, something).distance, 50, kTiny);
    EXPECT_NEAR(compareSilhouettes(nothing, something).share, 16, kTiny);
    EXPECT_NEAR(compareSilhouettes(something, nothing).share, 1, kTiny);
    EXPECT_EQ(compareSilhouettes(nothing, nothing).distance, 0);
}

} // namespace
} // namespace lodsmith
