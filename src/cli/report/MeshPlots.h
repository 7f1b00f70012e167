#pragma once

#include "../JsonRecord.h"
#include "Plot.h"

namespace lodsmith::cli {

/// Deviation, as a percentage of the radius, over triangles: what the mesh can be simplified to, and where its levels
/// stand.
Plot deviationPlot(const Json& record);

/// Triangles drawn over the distance: as the file is, with the levels that are judged, and with automatic ones.
Plot distancePlot(const Json& record);

} // namespace lodsmith::cli
