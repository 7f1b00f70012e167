#pragma once

#include <lodsmith/analysis/Image.h>
#include <lodsmith/core/Export.h>
#include <lodsmith/core/Result.h>

#include <string>

namespace lodsmith {

/// A picture as the bytes of a PNG file, whose colours are not multiplied by alpha. Needs OGRE with a codec for PNG, as
/// RenderEngine has it. Errors: Unsupported (OGRE refused), OutOfMemory.
LODSMITH_API Result<std::string> pngBytes(const Image& image);

} // namespace lodsmith
