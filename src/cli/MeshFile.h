#pragma once

#include "../files/AtomicFile.h"

#include <lodsmith/core/Result.h>

#include <OgreMesh.h>
#include <OgreMeshSerializer.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace lodsmith::cli {

/// How a mesh is written.
struct MeshFormat {
    Ogre::MeshVersion version = Ogre::MESH_VERSION_1_10;
    Ogre::Serializer::Endian endian = Ogre::Serializer::ENDIAN_NATIVE;
};

/// "1.0", "1.4", "1.41", "1.8" or "1.10", OGRE's names of its mesh formats. Error: InvalidSetting.
Result<Ogre::MeshVersion> parseMeshVersion(const std::string& word);

/// "native", "little" or "big". Error: InvalidSetting.
Result<Ogre::Serializer::Endian> parseEndian(const std::string& word);

/// Whether OGRE writes levels of detail in a format; in 1.0 and 1.4 it leaves them out without a word.
bool holdsLevels(Ogre::MeshVersion version);

/// The bytes of a `.mesh` file. Error: Unsupported when the mesh has levels that the format does not hold, or vertex
/// elements whose byte order OGRE does not turn (normalised bytes among them).
Result<std::string> meshBytes(const Ogre::Mesh& mesh, const MeshFormat& format);

/// A file that goes along with a mesh: the copy of another one, or new.
struct Companion {
    std::filesystem::path source; ///< what it is a copy of, or where there is `content` was made of
    std::string name;             ///< relative to the mesh's directory, as the mesh names it
    std::optional<std::string> content = std::nullopt;
};

/// The skeleton file that a mesh loaded from `meshPath` names, if it lies beside it; otherwise a sentence in `notes`.
std::vector<Companion> findSkeleton(const Ogre::Mesh& mesh, const std::filesystem::path& meshPath,
                                    std::vector<std::string>& notes);

/// AtomicFile::checkTarget(), whose error says so when --force would help.
Result<Done> checkOutput(const std::filesystem::path& target, Existing existing);

/// Nanoseconds since 1970, as time stamps of files count them: whatever is written from now on has this time or a later one,
/// and what has been written an earlier one. That takes a step of theirs to pass, some milliseconds.
std::int64_t nextFileTime();

/// What becomes of files that are there already.
struct Overwriting {
    Existing existing = Existing::Keep;
    /// With Existing::Replace, a nextFileTime(): what is younger belongs to another mesh of the same run.
    std::int64_t runBegan = 0;
};

/// Writes a mesh and its companions, all or nothing. A companion that is there already with the same content
/// stays as it is; one with other content that another mesh of the run has brought is never replaced.
/// Errors: Io, NotFound, InvalidSetting (two companions of one name); file is the one that failed.
Result<Done> writeMeshFiles(const std::filesystem::path& target, const std::string& bytes,
                            const std::vector<Companion>& companions, const Overwriting& overwriting);

} // namespace lodsmith::cli
