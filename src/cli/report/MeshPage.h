#pragma once

#include "../JsonRecord.h"

#include <string>

namespace lodsmith::cli {

/// The page of a mesh.
/// @param record   entry of report.json
/// @param pictures member `levels` of takePictures(); null when there are none
/// @param overview address of the page that lists all meshes; empty when there is none
std::string meshPage(const Json& record, const Json& pictures, const std::string& overview);

/// The largest visible error of a mesh's levels where they appear, pixels; 0 without levels.
double largestVisibleError(const Json& record);

} // namespace lodsmith::cli
