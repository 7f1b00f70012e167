#pragma once

#include <lodsmith/cache/CacheKey.h>
#include <lodsmith/core/LodChain.h>

#include <cstdint>

namespace lodsmith::test {

/// Every field has a value of its own, which depends on the seed; `indices` indices in the last of three levels.
LodChain sampleChain(std::uint32_t seed, std::size_t indices = 12);

/// Different seeds give different keys.
CacheKey sampleKey(std::uint32_t seed);

/// Whether two chains are equal in every field; numbers are compared by their bits.
bool same(const LodChain& a, const LodChain& b);

} // namespace lodsmith::test
