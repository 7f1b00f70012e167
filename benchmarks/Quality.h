#pragma once

#include "Peer.h"

#include <lodsmith/analysis/Deviation.h>

#include <optional>
#include <string>
#include <vector>

namespace lodsmith::benchmarks {

/// A level, counted and measured against the original.
struct MeasuredLevel {
    std::uint32_t triangles = 0;
    std::uint32_t vertices = 0; ///< welded
    std::string stop;
    std::optional<Deviation> deviation; ///< none for a level without triangles
};

/// Where there are thousands of levels: all vertices are measured besides, so that a fifth of the usual samples is enough.
inline constexpr DeviationOptions kFewSamples{20000};

/// Measures levels of a subject. Throws std::runtime_error where that is not possible.
std::vector<MeasuredLevel> measureLevels(const Subject& subject, const std::vector<PeerLevel>& levels,
                                         const DeviationOptions& options);

/// The largest deviation of a level that appears at a pixel_count, in pixels; NaN where either is not known.
double visiblePixels(const Subject& subject, double pixels, const MeasuredLevel& level);

/// True when a level came within 2% (or two triangles) of a number of triangles: only such levels are compared.
bool reached(const MeasuredLevel& level, std::uint32_t triangles);

} // namespace lodsmith::benchmarks
