#pragma once

#include "ComparisonProgress.h"
#include "SurfaceIndex.h"
#include "SurfaceSampling.h"

#include <lodsmith/analysis/Deviation.h>

#include <cstdint>
#include <vector>

namespace lodsmith::analysis {

/// Sums up one quantity over the samples of one surface.
class FigureSums {
public:
    void add(double value);
    /// For samples that stand for no area.
    void addExtreme(double value);
    /// The figures of two surfaces together, each counting half; one that has no sample leaves it to the other.
    static DeviationFigures combine(const FigureSums& a, const FigureSums& b);

private:
    DeviationFigures figures() const;

    double mSum = 0.0, mSquares = 0.0, mMaximum = 0.0;
    std::uint64_t mCount = 0;
};

/// What the samples of one surface say about another.
struct SurfaceComparison {
    FigureSums distance; ///< local frame
    FigureSums normal;   ///< radians
    FigureSums uv;
};

/// Measures samples of one surface against another. Both surfaces need a triangle and live in one LocalFrame.
/// Takes one step of `progress` a sample. Errors: Cancelled.
Result<SurfaceComparison> compareSurfaces(const Surface& from, const SurfaceIndex& to,
                                          const std::vector<SurfaceSample>& area,
                                          const std::vector<SurfaceSample>& vertices, ComparisonProgress& progress);

/// The distances alone.
Result<FigureSums> compareDistances(const Surface& from, const SurfaceIndex& to, const std::vector<SurfaceSample>& area,
                                    const std::vector<SurfaceSample>& vertices, ComparisonProgress& progress);

} // namespace lodsmith::analysis
