#pragma once

#include <cstdint>
#include <optional>

namespace lodsmith::cli {

/// Measures by how much the process's resident memory grows at most while something is done. Linux only: it resets the
/// high-water mark through /proc/self/clear_refs. Memory that lay free in the heap beforehand is handed back first.
class PeakMemory {
public:
    PeakMemory();

    /// Kibibytes (1024 bytes) between the start and the highest point since; nothing where the system does not tell.
    std::optional<std::int64_t> growthKb() const;

private:
    std::optional<std::int64_t> mBefore;
};

} // namespace lodsmith::cli
