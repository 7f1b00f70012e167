#pragma once

#include <lodsmith/core/Result.h>
#include <lodsmith/ogre/LodManager.h>
#include <lodsmith/ogre/QueuedProgressiveMeshGenerator.h>

#include <cstdint>
#include <string>
#include <string_view>

namespace lodsmith {

/// What lodsmith.cfg says.
struct PluginSettings {
    LodPolicy policy;
    QueueOptions queue;                                  ///< without a cache
    std::string cacheDirectory;                          ///< empty: the user's own
    std::uint64_t cacheLimit = std::uint64_t(256) << 20; ///< bytes; 0: there is no cache
};

/// Reads lodsmith.cfg: a `key=value` a line, blank lines, and comments from `#` on. plugin/lodsmith.cfg names all keys. What
/// is absent keeps its default. Errors, with file and line: BadFile (an unknown key, a value that is none of its kind).
Result<PluginSettings> parsePluginSettings(std::string_view text, const std::string& fileName);

} // namespace lodsmith
