#pragma once

#include <lodsmith/core/Result.h>

#include <string>
#include <string_view>

namespace lodsmith::cli {

/// One of `count` parts into which the files of a batch are divided, `index` from 1.
struct Shard {
    unsigned index = 1;
    unsigned count = 1;

    /// Whether a file is in this part; every name is in exactly one of the parts 1..count, on every machine, whatever other
    /// files there are. The name is relative to the output directory, with '/' between directories.
    bool contains(std::string_view name) const;
};

/// "I/N", 1 <= I <= N <= 100000. Error: InvalidSetting.
Result<Shard> parseShard(const std::string& text);

} // namespace lodsmith::cli
