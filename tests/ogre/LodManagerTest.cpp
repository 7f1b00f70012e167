#include <support/OgreMeshBuilder.h>
#include <support/OgreSession.h>

#include <lodsmith/ogre/LodManager.h>
#include <lodsmith/ogre/MeshWriter.h>
#include <lodsmith/ogre/ProgressiveMeshGenerator.h>

#include <OgreMeshManager.h>
#include <OgreMeshSerializer.h>

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <memory>

namespace fs = std::filesystem;

namespace lodsmith::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const std::string kTwoLevels = "<lod><automatic enabled='false'/><manual>"
                               "<level distance='20'><value>0.5</value></level>"
                               "<level distance='40'><value>0.75</value></level></manual></lod>";

class LodManagerTest : public testing::Test {
protected:
    void start(const LodPolicy& policy = {}) { mManager = std::make_unique<LodManager>(mDefinitions, mQueue, policy); }

    void writeMesh(const std::string& name, const TestMesh& source, bool withLevels = false)
    {
        const Ogre::MeshPtr mesh = makeOgreMesh("of " + name, source);
        if (withLevels) {
            EXPECT_TRUE(ProgressiveMeshGenerator().generateLodLevels(ownLevel(mesh)));
        }
        Ogre::MeshSerializer().exportMesh(mesh.get(), (mSession.directory() / name).string());
        Ogre::MeshManager::getSingleton().remove(mesh);
        list();
    }

    void writeDefinition(const std::string& name, const std::string& text)
    {
        std::ofstream(mSession.directory() / name) << text;
        list();
    }

    /// Lets OGRE see the files of the session's directory.
    void list()
    {
        auto& groups = Ogre::ResourceGroupManager::getSingleton();
        groups.removeResourceLocation(mSession.directory().string(), mSession.group());
        groups.addResourceLocation(mSession.directory().string(), "FileSystem", mSession.group());
    }

    static LodConfig ownLevel(const Ogre::MeshPtr& mesh)
    {
        LodConfig config;
        config.mesh = mesh;
        config.levels = {{7.0f, {LevelTarget::Kind::Proportional, 0.3}, ""}};
        return config;
    }

    Ogre::MeshPtr load(const std::string& name)
    {
        const Ogre::MeshPtr mesh = Ogre::MeshManager::getSingleton().load(name, mSession.group());
        mQueue.injector().finishAll();
        return mesh;
    }

    static std::vector<Ogre::Real> values(const Ogre::MeshPtr& mesh)
    {
        std::vector<Ogre::Real> values;
        for (Ogre::ushort level = 1; level < mesh->getNumLodLevels(); ++level)
            values.push_back(mesh->getLodLevel(level).userValue);
        return values;
    }

    OgreSession mSession;
    LodDefinitionManager mDefinitions;
    QueuedProgressiveMeshGenerator mQueue;
    std::unique_ptr<LodManager> mManager;
};

struct Lods {
    lodsmith::LodDefinitionManager definitions;
    lodsmith::QueuedProgressiveMeshGenerator queue;
    lodsmith::LodManager manager{definitions, queue};
};

TEST(LodManager, ThreeObjectsAreAll)
{
    OgreSession session;
    Ogre::MeshSerializer().exportMesh(makeOgreMesh("rock", makeUvSphere(40, 30)).get(),
                                      (session.directory() / "rock.mesh").string());
    Lods lods;
    EXPECT_EQ(session.loadSaved("rock.mesh")->getNumLodLevels(), 1);
    lods.queue.injector().finishAll();
    EXPECT_GT(session.loadSaved("rock.mesh")->getNumLodLevels(), 1);
}

TEST_F(LodManagerTest, AMeshThatIsLoadedGetsAutomaticLevels)
{
    writeMesh("rock.mesh", makeUvSphere(40, 30));
    start();
    const Ogre::MeshPtr mesh = load("rock.mesh");
    EXPECT_EQ(values(mesh).size(), automaticLodConfig(mesh).levels.size());
    mesh->reload();
    EXPECT_THAT(values(mesh), IsEmpty()) << "read from the file, and queued again";
    mQueue.injector().finishAll();
    EXPECT_EQ(values(mesh).size(), automaticLodConfig(mesh).levels.size());
}

TEST_F(LodManagerTest, MeshesThatAreThereGetThemToo)
{
    writeMesh("rock.mesh", makeUvSphere(40, 30));
    const Ogre::MeshPtr mesh = load("rock.mesh");
    EXPECT_THAT(values(mesh), IsEmpty());
    start();
    mQueue.injector().finishAll();
    EXPECT_FALSE(values(mesh).empty());
}

TEST_F(LodManagerTest, NothingIsHeardAfterItsEnd)
{
    writeMesh("rock.mesh", makeUvSphere(40, 30));
    start();
    const Ogre::MeshPtr mesh = load("rock.mesh");
    mManager.reset();
    mesh->reload();
    EXPECT_EQ(mQueue.queued(), 0u);
    EXPECT_THAT(values(mesh), IsEmpty());
}

TEST_F(LodManagerTest, ThePolicyChooses)
{
    writeMesh("rock.mesh", makeUvSphere(40, 30));
    writeMesh("pebble.mesh", makeUvSphere(8, 6));
    LodPolicy policy;
    policy.minTriangles = 1000;
    start(policy);
    EXPECT_THAT(values(load("pebble.mesh")), IsEmpty()) << "too few triangles";
    EXPECT_FALSE(values(load("rock.mesh")).empty());

    const auto isChosen = [&](const LodPolicy& chosen) {
        Ogre::MeshManager::getSingleton().remove("rock.mesh", mSession.group());
        mManager->setPolicy(chosen);
        return !values(load("rock.mesh")).empty();
    };
    EXPECT_TRUE(isChosen({}));
    policy = {};
    policy.enabled = false;
    EXPECT_FALSE(isChosen(policy));
    policy = {};
    policy.automatic = false;
    EXPECT_FALSE(isChosen(policy));
    policy = {};
    policy.groups = {"another"};
    EXPECT_FALSE(isChosen(policy));
    policy.groups.push_back(mSession.group());
    EXPECT_TRUE(isChosen(policy));
    policy = {};
    policy.names = {"*tree*"};
    EXPECT_FALSE(isChosen(policy));
    policy.names.emplace_back("ro*.mesh");
    EXPECT_TRUE(isChosen(policy));
}

TEST_F(LodManagerTest, LevelsThatTheMeshBringsStay)
{
    writeMesh("rock.mesh", makeUvSphere(40, 30), true);
    start();
    const Ogre::MeshPtr mesh = load("rock.mesh");
    EXPECT_THAT(values(mesh), ElementsAre(7.0f));
    LodPolicy policy;
    policy.replaceLevels = true;
    mManager->setPolicy(policy);
    mManager->applyToAll();
    mQueue.injector().finishAll();
    EXPECT_EQ(values(mesh).size(), automaticLodConfig(mesh).levels.size());
}

TEST_F(LodManagerTest, ADefinitionCountsWhateverTheMeshIs)
{
    writeMesh("pebble.mesh", makeUvSphere(10, 8), true);
    writeDefinition("pebble.loddef", kTwoLevels);
    start();
    EXPECT_THAT(values(load("pebble.mesh")), ElementsAre(20.0f, 40.0f));
}

TEST_F(LodManagerTest, AnEditedDefinitionIsAppliedWhenItIsReloaded)
{
    writeMesh("rock.mesh", makeUvSphere(40, 30));
    writeDefinition("rock.loddef", kTwoLevels);
    start();
    const Ogre::MeshPtr mesh = load("rock.mesh");
    ASSERT_THAT(values(mesh), ElementsAre(20.0f, 40.0f));
    writeDefinition("rock.loddef", "<lod><automatic enabled='false'/><manual><level distance='9'/></manual></lod>");
    mDefinitions.definitionFor(*mesh)->reload();
    mQueue.injector().finishAll();
    EXPECT_THAT(values(mesh), ElementsAre(9.0f));
    writeDefinition("rock.loddef", "<lod><automatic enabled='false'/></lod>");
    mDefinitions.definitionFor(*mesh)->reload();
    EXPECT_THAT(values(mesh), IsEmpty()) << "a definition without levels";
    writeDefinition("rock.loddef", "<lod/>");
    mDefinitions.definitionFor(*mesh)->reload();
    mQueue.injector().finishAll();
    EXPECT_EQ(values(mesh).size(), automaticLodConfig(mesh).levels.size()) << "automatic again";
}

TEST_F(LodManagerTest, ADefinitionWithErrorsLeavesTheMeshAsItIs)
{
    writeMesh("rock.mesh", makeUvSphere(40, 30), true);
    writeDefinition("rock.loddef", "<lod><manual><level/></manual></lod>");
    start();
    const Ogre::MeshPtr mesh = load("rock.mesh");
    EXPECT_THAT(values(mesh), ElementsAre(7.0f));
    const Result<LodDecision> decision = mManager->apply(mesh);
    ASSERT_FALSE(decision);
    EXPECT_EQ(decision.error().code, ErrorCode::BadFile);
    EXPECT_EQ(decision.error().file, "rock.mesh");
}

TEST_F(LodManagerTest, HandMadeLevelsAreThereWhenTheMeshIsLoadedAndHaveNoneThemselves)
{
    writeMesh("rock.mesh", makeUvSphere(40, 30));
    writeMesh("far.mesh", makeUvSphere(30, 20));
    writeDefinition("rock.loddef", "<lod><automatic enabled='false'/><manual>"
                                   "<level distance='20'><value>0.5</value></level>"
                                   "<level distance='90'><meshName>far.mesh</meshName></level></manual></lod>");
    start();
    const Ogre::MeshPtr mesh = Ogre::MeshManager::getSingleton().load("rock.mesh", mSession.group());
    EXPECT_THAT(values(mesh), ElementsAre(20.0f, 90.0f));
    EXPECT_EQ(mesh->getLodLevel(2).manualName, "far.mesh");
    EXPECT_EQ(mQueue.queued(), 0u);
    EXPECT_EQ(load("far.mesh")->getNumLodLevels(), 1);
}

TEST_F(LodManagerTest, AMeshOfNoFileIsMetWhenItIsLoaded)
{
    start();
    const Ogre::MeshPtr mesh = makeOgreMesh("made", makeUvSphere(40, 30));
    mesh->load();
    mQueue.injector().finishAll();
    EXPECT_TRUE(mesh->isLoaded());
    const Result<LodDecision> decision = mManager->apply(mesh);
    ASSERT_TRUE(decision) << describe(decision.error());
    EXPECT_EQ(decision.value(), LodDecision::Queued);
}

} // namespace
} // namespace lodsmith::test
