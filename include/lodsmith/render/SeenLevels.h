#pragma once

#include <lodsmith/analysis/ImageDifference.h>
#include <lodsmith/core/Export.h>
#include <lodsmith/core/Progress.h>
#include <lodsmith/core/Result.h>
#include <lodsmith/render/Viewpoint.h>

#include <cstddef>
#include <vector>

namespace lodsmith {

class LevelRenderer;

/// ImageDifference over all viewDirections().
struct SeenDifference {
    double largest = 0.0; ///< 0..255, of all directions
    double mean = 0.0;    ///< 0..255, mean over the directions
    double ssim = 1.0;    ///< mean over the directions
    double leastSsim = 1.0;
    double silhouetteShare = 0.0;    ///< mean over the directions
    double silhouetteDistance = 0.0; ///< pixels, the largest
    double coverage = 1.0; ///< what is covered in all directions together, as a share of the same of the original
    double leastCoverage = 1.0;
};

/// The same in two paints.
struct PaintedDifference {
    SeenDifference lit;     ///< Paint::Own
    SeenDifference checker; ///< Paint::Checker
};

/// What a level looks like.
struct SeenLevel {
    std::size_t triangles = 0;
    /// World units from the mesh's origin; of all directions the shortest. 0 for level 0, and for one that never appears.
    double switchDistance = 0.0;
    double switchRadius = 0.0;  ///< pixels of the mesh's bounding radius there
    PaintedDifference atSwitch; ///< from level 0, where the level appears; none where it never does
    PaintedDifference popping;  ///< from the level before, where the level appears: what a player sees change
    PaintedDifference closeUp;  ///< from level 0, seen so near that it fills the picture

    bool appears() const { return switchDistance > 0.0; } ///< false for level 0, which is there from the beginning
};

struct SeenOptions {
    Screen screen;              ///< on which levels switch; its sides at most 2048 pixels
    unsigned closeUpSize = 512; ///< pixels, 32..2048
};

/// Takes pictures of all levels and compares them. Level 0 comes first, which differs from nothing.
/// Errors: those of LevelRenderer and switchDistance(); Cancelled.
/// @param progress may be null
LODSMITH_API Result<std::vector<SeenLevel>> measureSeenLevels(LevelRenderer& renderer, const SeenOptions& options = {},
                                                              Progress* progress = nullptr);

} // namespace lodsmith
