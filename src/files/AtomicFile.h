#pragma once

#include <lodsmith/core/Result.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include <sys/types.h>

namespace lodsmith {

/// What to do about a file that is already there.
enum class Existing { Keep, Replace };

/// What a power cut may do to a file that is in its place already.
enum class Durability {
    Synced, ///< nothing: it is on the disk, which takes its time
    None,   ///< empty it or take it away: for what can be made again and is checked when it is read
};

/// A file that appears whole or not at all: written beside its place under a temporary name, then renamed.
///
/// Whatever fails, the target is as it was and the temporary file is gone once the object is. A process that is killed
/// while it writes leaves its temporary file; removeLeftovers() clears it away.
class AtomicFile {
public:
    /// Touches nothing yet.
    AtomicFile(std::filesystem::path target, Existing existing, Durability durability = Durability::Synced);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    /// Writes everything to the temporary file and makes it as durable as was asked for; directories on the way are
    /// made. To be called once. Errors: those of checkTarget(), Io.
    Result<Done> prepare(std::string_view bytes);

    /// Puts what was prepared in its place. Errors: those of checkTarget(), Io.
    Result<Done> commit();

    /// Whether a write could succeed as far as the target goes. Error: Io when it exists and is to be kept, or when it
    /// is no regular file (which is never replaced).
    static Result<Done> checkTarget(const std::filesystem::path& target, Existing existing);

    /// What the names of the temporary files of process `writer` of this machine begin with, and those of its temporary
    /// directories. Other machines may write into the same directories.
    static std::string temporaryPrefix(pid_t writer);

    /// Removes the temporary files and directories that process `writer`, which has ended, left in a directory.
    static void removeLeftovers(const std::filesystem::path& directory, pid_t writer);

    /// Removes the temporary files of a directory that are older than an hour, of whichever process: it was killed.
    static void removeAbandoned(const std::filesystem::path& directory);

    /// Whether a file is a temporary one by its name, of whichever process.
    static bool isTemporary(std::string_view fileName);

private:
    Result<Done> openTemporary();
    Result<Done> writeAll(std::string_view bytes);
    Result<Done> linkIntoPlace();
    Result<Done> renameIntoPlace();
    Error failure(const std::string& what) const;

    std::filesystem::path mTarget;
    std::filesystem::path mDirectory;
    std::filesystem::path mTemporary;
    Existing mExisting;
    Durability mDurability;
    int mDescriptor = -1;
};

/// The whole content of a regular file of at most `largest` bytes. Errors: NotFound, Io (also for a larger file, a
/// directory or a device).
Result<std::string> readFile(const std::filesystem::path& path, std::uintmax_t largest = 0xffffffff);

} // namespace lodsmith
