#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace lodsmith::cli {

/// Processors that this process may use, at least 1.
unsigned usableProcessors();

/// Bytes of memory that are free for programs, or that the control groups (version 2) of this process leave it, whichever is
/// less; nothing when the system does not tell. `root` is where /proc and /sys are.
std::optional<std::uint64_t> availableMemory(const std::filesystem::path& root = "/");

} // namespace lodsmith::cli
