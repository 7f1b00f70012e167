#include <lodsmith/cache/LodCache.h>

#include "../files/AtomicFile.h"
#include "CacheDirectory.h"
#include "EntryCodec.h"

#include <algorithm>
#include <new>
#include <system_error>
#include <utility>

namespace fs = std::filesystem;

namespace lodsmith {

namespace {

constexpr std::uint64_t kMaxEntryBytes = std::uint64_t{1} << 30;

/// What a process may store between two looks at the directory, which others fill too.
std::uint64_t shareOf(std::uint64_t maxBytes)
{
    return maxBytes / 16;
}

/// What may be left after such a look: a share stays free for this process and one for another.
std::uint64_t wantedOf(std::uint64_t maxBytes)
{
    return maxBytes - 2 * shareOf(maxBytes);
}

Error tooLarge(std::uint64_t bytes, std::uint64_t largest)
{
    return {ErrorCode::Unsupported, "the entry would have " + std::to_string(bytes) + " bytes, and the cache takes "
                                        + std::to_string(largest) + " at most"};
}

/// In new files too: the times that the system gives them are too coarse to tell which is older.
void markAsUsed(const fs::path& path)
{
    std::error_code ignored;
    fs::last_write_time(path, fs::file_time_type::clock::now(), ignored);
}

Result<Done> writeEntry(const fs::path& path, std::string_view bytes)
{
    AtomicFile file(path, Existing::Replace, Durability::None);
    if (auto prepared = file.prepare(bytes); !prepared)
        return prepared;
    auto written = file.commit();
    if (written)
        markAsUsed(path);
    return written;
}

} // namespace

// As if a share were used up already, so that the first store() looks at the directory.
LodCache::LodCache(fs::path directory, std::uint64_t maxBytes)
    : mDirectory(std::move(directory)), mMaxBytes(maxBytes), mUnseenBytes(shareOf(maxBytes))
{
}

std::optional<LodChain> LodCache::find(const CacheKey& key) const
{
    try {
        const fs::path path = mDirectory / entryFileName(key);
        const Result<std::string> entry = readFile(path, kMaxEntryBytes);
        if (!entry)
            return std::nullopt;
        auto chain = decodeEntry(key, entry.value());
        std::error_code ignored;
        if (chain)
            markAsUsed(path);
        else
            fs::remove(path, ignored);
        return chain;
    } catch (const std::bad_alloc&) {
        return std::nullopt;
    }
}

Result<Done> LodCache::store(const CacheKey& key, const LodChain& chain)
{
    try {
        const std::string entry = encodeEntry(key, chain);
        const std::uint64_t largest = std::min(wantedOf(mMaxBytes), kMaxEntryBytes);
        if (entry.size() > largest)
            return tooLarge(entry.size(), largest);
        auto written = writeEntry(mDirectory / entryFileName(key), entry);
        if (written)
            countStored(entry.size());
        return written;
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::OutOfMemory, "not enough memory to store an entry"};
    }
}

void LodCache::countStored(std::uint64_t bytes)
{
    const std::lock_guard<std::mutex> lock(mMutex);
    mUnseenBytes += bytes;
    if (mUnseenBytes <= shareOf(mMaxBytes))
        return;
    trimCache(mDirectory, wantedOf(mMaxBytes));
    mUnseenBytes = 0;
}

} // namespace lodsmith
