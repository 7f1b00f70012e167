#pragma once

#include <lodsmith/cache/CacheKey.h>

#include <cstdint>
#include <filesystem>
#include <string>

namespace lodsmith {

/// The name of a key's file: "<32 hexadecimal digits>.lodchain".
std::string entryFileName(const CacheKey& key);

/// Looks at every file of a cache's directory, and removes entries, those not used for longest first, until at most
/// `wantedBytes` are left. Half-written files older than an hour go too. Other processes may do the same at the same time.
void trimCache(const std::filesystem::path& directory, std::uint64_t wantedBytes);

} // namespace lodsmith
