#include "CacheDirectory.h"

#include "../files/AtomicFile.h"

#include <algorithm>
#include <chrono>
#include <string_view>
#include <system_error>
#include <tuple>
#include <utility>
#include <vector>

namespace fs = std::filesystem;

namespace lodsmith {

namespace {

constexpr std::string_view kExtension = ".lodchain";
constexpr std::chrono::hours kLeftoverAge{1};

struct Entry {
    fs::path path;
    std::uint64_t bytes;
    fs::file_time_type used;
};

bool isEntryName(std::string_view name)
{
    const std::size_t digits = 2 * CacheKey().bytes.size();
    return name.size() == digits + kExtension.size() && name.substr(digits) == kExtension
           && name.find_first_not_of("0123456789abcdef") == digits;
}

void removeLeftover(const fs::path& path)
{
    std::error_code code;
    const fs::file_time_type written = fs::last_write_time(path, code);
    if (!code && fs::file_time_type::clock::now() - written > kLeftoverAge)
        fs::remove(path, code);
}

/// Files that vanish meanwhile are left out.
std::vector<Entry> listEntries(const fs::path& directory)
{
    std::vector<Entry> entries;
    std::error_code code;
    for (fs::directory_iterator file(directory, code), end; !code && file != end; file.increment(code)) {
        const std::string name = file->path().filename().string();
        if (AtomicFile::isTemporary(name))
            removeLeftover(file->path());
        std::error_code trouble;
        if (!isEntryName(name) || file->symlink_status(trouble).type() != fs::file_type::regular)
            continue;
        const std::uint64_t bytes = file->file_size(trouble);
        const fs::file_time_type used = trouble ? fs::file_time_type() : file->last_write_time(trouble);
        if (!trouble)
            entries.push_back({file->path(), bytes, used});
    }
    return entries;
}

} // namespace

std::string entryFileName(const CacheKey& key)
{
    return toHex(key).append(kExtension);
}

void trimCache(const fs::path& directory, std::uint64_t wantedBytes)
{
    std::vector<Entry> entries = listEntries(directory);
    std::sort(entries.begin(), entries.end(),
              [](const Entry& a, const Entry& b) { return std::tie(a.used, a.path) > std::tie(b.used, b.path); });
    std::uint64_t room = wantedBytes;
    bool full = false;
    for (const Entry& entry : entries) {
        full = full || entry.bytes > room;
        std::error_code ignored;
        if (full)
            fs::remove(entry.path, ignored);
        else
            room -= entry.bytes;
    }
}

} // namespace lodsmith
