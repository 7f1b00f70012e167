#include "SurfaceComparison.h"

#include "AttributeMatch.h"

#include <algorithm>
#include <cmath>

namespace lodsmith::analysis {

namespace {

class Comparison {
public:
    Comparison(const Surface& from, const SurfaceIndex& to)
        : mFrom(from), mTo(to), mPaired(from.mesh().subMeshes.size() == to.surface().mesh().subMeshes.size())
    {
    }

    void measure(const SurfaceSample& sample, void (FigureSums::*add)(double))
    {
        const Vec3 point = pointAt(mFrom.corners(sample.triangle), sample.weights);
        const ClosestHit hit = mTo.closest(point, mGuess);
        mGuess = hit.triangle;
        const double distance = hit.distance();
        (mResult.distance.*add)(distance);

        const AttributeDifference difference = compareAttributes(sample, distance);
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
    const auto measureAll = [&](const std::vector<SurfaceSample>& samples, void (FigureSums::*add)(double)) {
        return std::all_of(samples.begin(), samples.end(), [&](const SurfaceSample& sample) {
            if (!progress.step())
                return false;
            comparison.measure(sample, add);
            return true;
        });
    };
    if (!measureAll(area, &FigureSums::add) || !measureAll(vertices, &FigureSums::addExtreme))
        return ComparisonProgress::cancelled();
    return comparison.result();
}

} // namespace lodsmith::analysis
