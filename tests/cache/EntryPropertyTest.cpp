#include "EntryCodec.h"

#include "Chains.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstring>

namespace lodsmith {

namespace {

double anyNumber()
{
    const auto bits = *rc::gen::arbitrary<std::uint64_t>();
    double number;
    std::memcpy(&number, &bits, sizeof number);
    return number;
}

std::uint32_t anyCount()
{
    return *rc::gen::arbitrary<std::uint32_t>();
}

/// Small ones, as in meshes, and any at all.
rc::Gen<std::uint32_t> indices()
{
    return rc::gen::weightedOneOf<std::uint32_t>({{3, rc::gen::inRange<std::uint32_t>(0, 300)},
                                                  {2, rc::gen::inRange<std::uint32_t>(60000, 70000)},
                                                  {1, rc::gen::arbitrary<std::uint32_t>()}});
}

LodChainLevel anyLevel()
{
    LodChainLevel level;
    level.indices = *rc::gen::container<std::vector<std::vector<std::uint32_t>>>(
        rc::gen::container<std::vector<std::uint32_t>>(indices()));
    level.vertices = anyCount();
    level.triangles = anyCount();
    level.deviation = anyNumber();
    level.cost = anyNumber();
    level.stop =
        *rc::gen::element(StopReason::TargetReached, StopReason::Locked, StopReason::Seam, StopReason::Topology);
    level.skipped = *rc::gen::arbitrary<bool>();
    return level;
}

LodChain anyChain()
{
    LodChain chain;
    chain.vertices = anyCount();
    chain.bufferVertices = anyCount();
    chain.triangles = anyCount();
    chain.radius = anyNumber();
    chain.cleaned = {anyCount(), anyCount(), anyCount()};
    const int levels = *rc::gen::inRange(0, 6);
    for (int i = 0; i < levels; ++i)
        chain.levels.push_back(anyLevel());
    return chain;
}

CacheKey anyKey()
{
    CacheKey key;
    for (std::uint8_t& byte : key.bytes)
        byte = *rc::gen::arbitrary<std::uint8_t>();
    return key;
}

} // namespace

RC_GTEST_PROP(EntryProperty, WhatIsWrittenIsReadAgain, ())
{
    const LodChain chain = anyChain();
    const CacheKey key = anyKey();
    const auto again = decodeEntry(key, encodeEntry(key, chain));
    RC_ASSERT(again.has_value());
    RC_ASSERT(test::same(*again, chain));
}

RC_GTEST_PROP(EntryProperty, WhatIsReadWouldBeWrittenTheSame, ())
{
    std::string payload = encodePayload(anyChain());
    const int changes = *rc::gen::inRange(0, 3);
    for (int i = 0; i < changes; ++i)
        payload[*rc::gen::inRange<std::size_t>(0, payload.size())] = *rc::gen::arbitrary<char>();
    if (const auto chain = decodePayload(payload))
        RC_ASSERT(encodePayload(*chain) == payload);
}

} // namespace lodsmith
