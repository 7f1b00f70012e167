#pragma once

#include <lodsmith/core/Export.h>
#include <lodsmith/core/Result.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace lodsmith {

/// What one level takes in the files of a mesh.
struct LevelBytes {
    std::string manual;               ///< the mesh that it names; empty for level 0 and generated levels
    std::uint64_t bytes = 0;          ///< as stored
    std::uint64_t zlibBytes = 0;      ///< all of them in the order of the files as one zlib stream of kZlibLevel
    std::uint64_t duplicateBytes = 0; ///< vertices and indices among them that a higher level has too, byte for byte
};

/// A file that belongs to a mesh.
struct CountedFile {
    std::filesystem::path file;
    std::uint64_t bytes = 0;
    unsigned level = 0; ///< that brings it
};

/// The files of a mesh, and whose each of their bytes is.
struct MeshBytes {
    std::vector<LevelBytes> levels; ///< level 0 first; their bytes sum to those of all files
    std::vector<CountedFile> files; ///< each once: the mesh first, then in the order in which they are named
    std::vector<std::string> notes; ///< one sentence for each file that is not counted
};

/// The default of zlib and of most that uses it.
constexpr int kZlibLevel = 6;

/// Counts what of a mesh file, and of those that it names, belongs to which level.
///
/// - A generated level has its entry in the file's list of levels, with its own share of the index buffers: where two
///   levels keep their indices in one buffer, each has the part that it draws, and of what both draw the nearer level.
///   What none draws is the one's that stores it.
/// - A hand-made level has its entry, and the whole of the mesh file that it names, with the skeleton file that this
///   names. A file that a level above has counted already counts once, and a note says so.
/// - Level 0 has the rest: vertices, its own indices, names, bounds, edge lists of all levels, poses and animations,
///   and the mesh's skeleton file.
///
/// Names are looked up below the mesh's directory, and nowhere else. A skeleton that is not there is noted and not
/// counted.
///
/// Errors: NotFound and Io (the mesh, a hand-made level's mesh), BadFile (no mesh, cut off, damaged, a hand-made level
/// whose name leads out of the directory), OutOfMemory; file is the one that failed. Any thread; starts no OGRE and
/// needs none.
LODSMITH_API Result<MeshBytes> levelBytes(const std::filesystem::path& mesh);

} // namespace lodsmith
