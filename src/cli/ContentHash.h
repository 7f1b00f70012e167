#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace lodsmith::cli {

/// Files and the hashes of what is in them; nothing for a file that is not there or cannot be read.
using FileHashes = std::map<std::filesystem::path, std::optional<std::string>>;

/// XXH3, 128 bits, as 32 hexadecimal digits. Not cryptographic: it tells changes, not forgeries.
std::string contentHash(std::string_view bytes);

/// The hash of a regular file's content, read piece by piece; nothing when there is none or it cannot be read.
std::optional<std::string> fileHash(const std::filesystem::path& path);

} // namespace lodsmith::cli
