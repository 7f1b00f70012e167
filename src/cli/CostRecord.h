#pragma once

#include "JsonRecord.h"

#include <lodsmith/analysis/StreamingCost.h>
#include <lodsmith/core/Progress.h>
#include <lodsmith/core/Result.h>
#include <lodsmith/ogre/SwitchDistance.h>

#include <OgreMesh.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace lodsmith::cli {

/// How the cost of a mesh is reckoned.
struct CostSettings {
    std::string preset = "seed"; ///< seed, viewer or honest: the name of `formula`, for the record
    StreamingCostSettings formula = seedCost();
    double metresPerUnit = 1.0;       ///< of the mesh's world unit
    bool zlibSizes = false;           ///< levels are charged for their bytes behind zlib, not as stored
    bool presetDistances = false;     ///< levels appear at the formula's ratios, not where the mesh's own strategy says
    View view;                        ///< turns pixel counts into distances
    std::vector<double> places;       ///< metres from the object, for which to say what is drawn there
    std::optional<double> mostPixels; ///< look for the cheapest chain within so many pixels of error
};

/// "seed", "viewer" or "honest". Error: InvalidSetting.
Result<StreamingCostSettings> costPreset(const std::string& name);

/// All figures of one mesh with the levels that it has; docs/cli.md has the members of the record, `preset` to
/// `optimised`.
/// Errors: those of levelBytes(), switchDistance() and streamingCost(); InvalidGeometry (no bounds); BadFile (the file
/// has other levels than the mesh); with `mostPixels` those of MeshReader and simplify(). OGRE must be running: to be
/// called in a child process.
///
/// @param mesh as loaded from `file`
Result<Json> costRecord(const Ogre::Mesh& mesh, const std::filesystem::path& file, const CostSettings& settings,
                        Progress& progress);

} // namespace lodsmith::cli
