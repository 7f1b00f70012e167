#pragma once

#include "MeshHeader.h"

#include <lodsmith/core/Export.h>
#include <lodsmith/core/Result.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace lodsmith {

/// Bytes `begin` to `end` of a file, and the level that they belong to.
struct FileSpan {
    std::size_t begin = 0;
    std::size_t end = 0;
    unsigned level = 0;
};

/// Which bytes of a `.mesh` file are whose.
///
/// A level has its entry in the file's list of levels: header, value, and its index lists or the name of its mesh.
/// Where two levels keep their indices in one buffer, each has the part that it draws, and of what both draw the nearer
/// one. Everything else is level 0's: vertices, its own indices, and all that no level owns (names, bounds, edge lists,
/// poses, animations).
struct MeshChunks {
    std::vector<FileSpan> spans; ///< all bytes of the file, each once, in order
    /// Those of them that are vertices or indices, each buffer as far as it has one owner; nearer levels first.
    std::vector<FileSpan> buffers;
    std::vector<std::string> manual; ///< for each level the mesh that it names, empty for level 0 and generated ones
    std::string skeleton;            ///< the skeleton's name, empty for none
};

/// Reads the chunks of all formats that OGRE 1.12 reads, in both byte orders, as OGRE does: by what they hold rather
/// than by their stated lengths, which OGRE's own writer has got wrong in some versions.
/// Errors: BadFile (cut off, counts beyond the end, levels that OGRE would refuse), with the byte at which it shows;
/// file is not set.
///
/// @param header of these bytes
LODSMITH_API Result<MeshChunks> readMeshChunks(std::string_view bytes, const MeshHeader& header);

} // namespace lodsmith
