#include "LodManagerFixture.h"

#include <OgreEntity.h>
#include <OgreMeshManager.h>
#include <OgreRoot.h>
#include <OgreSceneManager.h>
#include <OgreSubMesh.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <vector>

namespace lodsmith::test {
namespace {

using testing::IsEmpty;

using Values = std::vector<Ogre::Real>;

/// How many operations: 10000, or what the environment asks for.
int operationCount()
{
    const char* asked = std::getenv("LODSMITH_STRESS_REQUESTS");
    return asked ? std::atoi(asked) : 10000;
}

/// What a definition file holds.
enum class Kind { None, Automatic, Generated, Broken, Empty, HandMade };

/// A mesh, and the book that is kept of it.
struct Rock {
    std::string name;
    std::uint32_t triangles = 0;
    bool bringsLevels = false;
    Ogre::MeshPtr mesh;
    std::vector<Ogre::Entity*> entities;
    bool isStale = false; ///< OGRE will make the entities anew with the next frame
    Kind kind = Kind::None;
    Values asked;       ///< by the definition
    Values expected;    ///< when all has ended
    bool skips = false; ///< levels of those expected may be missing, since they remove nothing
    bool given = false; ///< has levels of the manager's
    bool own = false;   ///< before this operation it had levels that were not

    std::string definitionName() const { return name.substr(0, name.find('.')) + ".loddef"; }
};

/// Does to a LodManager, a queue, definitions, meshes and entities, in any order, all that a program may do, and keeps book of what has
/// to come of it.
class LodManagerStressTest : public LodManagerTest {
protected:
    LodManagerStressTest()
    {
        mScene = Ogre::Root::getSingleton().createSceneManager();
        writeMesh("far0.mesh", makeUvSphere(6, 4));
        writeMesh("far1.mesh", makeGrid(3, 3));
        for (std::uint32_t i = 0; i < 32; ++i) {
            const std::uint32_t size = 4 + i % 12;
            const TestMesh source = i % 2 == 0 ? makeGrid(size, size) : makeUvSphere(2 * size, size);
            Rock rock;
            rock.name = "rock" + std::to_string(i) + ".mesh";
            rock.bringsLevels = i % 5 == 0;
            writeMesh(rock.name, source, rock.bringsLevels);
            mRocks.push_back(rock);
        }
        makeQueue();
        start(mPolicy);
        for (Rock& rock : mRocks)
            loadFirst(rock);
    }

    ~LodManagerStressTest() override
    {
        for (Rock& rock : mRocks)
            while (!rock.entities.empty())
                destroyEntity(rock);
    }

    // What has to happen.

    bool isWanted(const Rock& rock) const
    {
        return mManager && mPolicy.enabled && (mPolicy.names.empty() || rock.name.compare(0, 5, "rock1") == 0);
    }

    void expect(Rock& rock, const Values& values, bool skips = false)
    {
        rock.expected = values;
        rock.skips = skips;
        rock.given = true;
    }

    void expectNone(Rock& rock)
    {
        rock.expected.clear();
        rock.given = false;
    }

    void expectLoaded(Rock& rock)
    {
        rock.given = false;
        rock.own = rock.bringsLevels;
        rock.skips = false;
        rock.expected = rock.bringsLevels ? Values{7} : Values{};
        rock.isStale = true;
        expectPolicy(rock, true);
    }

    void expectPolicy(Rock& rock, bool isLoading = false)
    {
        if (isWanted(rock) && rock.mesh->isLoaded())
            expectDecision(rock, isLoading);
    }

    void expectDecision(Rock& rock, bool isLoading)
    {
        const bool entitiesForbid = !rock.entities.empty() && !isLoading && !mPolicy.reinitialiseEntities;
        const bool allowed = !entitiesForbid || !rock.mesh->hasManualLodLevel();
        switch (rock.kind) {
        case Kind::Broken: break;
        case Kind::Empty: expectNone(rock); break;
        case Kind::Generated:
            if (allowed)
                expect(rock, rock.asked);
            break;
        case Kind::HandMade:
            if (!entitiesForbid)
                expect(rock, rock.asked);
            break;
        case Kind::None:
            if (!mPolicy.automatic || (rock.own && !mPolicy.replaceLevels) || rock.triangles < mPolicy.minTriangles) {
                if (rock.given)
                    expectNone(rock);
                break;
            }
            [[fallthrough]];
        case Kind::Automatic:
            if (allowed)
                expect(rock, automaticValues(rock), true);
        }
    }

    Values automaticValues(const Rock& rock) const
    {
        Values values;
        for (const LodLevel& level : automaticLodConfig(rock.mesh, mPolicy.automaticLods).levels)
            values.push_back(level.value);
        return values;
    }

    /// What is on its way will not come.
    void expectDropped(Rock& rock)
    {
        if (mQueue->isQueued(rock.mesh))
            expectAsItIs(rock);
    }

    void expectAsItIs(Rock& rock)
    {
        rock.expected = values(rock.mesh);
        rock.skips = false;
    }

    static bool isAsExpected(const Rock& rock)
    {
        const Values found = values(rock.mesh);
        if (!rock.skips)
            return found == rock.expected;
        return std::includes(rock.expected.rbegin(), rock.expected.rend(), found.rbegin(), found.rend());
    }

    /// OGRE ends the process over entities that do not hold one entity a level of a mesh with hand-made levels, and over
    /// hand-made levels with levels.
    static void checkWhatOgreAsserts(const Rock& rock)
    {
        const std::size_t levels = rock.mesh->getNumLodLevels() - 1u;
        for (const Ogre::Entity* entity : rock.entities)
            if (rock.mesh->hasManualLodLevel() && !rock.isStale) {
                EXPECT_GE(entity->getNumManualLodLevels(), levels) << rock.name;
            }
        for (std::size_t level = 1; level <= levels; ++level)
            if (const Ogre::MeshPtr& manual = rock.mesh->getLodLevel(static_cast<Ogre::ushort>(level)).manualMesh) {
                EXPECT_EQ(manual->getNumLodLevels(), 1) << rock.name;
            }
    }

    // What can be done.

    void loadFirst(Rock& rock)
    {
        rock.mesh = Ogre::MeshManager::getSingleton().load(rock.name, mSession.group());
        rock.triangles = static_cast<std::uint32_t>(rock.mesh->getSubMesh(0)->indexData->indexCount / 3);
        expectLoaded(rock);
    }

    void makeQueue()
    {
        QueueOptions options;
        options.workers = 1 + mRandom.bits() % 3;
        options.memoryLimit = mRandom.bits() % 3 == 0 ? 100000 : std::size_t(1) << 28;
        options.frameBudget = std::chrono::microseconds(mRandom.bits() % 500);
        mQueue = std::make_unique<QueuedProgressiveMeshGenerator>(options);
        mQueue->signals().injected.connect([this](const Ogre::MeshPtr& mesh, const LodReport&) {
            ++mInjected;
            EXPECT_TRUE(isAsExpected(rockOf(mesh))) << mesh->getName();
        });
        // An entity that came while levels were on their way to a mesh that once had hand-made ones.
        mQueue->signals().failed.connect([this](const Ogre::MeshPtr& mesh, const Error& error) {
            EXPECT_TRUE(mesh->hasManualLodLevel() && error.code == ErrorCode::Unsupported) << describe(error);
            expectAsItIs(rockOf(mesh));
        });
    }

    Rock& rockOf(const Ogre::MeshPtr& mesh)
    {
        return *std::find_if(mRocks.begin(), mRocks.end(), [&](const Rock& rock) { return rock.mesh == mesh; });
    }

    /// Two levels under any strategy. The values tell definitions apart.
    std::string makeDefinition(Rock& rock)
    {
        const std::string strategies[] = {"distance_sphere", "distance_box", "pixel_count", "screen_ratio_pixel_count"};
        const std::uint32_t strategy = mRandom.bits() % 4;
        mNextValue += 2;
        rock.asked = {mNextValue, mNextValue + 1};
        if (strategy >= 2)
            std::swap(rock.asked[0], rock.asked[1]);
        std::string text = "<lod><automatic enabled='false'/><manual><strategy>" + strategies[strategy] + "</strategy>";
        const auto level = [&](std::size_t i, const std::string& content) {
            text += "<level distance='" + std::to_string(static_cast<int>(rock.asked[i])) + "'>" + content + "</level>";
        };
        if (rock.kind == Kind::Empty)
            rock.asked.clear();
        if (rock.kind == Kind::Generated) {
            level(0, "<value>0.4</value>");
            level(1, "<value>0.8</value>");
        }
        if (rock.kind == Kind::HandMade) {
            const bool mixed = mRandom.bits() % 2 == 0, missing = mRandom.bits() % 4 == 0;
            level(0, mixed ? "<value>0.5</value>" : "<meshName>far1.mesh</meshName>");
            level(1, missing ? "<meshName>gone.mesh</meshName>" : "<meshName>far0.mesh</meshName>");
            if (missing)
                rock.asked.pop_back();
            if (mixed && missing)
                rock.kind = Kind::Generated; // is what is left of it
        }
        return text + "</manual></lod>";
    }

    void editDefinition(Rock& rock)
    {
        const std::string name = rock.definitionName();
        rock.kind = static_cast<Kind>(mRandom.bits() % 6);
        switch (rock.kind) {
        case Kind::None:
            removeFile(name);
            if (!mDefinitions.resourceExists(name, mSession.group()))
                return;
            mDefinitions.remove(name, mSession.group());
            if (mManager)
                mManager->update();
            break;
        case Kind::Automatic: writeAndReload(rock, "<lod/>"); break;
        case Kind::Broken: writeAndReload(rock, "<lod><automatic enabled='perhaps'/></lod>"); break;
        default: writeAndReload(rock, makeDefinition(rock));
        }
        expectPolicy(rock);
    }

    void writeAndReload(const Rock& rock, const std::string& text)
    {
        writeDefinition(rock.definitionName(), text);
        const bool isThere = mDefinitions.resourceExists(rock.definitionName(), mSession.group());
        const LodDefinitionResourcePtr definition = mDefinitions.definitionFor(*rock.mesh);
        ASSERT_TRUE(definition);
        if (isThere)
            definition->reload();
    }

    void loadOrUnload(Rock& rock)
    {
        if (rock.mesh->isLoaded()) {
            rock.mesh->unload();
            rock.given = false;
        } else {
            rock.mesh->load();
            expectLoaded(rock);
        }
    }

    void reload(Rock& rock)
    {
        if (!rock.mesh->isLoaded())
            return;
        rock.mesh->reload();
        expectLoaded(rock);
    }

    void destroyAndLoadAgain(Rock& rock)
    {
        while (!rock.entities.empty())
            destroyEntity(rock);
        Ogre::MeshManager::getSingleton().remove(rock.mesh->getHandle());
        rock.mesh.reset();
        loadFirst(rock);
    }

    void createEntity(Rock& rock)
    {
        const bool wasLoaded = rock.mesh->isLoaded();
        Ogre::Entity* entity = mScene->createEntity(rock.mesh);
        if (!wasLoaded)
            expectLoaded(rock);
        rock.entities.push_back(entity);
    }

    void destroyEntity(Rock& rock)
    {
        if (rock.entities.empty())
            return;
        mScene->destroyEntity(rock.entities.back());
        rock.entities.pop_back();
    }

    void apply(Rock& rock)
    {
        if (!mManager || !rock.mesh->isLoaded())
            return;
        (void)mManager->apply(rock.mesh);
        expectDecision(rock, false);
    }

    void drawFrame()
    {
        Ogre::Root::getSingleton()._fireFrameStarted();
        for (Rock& rock : mRocks) {
            if (!rock.mesh->isLoaded())
                continue;
            if (std::exchange(rock.isStale, false))
                for (Ogre::Entity* entity : rock.entities)
                    entity->_initialise(true);
            checkWhatOgreAsserts(rock);
        }
    }

    void changePolicy()
    {
        mPolicy.enabled = mRandom.bits() % 8 != 0;
        mPolicy.automatic = mRandom.bits() % 4 != 0;
        mPolicy.replaceLevels = mRandom.bits() % 2 == 0;
        mPolicy.reinitialiseEntities = mRandom.bits() % 2 == 0;
        mPolicy.minTriangles = mRandom.bits() % 2 == 0 ? 60 : 200;
        mPolicy.automaticLods.method = AutomaticLods::Method::Classic; // whose levels are known beforehand
        mPolicy.automaticLods.metric = mRandom.bits() % 2 == 0 ? Metric::Curvature : Metric::Quadric;
        mPolicy.automaticLods.levels = 1 + mRandom.bits() % AutomaticLods::kMaxLevels;
        mPolicy.automaticLods.pixels = mRandom.uniform(0.1, 10);
        mPolicy.names.clear();
        if (mRandom.bits() % 4 == 0)
            mPolicy.names.emplace_back("rock1*");
        if (!mManager)
            return;
        mManager->setPolicy(mPolicy);
        if (mRandom.bits() % 2 == 0)
            return;
        mManager->applyToAll();
        for (Rock& rock : mRocks)
            expectPolicy(rock);
    }

    void cancel(Rock& rock)
    {
        expectDropped(rock);
        mQueue->cancel(rock.mesh);
    }

    void markAsChanged(Rock& rock)
    {
        expectDropped(rock);
        rock.mesh->_dirtyState();
        rock.isStale = true;
    }

    void endManager()
    {
        mManager.reset();
        for (Rock& rock : mRocks)
            rock.given = false;
    }

    void beginManager()
    {
        if (mManager)
            return;
        noteOwnLevels();
        start(mPolicy);
        for (Rock& rock : mRocks)
            expectPolicy(rock);
    }

    void endQueue()
    {
        endManager();
        for (Rock& rock : mRocks)
            expectDropped(rock);
        mQueue.reset();
        makeQueue();
    }

    void noteOwnLevels()
    {
        for (Rock& rock : mRocks)
            rock.own = rock.mesh->getNumLodLevels() > 1 && !rock.given;
    }

    void rarely()
    {
        switch (mRandom.bits() % 8) {
        case 0: endQueue(); break;
        case 1: endManager(); break;
        case 2:
            std::for_each(mRocks.begin(), mRocks.end(), [this](Rock& rock) { expectDropped(rock); });
            mQueue->cancelAll();
            break;
        case 3: Ogre::MeshManager::getSingleton().load("far0.mesh", mSession.group())->reload(); break;
        case 4:
        case 5: finish(); break;
        default: changePolicy();
        }
    }

    void doAnything()
    {
        noteOwnLevels();
        Rock& rock = mRocks[mRandom.bits() % mRocks.size()];
        doAnythingTo(rock);
        checkLevels(rock);
    }

    void checkLevels(const Rock& rock)
    {
        if (rock.mesh->isLoaded() && !mQueue->isQueued(rock.mesh)) {
            EXPECT_TRUE(isAsExpected(rock)) << rock.name << ": " << testing::PrintToString(values(rock.mesh)) << " for "
                                            << testing::PrintToString(rock.expected);
        }
    }

    void doAnythingTo(Rock& rock)
    {
        switch (mRandom.bits() % 20) {
        case 0:
        case 1:
        case 2:
        case 3: return editDefinition(rock);
        case 4:
        case 5: return loadOrUnload(rock);
        case 6: return reload(rock);
        case 7: return destroyAndLoadAgain(rock);
        case 8: return apply(rock);
        case 9:
        case 10: return createEntity(rock);
        case 11: return destroyEntity(rock);
        case 12: return cancel(rock);
        case 13: return markAsChanged(rock);
        case 14: return rarely();
        case 15: return beginManager();
        default: return drawFrame();
        }
    }

    TestRandom mRandom{1977};
    Ogre::SceneManager* mScene;
    LodPolicy mPolicy = [] {
        LodPolicy policy;
        policy.minTriangles = 60;
        return policy;
    }();
    std::vector<Rock> mRocks;
    Ogre::Real mNextValue = 10;
    int mInjected = 0;
};

TEST_F(LodManagerStressTest, EveryMeshEndsAsItsDefinitionOrThePolicyAsks)
{
    const int count = operationCount();
    for (int i = 0; i < count && !HasFailure(); ++i) {
        SCOPED_TRACE("operation " + std::to_string(i));
        doAnything();
    }
    finish();
    drawFrame();
    std::size_t withLevels = 0;
    for (const Rock& rock : mRocks) {
        if (!rock.mesh->isLoaded())
            continue;
        checkLevels(rock);
        EXPECT_THAT(brokenLevels(*rock.mesh), IsEmpty()) << rock.name;
        withLevels += rock.mesh->getNumLodLevels() > 1;
    }
    EXPECT_EQ(mQueue->queued(), 0u);
    EXPECT_EQ(mQueue->heldBytes(), 0u);
    EXPECT_GT(mInjected, 0);
    EXPECT_GT(withLevels, 0u);
    RecordProperty("injected", mInjected);
}

} // namespace
} // namespace lodsmith::test
