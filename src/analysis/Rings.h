#pragma once

#include <lodsmith/analysis/StreamingCost.h>

#include <algorithm>
#include <cmath>

namespace lodsmith {

/// Square metres of the disc within a distance in metres, which may be infinite.
inline double areaWithin(double distance, const StreamingCostSettings& settings)
{
    constexpr double kPi = 3.14159265358979323846;
    const double nearer = std::min(distance, settings.largestDistance);
    return std::min(kPi * nearer * nearer, settings.largestArea);
}

/// Square metres between two distances; an infinite `outer` is the edge of the disc.
inline double areaBetween(double inner, double outer, const StreamingCostSettings& settings)
{
    const double whole = std::isinf(outer) ? settings.largestArea : areaWithin(outer, settings);
    return whole - areaWithin(inner, settings);
}

/// What a level counts that is drawn between them.
inline double ringArea(double inner, double outer, const StreamingCostSettings& settings)
{
    return std::clamp(areaBetween(inner, outer, settings), settings.smallestArea, settings.largestArea);
}

/// What a level's bytes count as.
inline double countedTriangles(double bytes, const StreamingCostSettings& settings)
{
    return std::max(bytes - settings.metadataDiscount, settings.minimumBytes) / settings.bytesPerTriangle;
}

} // namespace lodsmith
