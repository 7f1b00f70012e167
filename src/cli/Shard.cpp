#include "Shard.h"

#include "../cache/Xxhash.h"
#include "Numbers.h"

namespace lodsmith::cli {

namespace {

constexpr unsigned kMostShards = 100000;

} // namespace

bool Shard::contains(std::string_view name) const
{
    return XXH3_64bits(name.data(), name.size()) % count == index - 1;
}

Result<Shard> parseShard(const std::string& text)
{
    const std::size_t slash = text.find('/');
    const auto index = parseCount(std::string_view(text).substr(0, slash));
    const auto count = slash == std::string::npos ? std::nullopt : parseCount(std::string_view(text).substr(slash + 1));
    if (!index || !count || *index < 1 || *index > *count || *count > kMostShards)
        return Error{ErrorCode::InvalidSetting,
                     "'" + text + "' is no I/N with whole numbers, 1 <= I <= N <= " + std::to_string(kMostShards)};
    return Shard{static_cast<unsigned>(*index), static_cast<unsigned>(*count)};
}

} // namespace lodsmith::cli
