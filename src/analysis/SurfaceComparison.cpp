#include "SurfaceComparison.h"

#include "AttributeMatch.h"

#include <algorithm>
#include <cmath>

namespace lodsmith::analysis {

namespace {

using Add = void (FigureSums::*)(double);

/// Measures one sample after the other. False when the work was cancelled.
template <class Measure>
bool measureAll(const std::vector<SurfaceSample>& area, const std::vector<SurfaceSample>& vertices,
                ComparisonProgress& progress, Measure measure)
{
    const auto measureEach = [&](const std::vector<SurfaceSample>& samples, Add add) {
        return std::all_of(samples.begin(), samples.end(), [&](const SurfaceSample& sample) {
            if (!progress.step())
                return false;
            measure(sample, add);
            return true;
        });
    };
    return measureEach(area, &FigureSums::add) && measureEach(vertices, &FigureSums::addExtreme);
}

class Comparison {
public:
    Comparison(const Surface& from, const SurfaceIndex& to)
        : mFrom(from), mTo(to), mPaired(from.mesh().subMeshes.size() == to.surface().mesh().subMeshes.size())
    {
    }

    double measureDistance(const SurfaceSample& sample, Add add)
    {
        const Vec3 point = pointAt(mFrom.corners(sample.triangle), sample.weights);
        const ClosestHit hit = mTo.closest(point, mGuess);
        mGuess = hit.triangle;
        const double distance = hit.distance();
        (mResult.distance.*add)(distance);
        return distance;
    }

    void measure(const SurfaceSample& sample, Add add)
    {
        const AttributeDifference difference = compareAttributes(sample, measureDistance(sample, add));
        if (difference.normal)
            (mResult.normal.*add)(*difference.normal);
        if (difference.uv)
            (mResult.uv.*add)(*difference.uv);
    }

    const SurfaceComparison& result() const { return mResult; }

private:
    AttributeDifference compareAttributes(const SurfaceSample& sample, double distance) const
    {
        if (!mPaired)
            return matchAttributes(mFrom, sample, mTo, kAnySubMesh, distance);
        const std::uint32_t subMesh = mFrom.subMesh(sample.triangle);
        if (mTo.surface().draws(subMesh))
            return matchAttributes(mFrom, sample, mTo, subMesh, distance);
        AttributeDifference difference = matchAttributes(mFrom, sample, mTo, kAnySubMesh, distance);
        difference.uv.reset(); // a coordinate of another material's texture says nothing
        return difference;
    }

    const Surface& mFrom;
    const SurfaceIndex& mTo;
    const bool mPaired;
    std::uint32_t mGuess = 0;
    SurfaceComparison mResult;
};

} // namespace

void FigureSums::add(double value)
{
    mSum += value;
    mSquares += value * value;
    ++mCount;
    addExtreme(value);
}

void FigureSums::addExtreme(double value)
{
    mMaximum = std::max(mMaximum, value);
}

DeviationFigures FigureSums::figures() const
{
    const double count = static_cast<double>(std::max<std::uint64_t>(1, mCount));
    return {mSum / count, std::sqrt(mSquares / count), mMaximum};
}

DeviationFigures FigureSums::combine(const FigureSums& a, const FigureSums& b)
{
    DeviationFigures one = a.figures(), other = b.figures();
    if (a.mCount == 0)
        one = other;
    if (b.mCount == 0)
        other = one;
    return {(one.mean + other.mean) / 2.0, std::sqrt((one.rms * one.rms + other.rms * other.rms) / 2.0),
            std::max(a.mMaximum, b.mMaximum)};
}

Result<SurfaceComparison> compareSurfaces(const Surface& from, const SurfaceIndex& to,
                                          const std::vector<SurfaceSample>& area,
                                          const std::vector<SurfaceSample>& vertices, ComparisonProgress& progress)
{
    Comparison comparison(from, to);
    if (!measureAll(area, vertices, progress,
                    [&](const SurfaceSample& sample, Add add) { comparison.measure(sample, add); }))
        return ComparisonProgress::cancelled();
    return comparison.result();
}

Result<FigureSums> compareDistances(const Surface& from, const SurfaceIndex& to, const std::vector<SurfaceSample>& area,
                                    const std::vector<SurfaceSample>& vertices, ComparisonProgress& progress)
{
    Comparison comparison(from, to);
    if (!measureAll(area, vertices, progress,
                    [&](const SurfaceSample& sample, Add add) { comparison.measureDistance(sample, add); }))
        return ComparisonProgress::cancelled();
    return comparison.result().distance;
}

} // namespace lodsmith::analysis
