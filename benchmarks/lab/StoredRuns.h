#pragma once

#include "Database.h"

#include <array>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

namespace lodsmith::benchmarks {

/// The figures of a level that are compared: of each, less is better.
enum class LevelFigure {
    Triangles,
    Vertices,
    Bytes,
    SurfaceMean,
    SurfaceRms,
    SurfaceMaximum,
    NormalMean,
    NormalRms,
    NormalMaximum,
    UvMean,
    UvRms,
    UvMaximum,
    VisiblePixels,
    NewBorderEdges,
    NewNonManifoldEdges,
    FlippedTriangles,
    RepeatedTriangles,
    DegenerateTriangles,
};
inline constexpr std::size_t kLevelFigures = 18;

/// One figure each, NaN where it is not known.
using LevelFigures = std::array<double, kLevelFigures>;

/// Words for a figure.
const char* nameOf(LevelFigure figure);

/// A run as it is in the database.
struct StoredRun {
    double meshRadius = 0.0;       ///< world units
    std::vector<double> processor; ///< seconds of each round, processor time; empty when not known
    std::vector<double> reference; ///< those of the reference just before each; empty when not known
    std::optional<double> peakKb;
    bool failed = false;
    std::map<int, LevelFigures> levels; ///< by number
};

/// What makes two runs comparable.
struct RunKey {
    std::string configuration;
    std::string generator;
    std::string mesh;
    std::string meshHash;
    std::string rule;
    long long samples = 0;
};
inline bool operator<(const RunKey& a, const RunKey& b)
{
    const auto tied = [](const RunKey& key) {
        return std::tie(key.configuration, key.generator, key.mesh, key.meshHash, key.rule, key.samples);
    };
    return tied(a) < tied(b);
}

using StoredRuns = std::map<RunKey, StoredRun>;

/// The newest runs of a label on a machine, as the view `result` has them.
StoredRuns readRuns(Database& database, const std::string& label, const std::string& machine);

} // namespace lodsmith::benchmarks
