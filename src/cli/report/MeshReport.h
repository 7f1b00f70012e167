#pragma once

#include "../JsonRecord.h"
#include "../OutputPlan.h"

#include <lodsmith/core/Progress.h>

#include <cstdint>

namespace lodsmith::cli {

/// What all meshes of a report are asked.
struct ReportSettings {
    double pixelBudget = 1.0;       ///< visible error that a switch may have, pixels, > 0
    std::uint32_t samples = 100000; ///< points on each surface, for the deviation of levels, >= 1
};

/// All figures of one mesh; docs/report.md has the members of the record.
/// Starts OGRE: to be called in a child process. Errors: those of judgedMesh(), LevelReader, switchDistance(),
/// simplify() and measureDeviation().
Result<Json> reportMesh(const ReportSettings& settings, const PlannedFile& file, Progress& progress);

} // namespace lodsmith::cli
