#include <support/OgreMeshBuilder.h>
#include <support/OgreSession.h>

#include <lodsmith/core/Assert.h>
#include <lodsmith/ogre/DefinedLodConfig.h>
#include <lodsmith/ogre/LodDefinitionManager.h>
#include <lodsmith/ogre/MeshReader.h>
#include <lodsmith/ogre/MeshWriter.h>
#include <lodsmith/ogre/ProgressiveMeshGenerator.h>
#include <lodsmith/ogre/QueuedProgressiveMeshGenerator.h>

#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>
#include <thread>

namespace lodsmith::test {
namespace {

void throwMessage(const char*, const char* message, const char*, int)
{
    throw std::runtime_error(message);
}

/// The message of the assert that `work` fails on another thread; empty when it does not.
std::string failureElsewhere(const std::function<void()>& work)
{
    std::string message;
    const AssertHandler before = setAssertHandler(&throwMessage);
    std::thread([&] {
        try {
            work();
        } catch (const std::runtime_error& failure) {
            message = failure.what();
        }
    }).join();
    setAssertHandler(before);
    return message;
}

TEST(MainThreadTest, EveryCallOfTheAdapterAssertsIt)
{
    OgreSession session;
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", makeGrid(2, 2));
    const auto data = MeshReader::read(*mesh);
    ASSERT_TRUE(data);
    const std::string expected = "the OGRE adapter was called off the main thread";

    EXPECT_EQ(failureElsewhere([&] { (void)MeshReader::read(*mesh); }), expected);
    EXPECT_EQ(failureElsewhere([&] {
                  (void)MeshWriter::write({mesh, "distance_sphere", {}, {}, false}, data.value(), {});
              }),
              expected);
    EXPECT_EQ(failureElsewhere([&] { MeshWriter::removeLevels(*mesh); }), expected);
    EXPECT_EQ(failureElsewhere([&] { (void)automaticLodConfig(mesh); }), expected);
    EXPECT_EQ(failureElsewhere([&] { (void)lodConfig(LodDefinition(), mesh); }), expected);
    EXPECT_EQ(failureElsewhere([&] { (void)LodDefinitionManager(); }), expected);
    LodDefinitionManager definitions;
    EXPECT_EQ(failureElsewhere([&] { (void)definitions.definitionFor(*mesh); }), expected);
    EXPECT_EQ(failureElsewhere([&] {
                  (void)ProgressiveMeshGenerator().generateLodLevels({mesh, "distance_sphere", {}, {}, false});
              }),
              expected);
    EXPECT_EQ(failureElsewhere([&] { (void)ProgressiveMeshGenerator().generateAutoconfiguredLodLevels(mesh); }),
              expected);
}

TEST(MainThreadTest, EveryCallOfTheQueueAssertsIt)
{
    OgreSession session;
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", makeGrid(2, 2));
    QueuedProgressiveMeshGenerator queue;
    const std::function<void()> calls[] = {
        [&] {
            (void)queue.generateLodLevels({mesh, "distance_sphere", {}, {}, false});
        },
        [&] { (void)queue.generateAutoconfiguredLodLevels(mesh); },
        [&] { queue.setPriority(mesh, 1.0f); },
        [&] { queue.cancel(mesh); },
        [&] { queue.cancelAll(); },
        [&] { (void)queue.isQueued(mesh); },
        [&] { (void)queue.queued(); },
        [&] { (void)queue.heldBytes(); },
        [&] { (void)queue.signals(); },
        [&] { queue.injector().update(); },
        [&] { queue.injector().injectNow(); },
        [&] { queue.injector().finishAll(); },
        [&] { const QueuedProgressiveMeshGenerator other; },
    };
    for (const auto& call : calls)
        EXPECT_EQ(failureElsewhere(call), "the OGRE adapter was called off the main thread");
}

} // namespace
} // namespace lodsmith::test
