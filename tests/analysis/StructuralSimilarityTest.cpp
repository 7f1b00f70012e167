#include "StructuralSimilarity.h"

#include <support/MeshBuilders.h>

#include <gtest/gtest.h>

#include <cmath>

namespace lodsmith {
namespace {

// The paper's constants for 8 bits.
constexpr double kC1 = 2.55 * 2.55;
constexpr double kC2 = 7.65 * 7.65;

Luminance flat(std::size_t width, std::size_t height, double value)
{
    return {width, height, std::vector<double>(width * height, value)};
}

Luminance noise(std::size_t width, std::size_t height, std::uint32_t seed)
{
    test::TestRandom random(seed);
    Luminance result = flat(width, height, 0);
    for (double& value : result.values)
        value = std::floor(random.uniform(0, 256));
    return result;
}

/// The paper's equation 13 around one pixel, window by window.
double similarityAt(const Luminance& a, const Luminance& b, int x, int y)
{
    double weights = 0, meanA = 0, meanB = 0, squareA = 0, squareB = 0, mixed = 0;
    for (int dy = -5; dy <= 5; ++dy)
        for (int dx = -5; dx <= 5; ++dx) {
            const int column = x + dx, row = y + dy;
            if (column < 0 || row < 0 || column >= int(a.width) || row >= int(a.height))
                continue;
            const double weight = std::exp(-(dx * dx + dy * dy) / (2 * 1.5 * 1.5));
            const double p = a.values[std::size_t(row) * a.width + std::size_t(column)];
            const double q = b.values[std::size_t(row) * a.width + std::size_t(column)];
            weights += weight;
            meanA += weight * p;
            meanB += weight * q;
            squareA += weight * p * p;
            squareB += weight * q * q;
            mixed += weight * p * q;
        }
    meanA /= weights;
    meanB /= weights;
    const double varianceA = squareA / weights - meanA * meanA, varianceB = squareB / weights - meanB * meanB;
    const double covariance = mixed / weights - meanA * meanB;
    return (2 * meanA * meanB + kC1) * (2 * covariance + kC2)
           / ((meanA * meanA + meanB * meanB + kC1) * (varianceA + varianceB + kC2));
}

TEST(StructuralSimilarity, OfEvenPicturesIsThatOfTheirBrightness)
{
    const std::vector<double> similarity = structuralSimilarity(flat(20, 15, 100), flat(20, 15, 150));
    for (const double value : similarity)
        EXPECT_NEAR(value, (2 * 100 * 150 + kC1) / (100 * 100 + 150 * 150 + kC1), 1e-9);
}

TEST(StructuralSimilarity, OfAPictureWithItsNegativeIsBelowZero)
{
    Luminance picture = noise(24, 24, 1), negative = picture;
    for (double& value : negative.values)
        value = 255 - value;
    for (const double value : structuralSimilarity(picture, negative))
        EXPECT_LT(value, 0);
}

TEST(StructuralSimilarity, IsThePapersAroundEachPixel)
{
    for (const auto& [width, height] : {std::pair<std::size_t, std::size_t>{23, 19}, {7, 30}, {1, 1}}) {
        const Luminance a = noise(width, height, 2);
        Luminance b = noise(width, height, 3);
        for (std::size_t i = 0; i < b.values.size(); ++i)
            b.values[i] = 0.7 * a.values[i] + 0.3 * b.values[i];
        const std::vector<double> similarity = structuralSimilarity(a, b);
        for (std::size_t i = 0; i < similarity.size(); ++i)
            ASSERT_NEAR(similarity[i], similarityAt(a, b, int(i % width), int(i / width)), 1e-9) << i;
    }
}

TEST(StructuralSimilarity, OfTheSameIsOne)
{
    const Luminance picture = noise(30, 20, 4);
    for (const double value : structuralSimilarity(picture, picture))
        EXPECT_DOUBLE_EQ(value, 1);
}

} // namespace
} // namespace lodsmith
