#pragma once

#include "ContactSheet.h"

#include <lodsmith/render/LevelRenderer.h>
#include <lodsmith/render/SeenLevels.h>

#include <string>

namespace lodsmith::cli {

/// A contact sheet of a mesh's levels: what they are and what was measured, pictures where they appear, with those of
/// the original and of the level before, and close up. Errors: those of LevelRenderer.
/// @param seen what was measured with `options`
Result<Sheet> levelSheet(LevelRenderer& renderer, const std::vector<SeenLevel>& seen, const SeenOptions& options,
                         const std::string& name, bool hasAutomaticLevels);

} // namespace lodsmith::cli
