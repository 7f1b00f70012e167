#pragma once

#include <lodsmith/core/Export.h>
#include <lodsmith/core/MeshView.h>
#include <lodsmith/core/Simplify.h>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace lodsmith {

/// 128 bits that stand for one call of simplify().
struct CacheKey {
    std::array<std::uint8_t, 16> bytes{};
};

inline bool operator==(const CacheKey& a, const CacheKey& b)
{
    return a.bytes == b.bytes;
}

inline bool operator!=(const CacheKey& a, const CacheKey& b)
{
    return !(a == b);
}

/// 32 hexadecimal digits, lower case.
LODSMITH_API std::string toHex(const CacheKey& key);

/// The key of what simplify() makes of a mesh: the XXH3 hash, 128 bits, of everything that decides it.
///
/// That is every number of every stream, bit for bit, indices as numbers (the same in 16 and in 32 bits), which streams,
/// buffers and submeshes there are, targets and options in order, the name of what is done to the chain afterwards
/// (ChainFinish), the library's version and the number of the cache's format. Addresses and strides are not in it: separate
/// and interleaved arrays of the same numbers have the same key. Each list is preceded by its length, so that what ends one
/// cannot begin the next. Machines of different byte order have different keys. The hash is no cryptographic one: whoever
/// makes a mesh on purpose can give it the key of another, which is why simplifyCached() looks at what it found.
///
/// Takes a small share of the time of simplify() (docs/cache.md). Thread-safe as simplify(), and the same things are misuse.
LODSMITH_API CacheKey cacheKey(const MeshView& mesh, const std::vector<LevelTarget>& targets,
                               const SimplifyOptions& options = {}, std::string_view finish = {});

} // namespace lodsmith
