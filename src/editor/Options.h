#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace lodsmith::editor {

/// What the command line says.
struct Options {
    std::vector<std::filesystem::path> paths; ///< meshes, and directories of meshes
    std::filesystem::path script;             ///< Lua to run beside the panel; empty for none
    std::filesystem::path log;                ///< file for OGRE's and CEGUI's messages; empty for none
};

} // namespace lodsmith::editor
