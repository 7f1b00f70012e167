#include "DistanceTransform.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lodsmith {

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// The lower envelope of parabolas, one over each sample of a row: its heights are the squared distances.
class RowTransform {
public:
    explicit RowTransform(std::size_t longest) : mCentre(longest), mFrom(longest + 1), mInput(longest) {}

    /// Squared distances in, along the other axis; out: along both. `step` is from one sample of the row to the next.
    void run(double* samples, std::size_t count, std::size_t step)
    {
        for (std::size_t i = 0; i < count; ++i)
            mInput[i] = samples[i * step];
        const std::size_t parabolas = buildEnvelope(count);
        if (parabolas == 0)
            return;
        for (std::size_t i = 0, k = 0; i < count; ++i) {
            while (k + 1 < parabolas && mFrom[k + 1] < static_cast<double>(i))
                ++k;
            const double off = static_cast<double>(i) - static_cast<double>(mCentre[k]);
            samples[i * step] = off * off + mInput[mCentre[k]];
        }
    }

private:
    std::size_t buildEnvelope(std::size_t count)
    {
        std::size_t parabolas = 0;
        for (std::size_t i = 0; i < count; ++i) {
            if (mInput[i] == kInfinite)
                continue;
            while (parabolas > 0 && meeting(mCentre[parabolas - 1], i) <= mFrom[parabolas - 1])
                --parabolas;
            mFrom[parabolas] = parabolas == 0 ? -kInfinite : meeting(mCentre[parabolas - 1], i);
            mCentre[parabolas++] = i;
        }
        return parabolas;
    }

    /// Where the parabola over `right` comes below that over `left`.
    double meeting(std::size_t left, std::size_t right) const
    {
        const auto a = static_cast<double>(left), b = static_cast<double>(right);
        return (mInput[right] + b * b - mInput[left] - a * a) / (2 * (b - a));
    }

    std::vector<std::size_t> mCentre; ///< of the envelope's parabolas, from the left
    std::vector<double> mFrom;        ///< where each begins
    std::vector<double> mInput;
};

} // namespace

std::vector<double> distancesToMarked(const std::vector<bool>& marked, std::size_t width, std::size_t height)
{
    std::vector<double> distances(marked.size());
    for (std::size_t i = 0; i < marked.size(); ++i)
        distances[i] = marked[i] ? 0.0 : kInfinite;
    RowTransform transform(std::max(width, height));
    for (std::size_t x = 0; x < width; ++x)
        transform.run(distances.data() + x, height, width);
    for (std::size_t y = 0; y < height; ++y)
        transform.run(distances.data() + y * width, width, 1);
    for (double& distance : distances)
        distance = std::sqrt(distance);
    return distances;
}

} // namespace lodsmith
