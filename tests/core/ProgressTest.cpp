#include <lodsmith/core/Progress.h>

#include "support/CheckedSimplify.h"
#include "support/MeshBuilders.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>
#include <vector>

namespace lodsmith {

namespace {

using namespace test;

TEST(Progress, StartsAtNothingAndNotCancelled)
{
    const Progress progress;
    EXPECT_EQ(progress.fraction(), 0.0f);
    EXPECT_FALSE(progress.cancelled());
}

TEST(Progress, EndsAtOne)
{
    const TestMesh mesh = makeTerrain(20);
    Progress progress;
    ASSERT_TRUE(simplify(mesh.view(), {removedShare(0.5), removedShare(0.9)}, {}, &progress).ok());
    EXPECT_EQ(progress.fraction(), 1.0f);
    Progress ofNoLevels;
    ASSERT_TRUE(simplify(mesh.view(), {}, {}, &ofNoLevels).ok());
    EXPECT_EQ(ofNoLevels.fraction(), 1.0f);
}

TEST(Progress, NeverFallsAndIsSeenFromAnotherThread)
{
    const TestMesh mesh = makeTerrain(200);
    Progress progress;
    std::atomic<bool> finished{false};
    std::vector<float> seen;
    std::thread watcher([&] {
        while (!finished.load()) {
            const float now = progress.fraction();
            if (seen.empty() || seen.back() != now)
                seen.push_back(now);
        }
        seen.push_back(progress.fraction());
    });
    const bool ok = simplify(mesh.view(), {removedShare(0.5), removedShare(0.95)}, {}, &progress).ok();
    finished = true;
    watcher.join();
    ASSERT_TRUE(ok);
    for (std::size_t i = 1; i < seen.size(); ++i)
        EXPECT_GE(seen[i], seen[i - 1]);
    EXPECT_EQ(seen.back(), 1.0f);
    EXPECT_GT(seen.size(), 3u) << "nothing was reported on the way";
}

TEST(Progress, CancelledBeforeTheStart)
{
    const TestMesh mesh = makeTerrain(20);
    Progress progress;
    progress.cancel();
    const Result<LodChain> result = simplify(mesh.view(), {removedShare(0.5)}, {}, &progress);
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.error().code, ErrorCode::Cancelled);
}

TEST(Progress, CancelledBeforeTheStartOfWorkThatIsNone)
{
    Progress progress;
    progress.cancel();
    const Result<LodChain> result = simplify(MeshView{}, {}, {}, &progress);
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.error().code, ErrorCode::Cancelled);
}

TEST(Progress, CancelledFromAnotherThread)
{
    const TestMesh mesh = makeTerrain(400);
    Progress progress;
    std::thread canceller([&] {
        while (progress.fraction() <= 0.0f)
            std::this_thread::yield();
        progress.cancel();
    });
    const Result<LodChain> result = simplify(mesh.view(), {removedShare(0.99)}, {}, &progress);
    canceller.join();
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.error().code, ErrorCode::Cancelled);
}

TEST(Progress, CancelAfterTheEndChangesNothing)
{
    const TestMesh mesh = makeTerrain(10);
    Progress progress;
    const Result<LodChain> result = simplify(mesh.view(), {removedShare(0.5)}, {}, &progress);
    progress.cancel();
    ASSERT_TRUE(result.ok());
    EXPECT_EQ(result.value().levels.size(), 1u);
}

TEST(InputRead, NothingIsReadAfterwards)
{
    TestMesh mesh = makeTerrain(20);
    const std::vector<LevelTarget> targets = {removedShare(0.5), removedShare(0.9)};
    const Result<LodChain> expected = simplify(mesh.view(), targets);
    int calls = 0;
    const Result<LodChain> result = simplify(mesh.view(), targets, {}, nullptr, [&] {
        ++calls;
        for (TestBuffer& buffer : mesh.buffers) {
            std::fill(buffer.positions.begin(), buffer.positions.end(), std::numeric_limits<float>::quiet_NaN());
            std::fill(buffer.normals.begin(), buffer.normals.end(), std::numeric_limits<float>::quiet_NaN());
        }
        for (TestSubMesh& subMesh : mesh.subMeshes)
            std::fill(subMesh.indices.begin(), subMesh.indices.end(), 0xFFFFFFFFu);
    });
    EXPECT_EQ(calls, 1);
    ASSERT_TRUE(expected.ok() && result.ok());
    for (std::size_t i = 0; i < targets.size(); ++i)
        EXPECT_EQ(result.value().levels[i].indices, expected.value().levels[i].indices);
}

TEST(InputRead, IsNotSaidAfterAnError)
{
    TestMesh mesh = makeTerrain(2);
    mesh.subMeshes[0].indices[0] = 1000;
    const Result<LodChain> result =
        simplify(mesh.view(), {removedShare(0.5)}, {}, nullptr, [] { ADD_FAILURE() << "nothing was read whole"; });
    EXPECT_FALSE(result.ok());
}

} // namespace

} // namespace lodsmith
