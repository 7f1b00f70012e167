#include "QueueFixture.h"

#include <support/TestDirectory.h>

#include <lodsmith/cache/LodCache.h>

#include <OgreMeshManager.h>

#include <gmock/gmock.h>

#include <chrono>
#include <cstdlib>
#include <map>
#include <thread>

namespace lodsmith::test {
namespace {

using testing::IsEmpty;

/// How many requests: 10000, or what the environment asks for.
int requestCount()
{
    const char* asked = std::getenv("LODSMITH_STRESS_REQUESTS");
    return asked ? std::atoi(asked) : 10000;
}

/// Does to a queue and its meshes, in any order, all that a program may do, and keeps book of what has to come of it: every
/// request that nothing happened to ends with its levels on its mesh, and no other does.
class QueueStressTest : public testing::Test {
protected:
    QueueStressTest()
    {
        for (std::uint32_t i = 0; i < 48; ++i) {
            const std::uint32_t size = 4 + i % 16;
            const TestMesh source = i % 2 == 0 ? makeGrid(size, size) : makeUvSphere(2 * size, size);
            const Ogre::MeshPtr built = makeOgreMesh("source" + std::to_string(i), source);
            mMeshes.push_back(mSession.saveAndReload(built));
            Ogre::MeshManager::getSingleton().remove(built->getHandle());
        }
        start();
    }

    void start()
    {
        QueueOptions options;
        options.workers = 1 + mRandom.bits() % 3;
        options.memoryLimit = mRandom.bits() % 3 == 0 ? 100000 : std::size_t(1) << 28;
        options.frameBudget = std::chrono::microseconds(mRandom.bits() % 500);
        if (mRandom.bits() % 2 == 0)
            options.cache = mCache;
        mQueue = std::make_unique<QueuedProgressiveMeshGenerator>(options);
        mQueue->signals().injected.connect([this](const Ogre::MeshPtr& mesh, const LodReport& report) {
            mFromCache += report.fromCache ? 1 : 0;
            EXPECT_FALSE(report.notStored);
            checkInjection(*mesh);
        });
        mQueue->signals().failed.connect(
            [](const Ogre::MeshPtr&, const Error& error) { ADD_FAILURE() << describe(error); });
        mQueue->signals().progress.connect([this](const Ogre::MeshPtr& mesh, float share) {
            EXPECT_EQ(mExpected.count(mesh->getName()), 1u);
            EXPECT_LE(share, 1.0f);
        });
    }

    void shutDown()
    {
        mQueue.reset();
        mExpected.clear();
        start();
    }

    void checkInjection(Ogre::Mesh& mesh)
    {
        const auto expected = mExpected.find(mesh.getName());
        ASSERT_NE(expected, mExpected.end()) << "an outdated result for " << mesh.getName();
        EXPECT_EQ(mesh.getLodLevel(1).userValue, expected->second) << "the result of an older request";
        mExpected.erase(expected);
        ++mInjected;
        if (mRandom.bits() % 8 == 0)
            disturb();
    }

    Ogre::MeshPtr& anyMesh() { return mMeshes[mRandom.bits() % mMeshes.size()]; }

    void enqueue()
    {
        const Ogre::MeshPtr& mesh = anyMesh();
        mesh->load();
        LodConfig config;
        config.mesh = mesh;
        // The value of the first level tells the requests apart.
        const auto value = static_cast<Ogre::Real>(++mRequests);
        const std::uint32_t levels = 1 + mRandom.bits() % 3;
        for (std::uint32_t i = 0; i < levels; ++i)
            config.levels.push_back({value + static_cast<Ogre::Real>(i) / 4,
                                     {LevelTarget::Kind::Proportional, 0.3 + 0.1 * (mRandom.bits() % 7)},
                                     {}});
        const auto queued = mQueue->generateLodLevels(config, static_cast<float>(mRandom.bits() % 4));
        ASSERT_TRUE(queued) << describe(queued.error());
        mExpected[mesh->getName()] = value;
    }

    void destroyAndLoadAgain(Ogre::MeshPtr& mesh)
    {
        const std::string name = mesh->getName();
        Ogre::MeshManager::getSingleton().remove(mesh->getHandle());
        mesh.reset();
        mesh = Ogre::MeshManager::getSingleton().load(name, mSession.group());
    }

    /// Something that makes results worthless, or moves them.
    void disturb()
    {
        Ogre::MeshPtr& mesh = anyMesh();
        const std::string name = mesh->getName();
        switch (mRandom.bits() % 8) {
        case 0: mQueue->cancel(mesh); break;
        case 1: mesh->unload(); break;
        case 2: // Only what is loaded; on others it does nothing.
            mesh->load();
            mesh->reload();
            break;
        case 3: destroyAndLoadAgain(mesh); break;
        case 4: mesh->_dirtyState(); break;
        case 5: mQueue->setPriority(mesh, static_cast<float>(mRandom.bits() % 4)); return;
        default: enqueue(); return;
        }
        mExpected.erase(name);
    }

    void rarely()
    {
        switch (mRandom.bits() % 8) {
        case 0:
            mQueue->cancelAll();
            mExpected.clear();
            break;
        case 1: shutDown(); break;
        case 2:
        case 3: mQueue->injector().finishAll(); break;
        default: std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    }

    OgreSession mSession;
    TestDirectory mDirectory;
    // Too small for all that is generated, so that there is always something to throw out.
    std::shared_ptr<LodCache> mCache = std::make_shared<LodCache>(mDirectory.path(), 1 << 16);
    TestRandom mRandom{2012};
    std::vector<Ogre::MeshPtr> mMeshes;
    std::map<std::string, Ogre::Real> mExpected; ///< by mesh: the value of its first level, when its request has ended
    int mRequests = 0;
    int mInjected = 0;
    int mFromCache = 0;
    std::unique_ptr<QueuedProgressiveMeshGenerator> mQueue;
};

TEST_F(QueueStressTest, EveryRequestEndsAsItShould)
{
    const int count = requestCount();
    while (mRequests < count) {
        const std::uint32_t dice = mRandom.bits() % 64;
        if (dice < 32)
            enqueue();
        else if (dice < 48)
            mQueue->injector().update();
        else if (dice < 52)
            mQueue->injector().injectNow();
        else if (dice < 60)
            disturb();
        else
            rarely();
    }
    mQueue->injector().finishAll();
    EXPECT_THAT(mExpected, IsEmpty()) << "requests without an end";
    EXPECT_EQ(mQueue->queued(), 0u);
    EXPECT_EQ(mQueue->heldBytes(), 0u);
    RecordProperty("injected", mInjected);
    RecordProperty("from_cache", mFromCache);
    EXPECT_GT(mInjected, mFromCache);
    EXPECT_GT(mFromCache, 0);
    for (const Ogre::MeshPtr& mesh : mMeshes) {
        mesh->load();
        EXPECT_THAT(brokenLevels(*mesh), IsEmpty()) << mesh->getName();
    }
}

} // namespace
} // namespace lodsmith::test
