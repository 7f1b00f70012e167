#pragma once

#include "../Quality.h"

#include <cstdint>
#include <string>
#include <vector>

namespace lodsmith::benchmarks {

/// Where something was measured.
struct Machine {
    std::string cpu;
    unsigned cores = 0;
    double memoryGib = 0.0; ///< to a tenth
    std::string kernel;
};

/// What was measured.
struct Build {
    std::string label;    ///< what comparisons call it
    std::string version;  ///< of the library
    std::string revision; ///< of the sources; empty when not known
    std::string compiler;
    std::string buildType;
};

/// What it was measured on.
struct MeshRecord {
    std::string name;
    std::string hash; ///< of what simplify() sees, 32 hexadecimal digits
    std::uint32_t triangles = 0;
    std::uint32_t vertices = 0; ///< welded
    double radius = 0.0;        ///< world units, MeshStatistics::radius
    bool hasNormals = false;
    bool hasUvs = false;
};

/// One run of a generator.
struct Round {
    double seconds = 0.0;  ///< planning and making all levels
    double planning = 0.0; ///< seconds of them until it was decided which levels to make
    /// Processor seconds of all of it, and of everything else that belongs to it, such as the order for the vertex cache: what
    /// other programs do at the same time hardly counts.
    double processor = 0.0;
    /// Processor seconds of a work that is the same for every generator and every build, just before: how fast the machine
    /// was. NaN where times are of no interest.
    double reference = 0.0;
};

/// One level as it was asked for and as it came out.
struct LevelRecord {
    LevelTarget target;
    double pixels = 0.0; ///< pixel_count at which it appears; 0 where nobody has said
    MeasuredLevel measured;
    std::uint64_t bytes = 0; ///< of its index buffers, as wide as the mesh's own
    bool skipped = false;    ///< the same triangles as the level before
    /// The greatest deviation when the level appears, pixels; NaN where that is not known.
    double visiblePixels = 0.0;
};

/// What one generator made of one mesh under one configuration.
struct RunRecord {
    std::string generator;
    std::vector<Round> rounds;
    std::vector<LevelRecord> levels;
    std::optional<long> peakKb; ///< how far memory rose meanwhile
    std::string error;          ///< why there is nothing; empty when there is
};

/// The word for a kind of target in the database.
const char* toString(LevelTarget::Kind kind);

} // namespace lodsmith::benchmarks
