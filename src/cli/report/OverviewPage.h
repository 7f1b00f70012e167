#pragma once

#include "../JsonRecord.h"

#include <string>

namespace lodsmith::cli {

/// The page that lists all meshes, those by which most triangles can be saved first and failed ones last.
/// @param report as report.json holds it, docs/report.md
std::string overviewPage(const Json& report);

} // namespace lodsmith::cli
