#include "QueueFixture.h"

#include <lodsmith/ogre/ProgressiveMeshGenerator.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>

#if defined(__linux__)
#    include <sys/resource.h>
#    include <unistd.h>
#endif

namespace lodsmith::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

/// A queue with one worker that is held up at the gate while others come. The parameter: whether there is memory to copy
/// them, so that they wait for the worker, or not, so that they wait to be copied.
class QueueOrderTest : public QueueTest, public testing::WithParamInterface<bool> {
protected:
    void SetUp() override
    {
        makeQueue(workers(1, GetParam() ? std::size_t(1) << 30 : 1));
        enqueue(mFirst);
        mGate.waitForArrivals(1);
    }

    void finishInOrder()
    {
        mQueue->injector().update();
        mGate.open();
        finish();
    }

    Ogre::MeshPtr mFirst = grid("first", 3);
    Ogre::MeshPtr mA = grid("a", 4);
    Ogre::MeshPtr mB = grid("b", 5);
    Ogre::MeshPtr mC = grid("c", 6);
};

TEST_P(QueueOrderTest, EqualsAreServedInTheOrderTheyCame)
{
    for (const auto& mesh : {mC, mA, mB})
        enqueue(mesh);
    EXPECT_EQ(mQueue->queued(), 4u);
    finishInOrder();
    EXPECT_THAT(mGate.arrivals(), ElementsAre(16, 49, 25, 36));
    EXPECT_THAT(mEvents, ElementsAre("injected first", "injected c", "injected a", "injected b"));
    EXPECT_EQ(mQueue->queued(), 0u);
    EXPECT_EQ(mQueue->heldBytes(), 0u);
}

TEST_P(QueueOrderTest, GreaterPrioritiesGoFirst)
{
    enqueue(mA, 1.0f);
    enqueue(mB, 3.0f);
    enqueue(mC, -2.0f);
    finishInOrder();
    EXPECT_THAT(mGate.arrivals(), ElementsAre(16, 36, 25, 49));
}

TEST_P(QueueOrderTest, APriorityCanBeChangedWhileARequestWaits)
{
    enqueue(mA, 3.0f);
    enqueue(mB, 2.0f);
    enqueue(mC, 1.0f);
    mQueue->injector().update();
    mQueue->setPriority(mC, 4.0f);
    mQueue->setPriority(mA, 2.0f);
    finishInOrder();
    EXPECT_THAT(mGate.arrivals(), ElementsAre(16, 49, 25, 36)) << "among equals the earlier request goes first";
}

TEST_P(QueueOrderTest, ANewerRequestReplacesTheOlderAndWaitsBehindItsEquals)
{
    enqueue(mA);
    enqueue(mB);
    mQueue->injector().update();
    ASSERT_TRUE(mQueue->generateLodLevels(config(mA, {0.4, 0.8})));
    EXPECT_EQ(mQueue->queued(), 3u);
    finishInOrder();
    EXPECT_THAT(mGate.arrivals(), ElementsAre(16, 36, 25));
    EXPECT_THAT(mEvents, ElementsAre("injected first", "injected b", "injected a"));
    EXPECT_EQ(mA->getNumLodLevels(), 3);
}

INSTANTIATE_TEST_SUITE_P(Waiting, QueueOrderTest, testing::Bool(),
                         [](const auto& info) { return info.param ? "copied" : "to_be_copied"; });

class QueuedGeneratorTest : public QueueTest {};

TEST_F(QueuedGeneratorTest, MakesTheSameLevelsAsTheDirectGenerator)
{
    const TestMesh sources[] = {makeUvSphere(40, 30),       makeSkinnedTube(16, 30),     makeClosedLips(12),
                                makeTwoMaterials(20, true), makeTwoMaterials(20, false), makeLeafCards(50)};
    mGate.open();
    makeQueue(workers(3));
    std::vector<Ogre::MeshPtr> direct, queued;
    for (std::size_t i = 0; i < std::size(sources); ++i) {
        direct.push_back(makeOgreMesh("direct" + std::to_string(i), sources[i]));
        queued.push_back(makeOgreMesh("queued" + std::to_string(i), sources[i]));
        ASSERT_TRUE(ProgressiveMeshGenerator().generateLodLevels(config(direct[i], {0.5, 0.75, 0.9})));
        ASSERT_TRUE(mQueue->generateLodLevels(config(queued[i], {0.5, 0.75, 0.9})));
    }
    finish();
    EXPECT_EQ(mEvents.size(), std::size(sources));
    for (std::size_t i = 0; i < std::size(sources); ++i) {
        EXPECT_GT(direct[i]->getNumLodLevels(), 1);
        EXPECT_EQ(levelsOf(*queued[i]), levelsOf(*direct[i])) << i;
        EXPECT_THAT(brokenLevels(*queued[i]), IsEmpty());
    }
}

TEST_F(QueuedGeneratorTest, TheReportIsThatOfTheDirectGenerator)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", makeUvSphere(20, 12));
    const auto direct = ProgressiveMeshGenerator().generateLodLevels(config(mesh, {0.5, 0.75}));
    mGate.open();
    makeQueue(workers(1));
    LodReport report;
    mQueue->signals().injected.connect([&](const Ogre::MeshPtr&, const LodReport& queued) { report = queued; });
    ASSERT_TRUE(mQueue->generateLodLevels(config(mesh, {0.5, 0.75})));
    finish();
    EXPECT_EQ(report.bufferVertices, direct.value().bufferVertices);
    ASSERT_EQ(report.levels.size(), 2u);
    EXPECT_EQ(report.levels[1].triangles, direct.value().levels[1].triangles);
    EXPECT_EQ(report.levels[1].deviation, direct.value().levels[1].deviation);
}

TEST_F(QueuedGeneratorTest, ReturnsAtOnceAndTheFramesDoTheRest)
{
    makeQueue(workers(1));
    const Ogre::MeshPtr mesh = grid("mesh", 8);
    enqueue(mesh);
    EXPECT_TRUE(mQueue->isQueued(mesh));
    mGate.waitForArrivals(1);
    frame();
    EXPECT_EQ(mesh->getNumLodLevels(), 1);
    // A frame collects the end of a computation when the worker has handed it over, a moment after the gate saw it.
    mGate.open();
    for (int i = 0; mQueue->isQueued(mesh) && i < 10000; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        frame();
    }
    EXPECT_FALSE(mQueue->isQueued(mesh));
    EXPECT_EQ(mesh->getNumLodLevels(), 2);
    EXPECT_THAT(mEvents, ElementsAre("injected mesh"));
}

TEST_F(QueuedGeneratorTest, TheAutomaticConfigurationNeedsNoSettings)
{
    mGate.open();
    makeQueue(workers(1));
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", makeTerrain(30));
    ASSERT_TRUE(mQueue->generateAutoconfiguredLodLevels(mesh));
    finish();
    EXPECT_GT(mesh->getNumLodLevels(), 1);
    mesh->_setBoundingSphereRadius(0);
    const auto without = mQueue->generateAutoconfiguredLodLevels(mesh);
    ASSERT_FALSE(without);
    EXPECT_EQ(without.error().code, ErrorCode::InvalidGeometry);
}

TEST_F(QueuedGeneratorTest, WrongSettingsAreRefusedAtOnceAndTheOlderRequestStays)
{
    makeQueue(workers(1));
    const Ogre::MeshPtr mesh = grid("mesh", 8);
    enqueue(mesh);
    LodConfig wrong = config(mesh, {0.5, 0.9});
    wrong.strategy = "nearness";
    const auto refused = mQueue->generateLodLevels(wrong);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::InvalidSetting);
    EXPECT_EQ(refused.error().file, "mesh");
    mGate.open();
    finish();
    EXPECT_EQ(mesh->getNumLodLevels(), 2);
    EXPECT_THAT(mEvents, ElementsAre("injected mesh"));
}

TEST_F(QueuedGeneratorTest, SeveralWorkersComputeAtOnce)
{
    makeQueue(workers(3));
    std::vector<Ogre::MeshPtr> meshes;
    for (std::uint32_t i = 0; i < 5; ++i) {
        meshes.push_back(grid("mesh" + std::to_string(i), 4 + i));
        enqueue(meshes.back());
    }
    mGate.waitForArrivals(3);
    EXPECT_THAT(mGate.arrivals(), UnorderedElementsAre(25, 36, 49));
    mGate.open();
    finish();
    EXPECT_EQ(mEvents.size(), 5u);
}

#if defined(__linux__)
int nicenessOfThisThread()
{
    return getpriority(PRIO_PROCESS, static_cast<id_t>(gettid()));
}

TEST_F(QueuedGeneratorTest, WorkersGiveWayToTheProgram)
{
    const int before = nicenessOfThisThread();
    std::atomic<int> nicenessOfWorker{before};
    QueueParts parts;
    parts.compute = [&](PreparedLods& prepared, Progress* progress) {
        nicenessOfWorker = nicenessOfThisThread();
        return computeLods(prepared, progress);
    };
    makeQueue(workers(1), parts);
    ASSERT_TRUE(mQueue->generateLodLevels(config(grid("grid", 4), {0.5})));
    finish();
    EXPECT_EQ(nicenessOfWorker, std::min(before + 10, 19));
    EXPECT_EQ(nicenessOfThisThread(), before);
}
#endif

TEST_F(QueuedGeneratorTest, ProgressIsToldOnceAnUpdateWhenItHasRisen)
{
    QueueParts parts;
    parts.compute = [this](PreparedLods& prepared, Progress* progress) {
        progress->report(prepared.targets[0].amount > 0.5 ? 0.5f : 0.25f);
        return mGate.compute()(prepared, progress);
    };
    makeQueue(workers(2), parts);
    std::vector<std::string> told;
    mQueue->signals().progress.connect(
        [&](const Ogre::MeshPtr& mesh, float share) { told.push_back(mesh->getName() + " " + std::to_string(share)); });
    const Ogre::MeshPtr half = grid("half", 4);
    const Ogre::MeshPtr quarter = grid("quarter", 5);
    ASSERT_TRUE(mQueue->generateLodLevels(config(half, {0.6})));
    ASSERT_TRUE(mQueue->generateLodLevels(config(quarter, {0.4})));
    mGate.waitForArrivals(2);
    mQueue->injector().update();
    mQueue->injector().update();
    EXPECT_THAT(told, UnorderedElementsAre("half 0.500000", "quarter 0.250000"));
}

} // namespace
} // namespace lodsmith::test
