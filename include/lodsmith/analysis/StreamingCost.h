#pragma once

#include <lodsmith/core/Export.h>
#include <lodsmith/core/Result.h>

#include <cstddef>
#include <string>
#include <vector>

namespace lodsmith {

/// The constants of the streaming cost, a published formula of the virtual world Second Life (docs/streaming-cost.md
/// names the sources): what an object with levels of detail costs to send and to draw, on average over a disc of places
/// from which it may be seen. Defaults: seedCost().
struct StreamingCostSettings {
    double metadataDiscount = 384.0;  ///< bytes of a level that are no triangles; >= 0
    double minimumBytes = 16.0;       ///< what a level counts at least, behind the discount; >= 0
    double bytesPerTriangle = 16.0;   ///< > 0
    double triangleBudget = 250000.0; ///< weighted triangles that cost `budgetCost`; > 0
    double budgetCost = 15000.0;      ///< > 0
    double largestArea = 102932.0;    ///< square metres: the disc; >= smallestArea
    double smallestArea = 1.0;        ///< square metres that every level counts at least, never seen ones too; > 0
    double largestDistance = 512.0;   ///< metres: no switch is farther away; > 0
    /// Radius over distance at which level 1, 2, 3... appears where no distances are given, falling, each > 0. Beyond
    /// the last each is half the one before. Must not be empty.
    std::vector<double> switchRatios = {0.24, 0.06, 0.03};
    bool freeWithoutLowest = false; ///< a chain whose last level is missing costs nothing
    bool chargeDuplicates = false;  ///< CostedLevel::duplicateBytes count in full, wherever their level is drawn
};

/// The formula as its authors first set it in code.
LODSMITH_API StreamingCostSettings seedCost();

/// The formula of today's viewer: a disc of radius 128 * sqrt(2) m, and nothing to pay without a lowest level.
LODSMITH_API StreamingCostSettings viewerCost();

/// The viewer's disc, no free chains, and duplicates charged: four identical levels cost four times as much as one,
/// which is what they take to send. (Otherwise they cost the same.)
LODSMITH_API StreamingCostSettings honestCost();

/// One level of a chain.
struct CostedLevel {
    double bytes = 0.0; ///< as stored; 0: missing, which counts as the bytes of the next higher level that is there
    double duplicateBytes = 0.0; ///< 0..bytes: those of them that a higher level has stored already
};

/// What one level has in the cost.
struct LevelCost {
    double distance = 0.0;  ///< metres from which on it is drawn
    double share = 0.0;     ///< 0..1: of the area from which it is seen; all shares sum to 1
    double triangles = 0.0; ///< that its bytes count as
    double cost = 0.0;      ///< its part; all parts sum to the cost
    /// d cost / d bytes: what the cost falls by for each byte that is taken away from what this level stores,
    /// duplicates first. 0 for a missing level, and for one that is down to the least that a level counts. The greatest
    /// says which to shrink first.
    double costPerByte = 0.0;
};

struct StreamingCost {
    double cost = 0.0;
    double weightedTriangles = 0.0; ///< each level's by its share, and those charged for duplicates
    double bytes = 0.0;             ///< of all levels together
    std::vector<LevelCost> levels;  ///< as many as were given
};

/// The distances at which levels 1, 2... of an object appear by the settings' ratios: radius / ratio, at most
/// largestDistance. `levels` includes level 0, so that the result has one entry fewer.
/// Errors: InvalidSetting (settings out of range, a radius that is negative or not finite, no levels).
///
/// @param radius metres: half the diagonal of the object's bounding box
LODSMITH_API Result<std::vector<double>> presetDistances(double radius, std::size_t levels,
                                                         const StreamingCostSettings& settings);

/// The cost of a chain of any length. Level i is drawn between its distance and the next level's; the area of that
/// ring, never less than smallestArea, by the sum of all is its share. A missing level 0 makes the cost 0, as
/// published.
///
/// Errors: InvalidSetting (settings, bytes or distances out of range or not finite, distances that fall, no levels or
/// not one distance fewer than levels). Thread-safe; throws nothing but std::bad_alloc.
///
/// @param distances metres from the object's centre at which levels 1, 2... appear, >= 0, not falling
LODSMITH_API Result<StreamingCost> streamingCost(const std::vector<CostedLevel>& levels,
                                                 const std::vector<double>& distances,
                                                 const StreamingCostSettings& settings);

/// The number of the level that is drawn at a distance in metres.
LODSMITH_API std::size_t levelAt(const StreamingCost& cost, double distance);

/// What is out of range in settings, as a sentence; empty when nothing is.
LODSMITH_API std::string troubleWith(const StreamingCostSettings& settings);

} // namespace lodsmith
