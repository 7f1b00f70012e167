#pragma once

#include <cstdint>
#include <vector>

namespace lodsmith {

/// How each vertex stands with the collapse queue: all that is needed to fill a queue again, whole or of a part of the mesh.
struct QueueStates {
    enum Flag : std::uint8_t {
        kQueued = 1, ///< has an entry in the queue
        kStale = 2,  ///< its neighbourhood changed since it was evaluated
        kLocked = 4,
        kStalled = 8,   ///< had no allowed collapse when last looked at
        kHeldBack = 16, ///< a cheaper collapse than that of its entry was forbidden when last looked at
    };

    struct Entry {
        /// An entry of the queue with another cost counts no more. Of a stalled vertex: it need not be looked at again
        /// while both limits are smaller; infinite when none helps.
        float cost = 0.0f;
        /// Of the cheapest collapse, as last evaluated; itself when its piece is to vanish. Means nothing when stale.
        std::uint32_t target = 0;
    };

    explicit QueueStates(std::uint32_t vertices) : flags(vertices, 0), entries(vertices) {}

    std::vector<std::uint8_t> flags;
    std::vector<Entry> entries;
};

} // namespace lodsmith
