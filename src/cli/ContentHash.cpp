#include "ContentHash.h"

#include "../cache/Xxhash.h"

#include <lodsmith/cache/CacheKey.h>

#include <cerrno>
#include <cstring>
#include <vector>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace lodsmith::cli {

namespace {

constexpr std::size_t kPiece = std::size_t(1) << 18;

std::string digits(XXH128_hash_t hash)
{
    XXH128_canonical_t canonical;
    XXH128_canonicalFromHash(&canonical, hash);
    CacheKey key;
    static_assert(sizeof canonical.digest == sizeof key.bytes);
    std::memcpy(key.bytes.data(), canonical.digest, sizeof canonical.digest);
    return toHex(key);
}

std::optional<std::string> hashOf(int descriptor)
{
    XXH3_state_t state;
    XXH3_128bits_reset(&state);
    std::vector<char> piece(kPiece);
    for (;;) {
        const ssize_t count = ::read(descriptor, piece.data(), piece.size());
        if (count == 0)
            return digits(XXH3_128bits_digest(&state));
        if (count > 0)
            XXH3_128bits_update(&state, piece.data(), static_cast<std::size_t>(count));
        else if (errno != EINTR)
            return std::nullopt;
    }
}

} // namespace

std::string contentHash(std::string_view bytes)
{
    return digits(XXH3_128bits(bytes.data(), bytes.size()));
}

std::optional<std::string> fileHash(const std::filesystem::path& path)
{
    // A pipe of that name must not hold everything up.
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (descriptor < 0)
        return std::nullopt;
    struct stat status = {};
    std::optional<std::string> hash;
    if (::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode))
        hash = hashOf(descriptor);
    ::close(descriptor);
    return hash;
}

} // namespace lodsmith::cli
