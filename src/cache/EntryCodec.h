#pragma once

#include <lodsmith/cache/CacheKey.h>
#include <lodsmith/core/LodChain.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace lodsmith {

/// The bytes of an entry: head, payload, checksum. docs/cache.md has the format.
std::string encodeEntry(const CacheKey& key, const LodChain& chain);

/// The chain in an entry, or none when the entry is not exactly what encodeEntry() makes of a key and some chain. Takes time
/// and memory in proportion to the bytes, whatever they are.
std::optional<LodChain> decodeEntry(const CacheKey& key, std::string_view entry);

/// The chain itself, without key and checksum.
std::string encodePayload(const LodChain& chain);
std::optional<LodChain> decodePayload(std::string_view payload);

/// The last eight bytes of an entry, as a number: XXH3, 64 bits, of all before them.
std::uint64_t checksumOf(std::string_view bytes);

} // namespace lodsmith
