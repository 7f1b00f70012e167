#include "Figure.h"

#include <algorithm>

namespace lodsmith::benchmarks {

namespace {

double floorOf(Figure figure, double radius)
{
    switch (figure) {
    case Figure::MeanSurface:
    case Figure::MaximumSurface: return 1e-6 * radius;
    case Figure::MeanNormal: return 1e-4;
    case Figure::MeanUv: return 1e-5;
    }
    return 0.0;
}

double figureOf(const Deviation& deviation, Figure figure)
{
    switch (figure) {
    case Figure::MeanSurface: return deviation.surface.mean;
    case Figure::MaximumSurface: return deviation.surface.maximum;
    case Figure::MeanNormal: return deviation.normal.mean;
    case Figure::MeanUv: return deviation.uv.mean;
    }
    return 0.0;
}

} // namespace

double figureRatio(const Deviation& ours, const Deviation& theirs, Figure figure, double radius)
{
    const double least = floorOf(figure, radius);
    return std::max(least, figureOf(ours, figure)) / std::max(least, figureOf(theirs, figure));
}

} // namespace lodsmith::benchmarks
