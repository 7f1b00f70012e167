#include "QueueFixture.h"

#include <OgreMeshManager.h>
#include <OgreMeshSerializer.h>
#include <OgreSubMesh.h>

#include <gmock/gmock.h>

#include <functional>
#include <stdexcept>
#include <tuple>
#include <utility>

namespace lodsmith::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// How far a request has come.
enum class Stage { ToBeCopied, Copied, Running, Finished };
const char* const kStages[] = {"to_be_copied", "copied", "running", "finished"};

/// What happens to it there.
enum class Event { Cancel, CancelAll, Replace, Unload, Reload, Destroy, MarkAsChanged, DestroyQueue };
const char* const kEvents[] = {"cancel", "cancel_all", "replace",         "unload",
                               "reload", "destroy",    "mark_as_changed", "destroy_queue"};

class QueueLifetimeTest : public QueueTest, public testing::WithParamInterface<std::tuple<Stage, Event>> {
protected:
    /// Puts a request for mMesh where the stage says. Up to there mBlocker keeps the one worker busy.
    void bringTo(Stage stage)
    {
        makeQueue(workers(1, stage == Stage::ToBeCopied ? 1 : std::size_t(1) << 30));
        if (stage == Stage::ToBeCopied || stage == Stage::Copied) {
            enqueue(mBlocker);
            mGate.waitForArrivals(1);
        }
        enqueue(mMesh);
        mQueue->injector().update();
        if (stage == Stage::Running)
            mGate.waitForArrivals(1);
        if (stage == Stage::Finished) {
            // The worker has handed the first over when it begins with the second.
            enqueue(mBlocker);
            mQueue->injector().setBudget(PMInjector::Milliseconds(0));
            mQueue->injector().update();
            mGate.let(1);
            mGate.waitForArrivals(2);
        }
        ASSERT_EQ(mMesh->getNumLodLevels(), 1);
        ASSERT_TRUE(mQueue->isQueued(mMesh));
    }

    void happen(Event event)
    {
        switch (event) {
        case Event::Cancel: mQueue->cancel(mMesh); break;
        case Event::CancelAll: mQueue->cancelAll(); break;
        case Event::Replace: ASSERT_TRUE(mQueue->generateLodLevels(config(mMesh, {0.3, 0.6, 0.9}))); break;
        case Event::Unload: mMesh->unload(); break;
        case Event::Reload: mMesh->reload(); break;
        case Event::Destroy:
            Ogre::MeshManager::getSingleton().remove(mMesh->getHandle());
            mMesh.reset();
            EXPECT_TRUE(mWeak.expired()) << "the queue keeps no mesh alive";
            break;
        case Event::MarkAsChanged: mMesh->_dirtyState(); break;
        case Event::DestroyQueue: mQueue.reset(); break;
        }
    }

    Ogre::MeshPtr mBlocker = grid("blocker", 3);
    Ogre::MeshPtr mMesh = mSession.saveAndReload(grid("source", 6));
    std::weak_ptr<Ogre::Mesh> mWeak = mMesh;
};

TEST_P(QueueLifetimeTest, NothingComesOfAnOutdatedRequest)
{
    const auto [stage, event] = GetParam();
    const std::string name = mMesh->getName();
    bringTo(stage);
    happen(event);
    mGate.open();
    if (mQueue) {
        finish();
        EXPECT_EQ(mQueue->queued(), 0u);
        EXPECT_EQ(mQueue->heldBytes(), 0u);
    }

    const bool blocked = stage != Stage::Running && event != Event::CancelAll && event != Event::DestroyQueue;
    std::vector<std::string> expected;
    if (blocked)
        expected.emplace_back("injected blocker");
    if (event == Event::Replace)
        expected.push_back("injected " + name);
    EXPECT_THAT(mEvents, testing::UnorderedElementsAreArray(expected));
    if (mMesh) {
        EXPECT_EQ(mMesh->isLoaded(), event != Event::Unload) << "the queue loads no mesh";
        EXPECT_EQ(mMesh->getNumLodLevels(), event == Event::Replace ? 4 : 1);
    }
}

INSTANTIATE_TEST_SUITE_P(
    Each, QueueLifetimeTest,
    testing::Combine(testing::Values(Stage::ToBeCopied, Stage::Copied, Stage::Running, Stage::Finished),
                     testing::Values(Event::Cancel, Event::CancelAll, Event::Replace, Event::Unload, Event::Reload,
                                     Event::Destroy, Event::MarkAsChanged, Event::DestroyQueue)),
    [](const auto& info) {
        return std::string(kEvents[static_cast<int>(std::get<1>(info.param))]) + "_when_"
               + kStages[static_cast<int>(std::get<0>(info.param))];
    });

class QueuedMeshTest : public QueueTest {};

TEST_F(QueuedMeshTest, AMeshThatWasNeverLoadedIsServedAsTheDirectGeneratorDoes)
{
    mGate.open();
    makeQueue(workers(1));
    const Ogre::MeshPtr empty = Ogre::MeshManager::getSingleton().createManual("empty", mSession.group());
    enqueue(empty);
    finish();
    EXPECT_THAT(mEvents, ElementsAre("failed empty: unsupported"));
}

TEST_F(QueuedMeshTest, AMeshWhoseBuffersChangedUnnoticedFailsInsteadOfBreaking)
{
    makeQueue(workers(1));
    const Ogre::MeshPtr mesh = grid("mesh", 6);
    enqueue(mesh);
    mGate.waitForArrivals(1);
    mesh->getSubMesh(0)->vertexData->vertexCount -= 1;
    mGate.open();
    finish();
    mesh->getSubMesh(0)->vertexData->vertexCount += 1;
    EXPECT_THAT(mEvents, ElementsAre("failed mesh: invalid_geometry"));
    EXPECT_EQ(mesh->getNumLodLevels(), 1);
}

class QueueShutdownTest : public QueueTest {};

TEST_F(QueueShutdownTest, AQueueThatIsNeverUsedGoesAway)
{
    makeQueue(workers(4));
    mQueue.reset();
    frame();
}

TEST_F(QueueShutdownTest, CancelsComputationsInsteadOfWaitingForThem)
{
    makeQueue(workers(2));
    std::vector<Ogre::MeshPtr> meshes;
    for (std::uint32_t i = 0; i < 6; ++i)
        enqueue(meshes.emplace_back(grid("mesh" + std::to_string(i), 4 + i)));
    mGate.waitForArrivals(2);
    mQueue->injector().update();
    mQueue.reset(); // The gate is shut: only a cancelled computation gets through.
    EXPECT_THAT(mEvents, IsEmpty());
    EXPECT_EQ(mGate.arrivals().size(), 2u) << "what waited was never begun";
}

TEST(QueueAfterOgreTest, OgreMayBeTakenDownFirst)
{
    auto session = std::make_unique<OgreSession>();
    auto queue = std::make_unique<QueuedProgressiveMeshGenerator>();
    Ogre::MeshPtr mesh = makeOgreMesh("mesh", makeUvSphere(40, 30));
    ASSERT_TRUE(queue->generateAutoconfiguredLodLevels(mesh));
    mesh.reset();
    session.reset();
    queue.reset();
}

/// What handlers of the signals may do.
class QueueHandlerTest : public QueueTest {
protected:
    void SetUp() override
    {
        mGate.open();
        makeQueue(workers(2));
        for (std::uint32_t i = 0; i < 4; ++i)
            mMeshes.push_back(grid("mesh" + std::to_string(i), 4 + i));
    }

    void enqueueAll()
    {
        for (const Ogre::MeshPtr& mesh : mMeshes)
            enqueue(mesh);
    }

    void onFirstInjection(std::function<void()> act)
    {
        mQueue->signals().injected.connect([this, act = std::move(act)](const Ogre::MeshPtr&, const LodReport&) {
            if (mEvents.size() == 1)
                act();
        });
    }

    std::vector<Ogre::MeshPtr> mMeshes;
};

TEST_F(QueueHandlerTest, TheRequestIsOutOfTheQueueWhenItIsReported)
{
    std::vector<bool> queued;
    mQueue->signals().injected.connect(
        [&](const Ogre::MeshPtr& mesh, const LodReport&) { queued.push_back(mQueue->isQueued(mesh)); });
    enqueueAll();
    finish();
    EXPECT_THAT(queued, ElementsAre(false, false, false, false));
}

TEST_F(QueueHandlerTest, MayCancelAll)
{
    onFirstInjection([&] { mQueue->cancelAll(); });
    enqueueAll();
    finish();
    EXPECT_EQ(mEvents.size(), 1u);
    EXPECT_EQ(mQueue->heldBytes(), 0u);
}

TEST_F(QueueHandlerTest, MayQueueAgain)
{
    onFirstInjection([&] { enqueueAll(); });
    enqueueAll();
    finish();
    EXPECT_EQ(mEvents.size(), 5u) << "the first once more, the others replaced";
}

TEST_F(QueueHandlerTest, MayWorkOnTheQueueItself)
{
    onFirstInjection([&] { finish(); });
    enqueueAll();
    finish();
    EXPECT_EQ(mEvents.size(), 4u);
}

TEST_F(QueueHandlerTest, MayDestroyTheOtherMeshes)
{
    onFirstInjection([&] {
        for (const Ogre::MeshPtr& mesh : mMeshes)
            Ogre::MeshManager::getSingleton().remove(mesh->getHandle());
        mMeshes.clear();
    });
    enqueueAll();
    finish();
    EXPECT_EQ(mEvents.size(), 1u);
}

TEST_F(QueueHandlerTest, MayThrow)
{
    onFirstInjection([] { throw std::runtime_error("no"); });
    enqueueAll();
    EXPECT_THROW(finish(), std::runtime_error);
    finish();
    EXPECT_EQ(mEvents.size(), 4u);
}

TEST_F(QueueHandlerTest, MayDestroyTheQueueWhereverItWorks)
{
    const std::function<void()> calls[] = {[&] { finish(); },
                                           [&] {
                                               while (mQueue)
                                                   frame();
                                           },
                                           [&] {
                                               while (mQueue)
                                                   mQueue->injector().injectNow();
                                           }};
    for (const auto& call : calls) {
        mEvents.clear();
        if (!mQueue)
            makeQueue(workers(2));
        onFirstInjection([&] { mQueue.reset(); });
        bool later = false;
        mQueue->signals().injected.connect([&](const Ogre::MeshPtr&, const LodReport&) { later = true; });
        enqueueAll();
        call();
        EXPECT_FALSE(mQueue);
        EXPECT_EQ(mEvents.size(), 1u);
        EXPECT_FALSE(later) << "nothing is emitted after the queue has gone, not even the rest of a signal";
        frame();
    }
}

TEST_F(QueueHandlerTest, OfAFailureMayDestroyTheQueueToo)
{
    mQueue->signals().failed.connect([&](const Ogre::MeshPtr&, const Error&) { mQueue.reset(); });
    const Ogre::MeshPtr empty = Ogre::MeshManager::getSingleton().createManual("empty", mSession.group());
    enqueue(empty);
    enqueueAll();
    finish();
    EXPECT_FALSE(mQueue);
}

/// Checking and copying may load manual levels, and OGRE tells listeners of that in the middle of it.
class QueueLoadingTest : public QueueTest, public Ogre::MeshSerializerListener {
protected:
    void SetUp() override
    {
        mGate.open();
        makeQueue(workers(1));
        mMesh = makeOgreMesh("mesh", makeUvSphere(20, 12));
        mOther = grid("other", 5);
        mManual = mSession.saveAndReload(grid("source", 4));
        mManual->unload();
        Ogre::MeshManager::getSingleton().setListener(this);
    }

    void TearDown() override { Ogre::MeshManager::getSingleton().setListener(nullptr); }

    LodConfig withManualLevel()
    {
        LodConfig result = config(mMesh, {0.5, 0.75});
        result.levels[1].manualMeshName = mManual->getName();
        mMesh->changeGroupOwnership(mManual->getGroup());
        return result;
    }

    void processMaterialName(Ogre::Mesh*, Ogre::String*) override {}
    void processSkeletonName(Ogre::Mesh*, Ogre::String*) override {}
    void processMeshCompleted(Ogre::Mesh*) override
    {
        if (auto act = std::exchange(mAct, nullptr))
            act();
    }

    Ogre::MeshPtr mMesh, mOther, mManual;
    std::function<void()> mAct;
};

TEST_F(QueueLoadingTest, OthersMayBeQueuedMeanwhile)
{
    mAct = [&] { enqueue(mOther); };
    ASSERT_TRUE(mQueue->generateLodLevels(withManualLevel()));
    finish();
    EXPECT_THAT(mEvents, testing::UnorderedElementsAre("injected mesh", "injected other"));
    EXPECT_EQ(mMesh->getNumLodLevels(), 3);
}

TEST_F(QueueLoadingTest, TheQueueMayGoWhileARequestComes)
{
    mAct = [&] { mQueue.reset(); };
    ASSERT_TRUE(mQueue->generateLodLevels(withManualLevel()));
    EXPECT_FALSE(mQueue);
}

/// A request whose manual level was unloaded again while it waits to be copied.
class QueueLoadingWhileCopyingTest : public QueueLoadingTest {
protected:
    void SetUp() override
    {
        QueueLoadingTest::SetUp();
        makeQueue(workers(1, 1));
        // There is room for one, which is not free before an update.
        const Ogre::MeshPtr blocker = grid("blocker", 3);
        enqueue(blocker);
        ASSERT_TRUE(mQueue->generateLodLevels(withManualLevel()));
        mQueue->cancel(blocker);
        mManual->unload();
    }
};

TEST_F(QueueLoadingWhileCopyingTest, OthersMayBeQueued)
{
    mAct = [&] { enqueue(mOther); };
    finish();
    EXPECT_THAT(mEvents, ElementsAre("injected mesh", "injected other"));
}

TEST_F(QueueLoadingWhileCopyingTest, TheRequestMayBeCancelled)
{
    mAct = [&] { mQueue->cancelAll(); };
    finish();
    EXPECT_THAT(mEvents, IsEmpty());
    EXPECT_EQ(mQueue->heldBytes(), 0u);
}

TEST_F(QueueLoadingWhileCopyingTest, TheQueueMayGo)
{
    mAct = [&] { mQueue.reset(); };
    finish();
    EXPECT_FALSE(mQueue);
}

} // namespace
} // namespace lodsmith::test
