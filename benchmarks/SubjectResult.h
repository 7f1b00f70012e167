#pragma once

#include "Quality.h"
#include "Timing.h"

#include <cstdint>
#include <map>
#include <string>

namespace lodsmith::benchmarks {

/// Everything that was measured on one mesh; what was not asked for is empty.
struct SubjectResult {
    std::string name;
    std::uint32_t triangles = 0;
    std::uint32_t vertices = 0; ///< welded
    double radius = 0.0;        ///< world units
    bool hasNormals = false;
    bool hasUvs = false;
    Timings seconds;
    std::map<std::string, long> peakKb;
    MeasuredChains chains;     ///< at halvings(), targets in vertices
    MeasuredChains comparable; ///< at OGRE's triangle counts, targets in triangles
};

} // namespace lodsmith::benchmarks
