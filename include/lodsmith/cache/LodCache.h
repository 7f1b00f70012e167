#pragma once

#include <lodsmith/cache/CacheKey.h>
#include <lodsmith/core/Export.h>
#include <lodsmith/core/LodChain.h>
#include <lodsmith/core/Result.h>

#include <cstdint>
#include <filesystem>
#include <mutex>
#include <optional>

namespace lodsmith {

/// Chains kept on disk from one start to the next: a directory with one file an entry. docs/cache.md has the format.
///
/// Any number of threads and processes may use one directory at a time, without locks: entries appear whole or not at all,
/// and each may vanish at any moment. What a killed process left half-written is cleared away when it is an hour old. Entries
/// are checked when they are read; one that is damaged, or of another version, is removed and counts as not there.
///
/// Nothing is kept in memory and nothing is made durable: after a power cut the newest entries may be gone, no more.
class LODSMITH_API LodCache {
public:
    /// Touches nothing yet; the directory is made by the first store(). Files in it that are no entries are left alone.
    ///
    /// @param maxBytes limit on the sum of the entries' sizes. It holds whenever no store() is under way, with one or two
    ///                 objects, of one process or of two, that store in the directory; each further one may pass it by a
    ///                 sixteenth. Entries that were not used for longest go first, from seven eighths of the limit on.
    LodCache(std::filesystem::path directory, std::uint64_t maxBytes);
    LodCache(const LodCache&) = delete;
    LodCache& operator=(const LodCache&) = delete;

    /// The chain that was stored under a key, or none, for whatever reason. Marks it as used just now.
    std::optional<LodChain> find(const CacheKey& key) const;

    /// Stores a chain, in place of an earlier one under the key, and removes old entries where the limit asks for it.
    ///
    /// Errors, after which there is no new entry: Io (disk full, directory not writable; file is the entry's),
    /// Unsupported (the entry alone is larger than seven eighths of maxBytes, or than 1 GiB), OutOfMemory.
    Result<Done> store(const CacheKey& key, const LodChain& chain);

private:
    void countStored(std::uint64_t bytes);

    std::filesystem::path mDirectory;
    std::uint64_t mMaxBytes;
    std::mutex mMutex;
    std::uint64_t mUnseenBytes; ///< stored since the directory was last looked at
};

} // namespace lodsmith
