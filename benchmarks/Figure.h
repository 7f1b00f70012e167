#pragma once

#include <lodsmith/analysis/Deviation.h>

namespace lodsmith::benchmarks {

/// Which figure of a deviation is compared.
enum class Figure { MeanSurface, MaximumSurface, MeanNormal, MeanUv };

/// The figure of one level over that of another, with a floor under both: differences below the rounding of stored
/// floats are no differences, and a level without any error still has a ratio.
/// @param radius  of the original, world units
double figureRatio(const Deviation& ours, const Deviation& theirs, Figure figure, double radius);

} // namespace lodsmith::benchmarks
