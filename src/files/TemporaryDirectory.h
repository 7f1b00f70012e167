#pragma once

#include <lodsmith/core/Result.h>

#include <filesystem>

namespace lodsmith {

/// A directory below that for the system's temporary files, which is gone with all that is in it when the object is.
/// What a process that was killed leaves is cleared away by AtomicFile::removeLeftovers().
class TemporaryDirectory {
public:
    /// Error: Io.
    static Result<TemporaryDirectory> create();

    TemporaryDirectory(TemporaryDirectory&& other) noexcept;
    TemporaryDirectory& operator=(TemporaryDirectory&& other) noexcept;
    ~TemporaryDirectory();

    const std::filesystem::path& path() const { return mPath; }

    /// Where such directories are made.
    static std::filesystem::path parent();

private:
    explicit TemporaryDirectory(std::filesystem::path path);

    std::filesystem::path mPath; ///< empty when another object has it
};

} // namespace lodsmith
