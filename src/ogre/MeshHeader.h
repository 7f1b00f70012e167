#pragma once

#include <lodsmith/core/Export.h>
#include <lodsmith/core/Result.h>

#include <string>
#include <string_view>

namespace lodsmith {

/// What the first bytes of a `.mesh` file say.
struct MeshHeader {
    std::string version; ///< "1.100", "1.8", "1.41" ...
    bool bigEndian = false;
};

/// Looks at a `.mesh` file before OGRE does, since OGRE asserts on much of what is no mesh.
/// Errors: BadFile when the file is empty, is no OGRE mesh, is of a version that OGRE 1.12 does not read, or ends well
/// before its contents say. File and line are not set.
LODSMITH_API Result<MeshHeader> parseMeshHeader(std::string_view bytes);

} // namespace lodsmith
