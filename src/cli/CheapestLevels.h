#pragma once

#include "CostRecord.h"

#include <cstdint>

namespace lodsmith::cli {

/// Simplifies a mesh once to many triangle counts, and picks of these the chain of least streaming cost whose levels
/// appear where their deviation is settings.mostPixels, which has to be set; docs/cli.md has the members under
/// `optimised`.
/// Errors: those of MeshReader and simplify().
///
/// @param levelZeroBytes what level 0 takes, which stays
Result<Json> cheapestLevels(const Ogre::Mesh& mesh, std::uint64_t levelZeroBytes, const CostSettings& settings,
                            Progress& progress);

} // namespace lodsmith::cli
