#pragma once

#include <cstdint>

namespace lodsmith::media {

/// Numbers that are the same everywhere (PCG, O'Neill 2014: 32 bits out of 64), so that models can be made again.
class Random {
public:
    explicit Random(std::uint64_t seed) : mState(seed * 2 + 1) { next(); }

    /// From `least` up to but not including `most`.
    float range(float least, float most) { return least + (most - least) * (float(next() >> 8) * 0x1p-24f); }

private:
    std::uint32_t next()
    {
        const std::uint64_t old = mState;
        mState = old * 6364136223846793005u + 1442695040888963407u;
        const auto mixed = static_cast<std::uint32_t>(((old >> 18) ^ old) >> 27);
        const auto turn = static_cast<std::uint32_t>(old >> 59);
        return (mixed >> turn) | (mixed << ((32 - turn) & 31));
    }

    std::uint64_t mState;
};

} // namespace lodsmith::media
