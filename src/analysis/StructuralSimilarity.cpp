#include "StructuralSimilarity.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lodsmith {

namespace {

constexpr std::size_t kReach = 5; // of the window, beyond its middle
constexpr double kSigma = 1.5;
constexpr double kSmallMean = (0.01 * 255) * (0.01 * 255);
constexpr double kSmallVariance = (0.03 * 255) * (0.03 * 255);

using Kernel = std::array<double, 2 * kReach + 1>;

Kernel makeKernel()
{
    Kernel kernel;
    for (std::size_t i = 0; i < kernel.size(); ++i) {
        const double off = static_cast<double>(i) - static_cast<double>(kReach);
        kernel[i] = std::exp(-off * off / (2 * kSigma * kSigma));
    }
    return kernel;
}

/// Weighted means over windows, first along rows, then along columns. What is outside the picture has no weight.
class WindowMean {
public:
    WindowMean(std::size_t width, std::size_t height)
        : mWidth(width), mHeight(height), mAcross(weightsOf(width)), mDown(weightsOf(height))
    {
    }

    std::vector<double> of(const std::vector<double>& values) const
    {
        std::vector<double> rows(values.size()), result(values.size());
        for (std::size_t y = 0; y < mHeight; ++y)
            for (std::size_t x = 0; x < mWidth; ++x)
                for (std::size_t from = first(x), i = from; i <= last(x, mWidth); ++i)
                    rows[y * mWidth + x] += mKernel[i + kReach - x] * mAcross[x] * values[y * mWidth + i];
        for (std::size_t y = 0; y < mHeight; ++y)
            for (std::size_t i = first(y); i <= last(y, mHeight); ++i) {
                const double weight = mKernel[i + kReach - y] * mDown[y];
                for (std::size_t x = 0; x < mWidth; ++x)
                    result[y * mWidth + x] += weight * rows[i * mWidth + x];
            }
        return result;
    }

private:
    static std::size_t first(std::size_t middle) { return middle - std::min(middle, kReach); }
    static std::size_t last(std::size_t middle, std::size_t count) { return std::min(middle + kReach, count - 1); }

    /// For each place along an axis one over the sum of the window's weights.
    std::vector<double> weightsOf(std::size_t count) const
    {
        std::vector<double> weights(count);
        for (std::size_t middle = 0; middle < count; ++middle) {
            double sum = 0;
            for (std::size_t i = first(middle); i <= last(middle, count); ++i)
                sum += mKernel[i + kReach - middle];
            weights[middle] = 1 / sum;
        }
        return weights;
    }

    Kernel mKernel = makeKernel();
    std::size_t mWidth;
    std::size_t mHeight;
    std::vector<double> mAcross;
    std::vector<double> mDown;
};

std::vector<double> product(const std::vector<double>& a, const std::vector<double>& b)
{
    std::vector<double> result(a.size());
    for (std::size_t i = 0; i < a.size(); ++i)
        result[i] = a[i] * b[i];
    return result;
}

} // namespace

std::vector<double> structuralSimilarity(const Luminance& a, const Luminance& b)
{
    const WindowMean mean(a.width, a.height);
    const std::vector<double> meanA = mean.of(a.values), meanB = mean.of(b.values);
    const std::vector<double> squareA = mean.of(product(a.values, a.values));
    const std::vector<double> squareB = mean.of(product(b.values, b.values));
    const std::vector<double> mixed = mean.of(product(a.values, b.values));
    std::vector<double> similarity(a.values.size());
    for (std::size_t i = 0; i < similarity.size(); ++i) {
        const double meanProduct = meanA[i] * meanB[i], meanSquares = meanA[i] * meanA[i] + meanB[i] * meanB[i];
        const double variances = squareA[i] + squareB[i] - meanSquares, covariance = mixed[i] - meanProduct;
        similarity[i] = (2 * meanProduct + kSmallMean) * (2 * covariance + kSmallVariance)
                        / ((meanSquares + kSmallMean) * (variances + kSmallVariance));
    }
    return similarity;
}

} // namespace lodsmith
