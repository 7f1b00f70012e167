#include "Chains.h"

#include "support/MeshBuilders.h"

#include <algorithm>
#include <cstring>

namespace lodsmith::test {

namespace {

bool same(double a, double b)
{
    return std::memcmp(&a, &b, sizeof a) == 0;
}

bool same(const CleaningReport& a, const CleaningReport& b)
{
    return a.degenerateTriangles == b.degenerateTriangles && a.repeatedTriangles == b.repeatedTriangles
           && a.unreferencedVertices == b.unreferencedVertices;
}

bool same(const LodChainLevel& a, const LodChainLevel& b)
{
    return a.indices == b.indices && a.vertices == b.vertices && a.triangles == b.triangles
           && same(a.deviation, b.deviation) && same(a.cost, b.cost) && a.stop == b.stop && a.skipped == b.skipped;
}

} // namespace

LodChain sampleChain(std::uint32_t seed, std::size_t indices)
{
    TestRandom random(seed);
    LodChain chain;
    chain.vertices = random.bits();
    chain.bufferVertices = random.bits();
    chain.triangles = random.bits();
    chain.radius = random.uniform();
    chain.cleaned = {random.bits(), random.bits(), random.bits()};
    chain.levels.resize(3);
    for (LodChainLevel& level : chain.levels) {
        level.vertices = random.bits();
        level.triangles = random.bits();
        level.deviation = random.uniform();
        level.cost = random.uniform();
    }
    chain.levels[0].indices = {{0, 1, 2}, {}};
    chain.levels[0].stop = StopReason::Seam;
    chain.levels[1].skipped = true;
    chain.levels[1].stop = StopReason::Topology;
    chain.levels[2].indices = {{}, {}};
    for (std::size_t i = 0; i < indices; ++i)
        chain.levels[2].indices[1].push_back(random.bits() % 70000);
    return chain;
}

CacheKey sampleKey(std::uint32_t seed)
{
    CacheKey key;
    std::memcpy(key.bytes.data(), &seed, sizeof seed);
    key.bytes.back() = 0xf0;
    return key;
}

bool same(const LodChain& a, const LodChain& b)
{
    return a.vertices == b.vertices && a.bufferVertices == b.bufferVertices && a.triangles == b.triangles
           && same(a.radius, b.radius) && same(a.cleaned, b.cleaned)
           && std::equal(a.levels.begin(), a.levels.end(), b.levels.begin(), b.levels.end(),
                         [](const LodChainLevel& x, const LodChainLevel& y) { return same(x, y); });
}

} // namespace lodsmith::test
