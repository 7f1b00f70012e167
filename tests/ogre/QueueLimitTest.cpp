#include "QueueFixture.h"

#include <OgreSubMesh.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <new>
#include <stdexcept>
#include <thread>

namespace lodsmith::test {
namespace {

using std::chrono::milliseconds;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A clock that stands still unless the test moves it.
class QueueBudgetTest : public QueueTest {
protected:
    /// A queue in which the levels of `count` meshes are finished and an injection takes `cost`.
    void makeFinished(std::uint32_t count, milliseconds cost)
    {
        QueueParts parts;
        parts.compute = mGate.compute();
        parts.now = [this] { return mNow; };
        makeQueue(workers(1), parts);
        mQueue->signals().injected.connect([this, cost](const Ogre::MeshPtr&, const LodReport&) { mNow += cost; });
        // One more, which the worker begins when it has handed the others over.
        for (std::uint32_t i = 0; i <= count; ++i)
            enqueue(mMeshes.emplace_back(grid("mesh" + std::to_string(i), 4 + i)));
        mQueue->injector().update();
        mGate.let(static_cast<int>(count));
        mGate.waitForArrivals(count + 1);
    }

    std::size_t injectedByUpdate()
    {
        const std::size_t before = mEvents.size();
        mQueue->injector().update();
        return mEvents.size() - before;
    }

    std::chrono::steady_clock::time_point mNow;
    std::vector<Ogre::MeshPtr> mMeshes;
};

TEST_F(QueueBudgetTest, NothingIsBegunOnceTheBudgetIsUsedUp)
{
    makeFinished(7, milliseconds(1));
    mQueue->injector().setBudget(milliseconds(3));
    EXPECT_EQ(injectedByUpdate(), 3u);
    mQueue->injector().setBudget(PMInjector::Milliseconds(1.5));
    EXPECT_EQ(injectedByUpdate(), 2u) << "what is begun within the budget is done";
    EXPECT_EQ(injectedByUpdate(), 2u);
    EXPECT_EQ(injectedByUpdate(), 0u);
}

TEST_F(QueueBudgetTest, OneInjectionIsDoneHoweverSmallTheBudget)
{
    makeFinished(3, milliseconds(100));
    mQueue->injector().setBudget(milliseconds(0));
    for (int i = 0; i < 3; ++i)
        EXPECT_EQ(injectedByUpdate(), 1u);
    EXPECT_THAT(mEvents, ElementsAre("injected mesh0", "injected mesh1", "injected mesh2"));
}

TEST_F(QueueBudgetTest, InjectNowKnowsNoBudget)
{
    makeFinished(4, milliseconds(100));
    mQueue->injector().setBudget(milliseconds(0));
    mQueue->injector().injectNow();
    EXPECT_EQ(mEvents.size(), 4u);
}

TEST_F(QueueBudgetTest, TheGreatestPriorityIsInjectedFirst)
{
    makeFinished(3, milliseconds(1));
    mQueue->injector().setBudget(milliseconds(0));
    mQueue->setPriority(mMeshes[1], 1.0f);
    injectedByUpdate();
    mQueue->setPriority(mMeshes[2], 2.0f);
    injectedByUpdate();
    EXPECT_THAT(mEvents, ElementsAre("injected mesh1", "injected mesh2"));
}

TEST_F(QueueBudgetTest, CopyingCountsTooAndOneMeshIsCopiedHoweverSmallTheBudget)
{
    QueueParts parts;
    parts.compute = mGate.compute();
    parts.now = [this] { return mNow += milliseconds(1); }; // Every look at the clock takes its time.
    makeQueue(workers(1), parts);
    mQueue->injector().setBudget(milliseconds(0));
    for (std::uint32_t i = 0; i < 4; ++i)
        enqueue(mMeshes.emplace_back(grid("mesh" + std::to_string(i), 8)));
    const std::size_t one = mQueue->heldBytes();
    EXPECT_GT(one, 0u) << "the idle worker gets one at once";
    for (std::size_t held = 2; held <= 4; ++held) {
        mQueue->injector().update();
        EXPECT_EQ(mQueue->heldBytes(), held * one);
    }
}

class QueueMemoryTest : public QueueTest {};

std::size_t bytesOf(const VertexBufferView& buffer)
{
    std::size_t each = buffer.bones ? sizeof(BoneInfluences) : 0;
    for (const FloatStream& stream : {buffer.positions, buffer.normals, buffer.colours})
        each += stream ? stream.stride : 0;
    for (const UvStream& set : buffer.uvSets)
        each += set.stream.stride;
    for (const std::vector<FloatStream>* streams : {&buffer.offsets, &buffer.poses})
        for (const FloatStream& stream : *streams)
            each += stream.stride;
    return each * buffer.vertexCount;
}

std::size_t bytesOf(const PreparedLods& prepared, const LodChain& chain)
{
    std::size_t bytes = 0;
    for (const VertexBufferView& buffer : prepared.data.view().vertexBuffers)
        bytes += bytesOf(buffer);
    for (const SubMeshView& subMesh : prepared.data.view().subMeshes)
        bytes += subMesh.indexCount * static_cast<std::size_t>(subMesh.indexBytes);
    for (const LodChainLevel& level : chain.levels)
        for (const auto& list : level.indices)
            bytes += list.size() * sizeof(std::uint32_t);
    return bytes;
}

TEST_F(QueueMemoryTest, WhatIsCountedCoversTheCopyAndTheLevels)
{
    std::atomic<std::size_t> bytes{0};
    QueueParts parts;
    parts.compute = [&](PreparedLods& prepared, Progress* progress) {
        // Beforehand, as computing lets go of the copy.
        const Result<LodChain> chain = simplify(prepared.data.view(), prepared.targets, prepared.options);
        bytes = bytesOf(prepared, chain.value());
        return mGate.compute()(prepared, progress);
    };
    makeQueue(workers(1), parts);
    const TestMesh sources[] = {makeUvSphere(20, 12), makeSkinnedTube(12, 20), makeClosedLips(12),
                                makeTwoMaterials(12, true), makeTwoMaterials(12, false)};
    std::size_t done = 0;
    for (const OgreMeshOptions options : {OgreMeshOptions{}, OgreMeshOptions{false, true}}) {
        for (const TestMesh& source : sources) {
            const Ogre::MeshPtr mesh = makeOgreMesh("mesh" + std::to_string(done), source, options);
            ASSERT_TRUE(mQueue->generateLodLevels(config(mesh, {0.1, 0.2, 0.3})));
            mGate.waitForArrivals(++done);
            EXPECT_GE(mQueue->heldBytes(), bytes) << done;
            EXPECT_LE(mQueue->heldBytes(), 3 * bytes) << done << ": no idle limit";
            mGate.let(1);
            finish();
        }
    }
}

TEST_F(QueueMemoryTest, AStripCountsWithTheTrianglesItIsReadAs)
{
    std::atomic<std::size_t> bytes{0};
    QueueParts parts;
    parts.compute = [&](PreparedLods& prepared, Progress* progress) {
        bytes = bytesOf(prepared, {});
        return mGate.compute()(prepared, progress);
    };
    makeQueue(workers(1), parts);
    const Ogre::MeshPtr mesh = makeOgreMesh("strip", makeGrid(12, 1));
    std::vector<std::uint32_t> indices;
    for (std::uint32_t i = 0; i <= 12; ++i)
        indices.insert(indices.end(), {i + 13, i});
    setIndices(*mesh->getSubMesh(0), indices, Ogre::RenderOperation::OT_TRIANGLE_STRIP, true);
    enqueue(mesh);
    mGate.waitForArrivals(1);
    EXPECT_GE(mQueue->heldBytes(), bytes);
}

TEST_F(QueueMemoryTest, MeshesAreCopiedAsFarAsTheLimitAllows)
{
    makeQueue(workers(1));
    std::vector<Ogre::MeshPtr> meshes = {grid("measure", 10)};
    enqueue(meshes[0]);
    const std::size_t one = mQueue->heldBytes();

    makeQueue(workers(1, 3 * one + one / 2));
    for (int i = 0; i < 8; ++i)
        enqueue(meshes.emplace_back(grid("mesh" + std::to_string(i), 10)));
    std::size_t most = 0;
    mQueue->signals().injected.connect([&](const Ogre::MeshPtr&, const LodReport&) {
        mQueue->injector().update();
        most = std::max(most, mQueue->heldBytes());
    });
    mQueue->injector().update();
    EXPECT_EQ(mQueue->heldBytes(), 3 * one);
    mGate.open();
    finish();
    EXPECT_EQ(mEvents.size(), 8u);
    EXPECT_LE(most, 3 * one);
    EXPECT_GT(most, 0u);
    EXPECT_EQ(mQueue->heldBytes(), 0u);
}

TEST_F(QueueMemoryTest, OneRequestIsAllowedHoweverLargeAndFinishedLevelsCount)
{
    makeQueue(workers(2, 1));
    const Ogre::MeshPtr first = grid("first", 8);
    const Ogre::MeshPtr second = grid("second", 8);
    enqueue(first);
    enqueue(second);
    mQueue->injector().update();
    const std::size_t one = mQueue->heldBytes();
    mGate.waitForArrivals(1);
    mGate.let(1);
    mGate.waitForEnds(1);
    EXPECT_EQ(mQueue->heldBytes(), one);
    EXPECT_EQ(mGate.arrivals().size(), 1u) << "the second worker has nothing to do";
    mGate.open();
    finish();
    EXPECT_THAT(mEvents, ElementsAre("injected first", "injected second"));
}

TEST_F(QueueMemoryTest, ACancelledComputationCountsUntilItHasStopped)
{
    QueueParts parts;
    std::atomic<bool> stuck{true};
    parts.compute = [&](PreparedLods& prepared, Progress* progress) {
        while (stuck)
            std::this_thread::sleep_for(milliseconds(1));
        return mGate.compute()(prepared, progress);
    };
    makeQueue(workers(1), parts);
    const Ogre::MeshPtr mesh = grid("mesh", 8);
    enqueue(mesh);
    const std::size_t one = mQueue->heldBytes();
    // Until the worker has taken it, a cancelled request holds nothing.
    std::this_thread::sleep_for(milliseconds(50));
    mQueue->cancel(mesh);
    EXPECT_EQ(mQueue->queued(), 0u);
    EXPECT_THAT(mQueue->heldBytes(), testing::AnyOf(0u, one));
    stuck = false;
    mGate.open();
    enqueue(mesh);
    finish();
    EXPECT_EQ(mQueue->heldBytes(), 0u);
    EXPECT_THAT(mEvents, ElementsAre("injected mesh"));
}

class QueueFailureTest : public QueueTest {
protected:
    /// Serves a mesh whose computation is `compute`, and one that has nothing wrong after it.
    void serve(const ComputeFunction& compute)
    {
        QueueParts parts;
        parts.compute = [compute](PreparedLods& prepared, Progress* progress) {
            return verticesOf(prepared) == 25 ? compute(prepared, progress) : computeLods(prepared, progress);
        };
        makeQueue(workers(1), parts);
        mQueue->signals().failed.connect([this](const Ogre::MeshPtr&, const Error& error) { mError = error; });
        enqueue(mBad);
        enqueue(mGood);
        finish();
        EXPECT_EQ(mError.file, "bad");
        EXPECT_EQ(mBad->getNumLodLevels(), 1);
        EXPECT_EQ(mGood->getNumLodLevels(), 2);
        EXPECT_EQ(mQueue->heldBytes(), 0u);
    }

    Ogre::MeshPtr mBad = grid("bad", 4);
    Ogre::MeshPtr mGood = grid("good", 5);
    Error mError;
};

TEST_F(QueueFailureTest, AnExceptionOnAWorkerIsAFailure)
{
    serve([](const PreparedLods&, Progress*) -> Result<ComputedLods> { throw std::runtime_error("of its own"); });
    EXPECT_THAT(mError.message, HasSubstr("of its own"));
}

TEST_F(QueueFailureTest, WhateverIsThrownOnAWorkerIsAFailure)
{
    serve([](const PreparedLods&, Progress*) -> Result<ComputedLods> { throw 7; });
    EXPECT_FALSE(mError.message.empty());
}

TEST_F(QueueFailureTest, WantOfMemoryOnAWorkerIsAFailure)
{
    serve([](const PreparedLods&, Progress*) -> Result<ComputedLods> { throw std::bad_alloc(); });
    EXPECT_EQ(mError.code, ErrorCode::OutOfMemory);
}

TEST_F(QueueFailureTest, AnErrorOfTheCoreIsAFailure)
{
    serve([](PreparedLods& prepared, Progress* progress) {
        PreparedLods wrong;
        wrong.targets = {{LevelTarget::Kind::Proportional, NAN}};
        wrong.options = prepared.options;
        return computeLods(wrong, progress);
    });
    EXPECT_EQ(mError.code, ErrorCode::InvalidSetting);
}

TEST_F(QueueFailureTest, BadGeometryNamesTheMeshsOwnSubMesh)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", joined(makeGrid(2, 2), makeGrid(3, 3)));
    setIndices(*mesh->getSubMesh(0), {0, 1}, Ogre::RenderOperation::OT_LINE_LIST);
    const auto& buffer = mesh->getSubMesh(1)->vertexData->vertexBufferBinding->getBuffer(0);
    const float bad = NAN;
    buffer->writeData(5 * buffer->getVertexSize(), sizeof bad, &bad);
    mGate.open();
    makeQueue(workers(1));
    mQueue->signals().failed.connect([this](const Ogre::MeshPtr&, const Error& error) { mError = error; });
    enqueue(mesh);
    finish();
    EXPECT_EQ(mError.code, ErrorCode::InvalidGeometry);
    EXPECT_EQ(mError.file, "mesh");
    EXPECT_EQ(mError.subMesh, 1);
}

TEST_F(QueueFailureTest, AMeshThatCannotBeReadFailsByTheSignalAndNotWithinTheCall)
{
    const Ogre::MeshPtr mesh = grid("mesh", 4);
    setIndices(*mesh->getSubMesh(0), {0, 1, 999}, Ogre::RenderOperation::OT_TRIANGLE_LIST);
    makeQueue(workers(1));
    enqueue(mesh);
    EXPECT_THAT(mEvents, IsEmpty());
    EXPECT_EQ(mQueue->heldBytes(), 0u);
    mQueue->injector().update();
    EXPECT_THAT(mEvents, ElementsAre("failed mesh: index_out_of_range"));
}

} // namespace
} // namespace lodsmith::test
