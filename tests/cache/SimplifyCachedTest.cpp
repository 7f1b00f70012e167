#include <lodsmith/cache/SimplifyCached.h>

#include "Chains.h"
#include "support/MeshBuilders.h"
#include "support/TestDirectory.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <functional>
#include <stdexcept>

namespace lodsmith {

namespace {

using test::same;
using test::TestDirectory;
using testing::IsEmpty;

constexpr std::uint64_t kRoomy = 1 << 24;

const std::vector<LevelTarget> kTargets = {{LevelTarget::Kind::Proportional, 0.5},
                                           {LevelTarget::Kind::Proportional, 0.5}, // the same again: skipped
                                           {LevelTarget::Kind::Proportional, 0.9}};

void reverse(LodChain& chain)
{
    for (LodChainLevel& level : chain.levels)
        for (auto& indices : level.indices)
            std::reverse(indices.begin(), indices.end());
}

} // namespace

TEST(SimplifyCached, makesAChainOnceAndFindsItAfterwards)
{
    const TestDirectory directory;
    LodCache cache(directory.path(), kRoomy);
    const test::TestMesh mesh = test::makeTwoMaterials(10, false);
    const Result<LodChain> expected = simplify(mesh.view(), kTargets);
    for (const bool found : {false, true}) {
        const Result<CachedChain> chain = simplifyCached(cache, mesh.view(), kTargets);
        ASSERT_TRUE(chain);
        EXPECT_EQ(chain.value().found, found);
        EXPECT_FALSE(chain.value().notStored);
        EXPECT_TRUE(same(chain.value().chain, expected.value()));
    }
    SimplifyOptions others;
    others.lockBorders = true;
    EXPECT_FALSE(simplifyCached(cache, mesh.view(), kTargets, others).value().found);
}

TEST(SimplifyCached, aChainThatDoesNotFitTheMeshIsMadeAnew)
{
    const TestDirectory directory;
    LodCache cache(directory.path(), kRoomy);
    const test::TestMesh mesh = test::makeTwoMaterials(10, false);
    const CacheKey key = cacheKey(mesh.view(), kTargets);
    const LodChain good = simplify(mesh.view(), kTargets).value();
    const std::vector<std::function<void(LodChain&)>> forgeries = {
        [](LodChain& chain) { chain.levels.pop_back(); },
        [](LodChain& chain) { chain.levels.emplace_back(); },
        [](LodChain& chain) { chain.levels[0].indices.pop_back(); },
        [](LodChain& chain) { chain.levels[0].indices.emplace_back(); },
        [](LodChain& chain) { chain.levels[0].indices[1].pop_back(); },
        [](LodChain& chain) { chain.levels[1].indices.emplace_back(); },
        [&](LodChain& chain) { chain.levels[2].indices[1][0] = mesh.buffers[1].vertexCount(); },
    };
    for (std::size_t i = 0; i < forgeries.size(); ++i) {
        LodChain forged = good;
        forgeries[i](forged);
        ASSERT_TRUE(cache.store(key, forged));
        const Result<CachedChain> chain = simplifyCached(cache, mesh.view(), kTargets);
        ASSERT_TRUE(chain);
        EXPECT_FALSE(chain.value().found) << i;
        EXPECT_TRUE(same(chain.value().chain, good)) << i;
        EXPECT_TRUE(same(cache.find(key).value(), good)) << i;
    }
}

TEST(SimplifyCached, troubleWithTheCacheIsReportedAndDoesNoHarm)
{
    const TestDirectory directory;
    directory.write("file", "");
    LodCache cache(directory / "file/cache", kRoomy);
    const test::TestMesh mesh = test::makeGrid(6, 6);
    const Result<CachedChain> chain = simplifyCached(cache, mesh.view(), kTargets);
    ASSERT_TRUE(chain);
    ASSERT_TRUE(chain.value().notStored);
    EXPECT_EQ(chain.value().notStored->code, ErrorCode::Io);
    EXPECT_TRUE(same(chain.value().chain, simplify(mesh.view(), kTargets).value()));
}

TEST(SimplifyCached, errorsAreThoseOfSimplifyAndAreNotStored)
{
    const TestDirectory directory;
    LodCache cache(directory.path(), kRoomy);
    test::TestMesh mesh = test::makeGrid(6, 6);
    mesh.subMeshes[0].indices[4] = 1000;
    const Result<CachedChain> chain = simplifyCached(cache, mesh.view(), kTargets);
    ASSERT_FALSE(chain);
    EXPECT_EQ(describe(chain.error()), describe(simplify(mesh.view(), kTargets).error()));
    EXPECT_THAT(directory.files(), IsEmpty());
}

TEST(SimplifyCached, whatIsDoneToAChainAfterwardsIsKeptWithItAndNotMistakenForAnother)
{
    const TestDirectory directory;
    LodCache cache(directory.path(), kRoomy);
    const test::TestMesh mesh = test::makeTwoMaterials(10, false);
    const LodChain plain = simplify(mesh.view(), kTargets).value();
    LodChain reversed = plain;
    reverse(reversed);
    int calls = 0;
    const ChainFinish finish{"reversed", [&](LodChain& chain) { reverse(chain), ++calls; }};
    for (const bool found : {false, true}) {
        const Result<CachedChain> chain = simplifyCached(cache, mesh.view(), kTargets, {}, nullptr, {}, finish);
        ASSERT_TRUE(chain);
        EXPECT_EQ(chain.value().found, found);
        EXPECT_TRUE(same(chain.value().chain, reversed));
    }
    EXPECT_EQ(calls, 1);
    const Result<CachedChain> other = simplifyCached(cache, mesh.view(), kTargets);
    EXPECT_FALSE(other.value().found);
    EXPECT_TRUE(same(other.value().chain, plain));
}

TEST(SimplifyCached, whatIsThrownAfterwardsLeavesNothingInTheCache)
{
    const TestDirectory directory;
    LodCache cache(directory.path(), kRoomy);
    const test::TestMesh mesh = test::makeGrid(6, 6);
    const ChainFinish finish{"broken", [](LodChain&) { throw std::runtime_error("no"); }};
    EXPECT_THROW((void)simplifyCached(cache, mesh.view(), kTargets, {}, nullptr, {}, finish), std::runtime_error);
    EXPECT_THAT(directory.files(), IsEmpty());
}

TEST(SimplifyCached, theInputMayGoAsSoonAsItHasBeenReadWhetherTheChainIsFoundOrNot)
{
    const TestDirectory directory;
    LodCache cache(directory.path(), kRoomy);
    const LodChain expected = simplify(test::makeTwoMaterials(10, false).view(), kTargets).value();
    for (const bool found : {false, true}) {
        test::TestMesh mesh = test::makeTwoMaterials(10, false);
        int calls = 0;
        const Result<CachedChain> chain = simplifyCached(cache, mesh.view(), kTargets, {}, nullptr, [&] {
            ++calls;
            mesh = {}; // A sanitizer sees whoever looks at it after this.
        });
        ASSERT_TRUE(chain);
        EXPECT_EQ(chain.value().found, found);
        EXPECT_EQ(calls, 1);
        EXPECT_TRUE(same(chain.value().chain, expected));
    }
}

TEST(SimplifyCached, aCancelWinsOverAChainThatIsThere)
{
    const TestDirectory directory;
    LodCache cache(directory.path(), kRoomy);
    const test::TestMesh mesh = test::makeGrid(6, 6);
    Progress first, second, cancelled;
    ASSERT_FALSE(simplifyCached(cache, mesh.view(), kTargets, {}, &first).value().found);
    ASSERT_TRUE(simplifyCached(cache, mesh.view(), kTargets, {}, &second).value().found);
    EXPECT_EQ(first.fraction(), 1.0f);
    EXPECT_EQ(second.fraction(), 1.0f);
    cancelled.cancel();
    const Result<CachedChain> chain = simplifyCached(cache, mesh.view(), kTargets, {}, &cancelled);
    ASSERT_FALSE(chain);
    EXPECT_EQ(chain.error().code, ErrorCode::Cancelled);
}

} // namespace lodsmith
