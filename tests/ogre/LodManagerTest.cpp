#include "LodManagerFixture.h"

#include "../../src/samples/LibraryLods.h"

#include <support/OgreLog.h>

#include <OgreMeshManager.h>
#include <OgreMeshSerializer.h>
#include <OgreRoot.h>

#include <gmock/gmock.h>

#include <filesystem>

namespace lodsmith::test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(LodManager, ThreeObjectsAreAll)
{
    OgreSession session;
    Ogre::MeshSerializer().exportMesh(makeOgreMesh("rock", makeUvSphere(40, 30)).get(),
                                      (session.directory() / "rock.mesh").string());
    samples::LibraryLods lods;
    EXPECT_EQ(session.loadSaved("rock.mesh")->getNumLodLevels(), 1);
    lods.queue.injector().finishAll();
    EXPECT_GT(session.loadSaved("rock.mesh")->getNumLodLevels(), 1);
}

TEST_F(LodManagerTest, AMeshThatIsLoadedGetsAutomaticLevels)
{
    writeMesh("rock.mesh", makeUvSphere(40, 30));
    start();
    const Ogre::MeshPtr mesh = load("rock.mesh");
    EXPECT_EQ(values(mesh), automaticValues(mesh));
    mesh->reload();
    EXPECT_THAT(values(mesh), IsEmpty()) << "read from the file, and queued again";
    mQueue->injector().finishAll();
    EXPECT_EQ(values(mesh), automaticValues(mesh));
}

TEST_F(LodManagerTest, MeshesThatAreThereGetThemToo)
{
    writeMesh("rock.mesh", makeUvSphere(40, 30));
    const Ogre::MeshPtr mesh = load("rock.mesh");
    EXPECT_THAT(values(mesh), IsEmpty());
    start();
    mQueue->injector().finishAll();
    EXPECT_FALSE(values(mesh).empty());
}

TEST_F(LodManagerTest, NothingIsHeardAfterItsEnd)
{
    writeMesh("rock.mesh", makeUvSphere(40, 30));
    start();
    const Ogre::MeshPtr mesh = load("rock.mesh");
    mManager.reset();
    mesh->reload();
    EXPECT_EQ(mQueue->queued(), 0u);
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
    mQueue->injector().finishAll();
    EXPECT_EQ(values(mesh), automaticValues(mesh));
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
    mQueue->injector().finishAll();
    EXPECT_THAT(values(mesh), ElementsAre(9.0f));
    writeDefinition("rock.loddef", "<lod><automatic enabled='false'/></lod>");
    mDefinitions.definitionFor(*mesh)->reload();
    EXPECT_THAT(values(mesh), IsEmpty()) << "a definition without levels";
    writeDefinition("rock.loddef", "<lod/>");
    mDefinitions.definitionFor(*mesh)->reload();
    mQueue->injector().finishAll();
    EXPECT_EQ(values(mesh), automaticValues(mesh)) << "automatic again";
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
    EXPECT_EQ(mQueue->queued(), 0u);
    EXPECT_EQ(load("far.mesh")->getNumLodLevels(), 1);
}

TEST_F(LodManagerTest, AMissingHandMadeLevelIsReportedAndTheRestApplied)
{
    writeMesh("rock.mesh", makeUvSphere(40, 30));
    writeMesh("far.mesh", makeUvSphere(30, 20));
    writeDefinition("rock.loddef", handMade({{"20", "gone.mesh"}, {"90", "far.mesh"}}));
    start();
    const OgreLog log;
    EXPECT_THAT(values(load("rock.mesh")), ElementsAre(90.0f));
    EXPECT_THAT(log.lines(), Contains(HasSubstr("gone.mesh")));
}

TEST_F(LodManagerTest, AMeshWithAutomaticLevelsLosesThemWhenItBecomesAHandMadeLevel)
{
    writeMesh("rock.mesh", makeUvSphere(40, 30));
    writeMesh("far.mesh", makeUvSphere(30, 20));
    writeDefinition("rock.loddef", handMade({{"90", "far.mesh"}}));
    start();
    const Ogre::MeshPtr far = load("far.mesh");
    EXPECT_FALSE(values(far).empty());
    EXPECT_THAT(values(load("rock.mesh")), ElementsAre(90.0f));
    EXPECT_THAT(values(far), IsEmpty());

    far->reload();
    mManager->applyToAll();
    finish();
    EXPECT_THAT(values(far), IsEmpty()) << "and gets none while it is one";
    Ogre::MeshManager::getSingleton().remove("rock.mesh", mSession.group());
    mManager->applyToAll();
    finish();
    EXPECT_FALSE(values(far).empty());
}

TEST_F(LodManagerTest, AHandMadeLevelInAMeshFileGetsNoLevels)
{
    writeMesh("far.mesh", makeUvSphere(30, 20));
    writeMesh("rock.mesh", makeUvSphere(40, 30));
    LodConfig config;
    config.mesh = load("rock.mesh");
    config.levels = {{90.0f, {}, "far.mesh"}};
    ASSERT_TRUE(ProgressiveMeshGenerator().generateLodLevels(config));
    Ogre::MeshSerializer().exportMesh(config.mesh.get(), (mSession.directory() / "rock.mesh").string());
    Ogre::MeshManager::getSingleton().remove(config.mesh);

    start();
    finish();
    const Ogre::MeshPtr far = Ogre::MeshManager::getSingleton().getByName("far.mesh", mSession.group());
    ASSERT_FALSE(values(far).empty());
    EXPECT_THAT(values(load("rock.mesh")), ElementsAre(90.0f));
    EXPECT_THAT(values(far), IsEmpty()) << "OGRE allows none in a manual level";

    removeFile("far.mesh");
    Ogre::MeshManager::getSingleton().removeAll();
    const OgreLog log;
    EXPECT_EQ(load("rock.mesh")->getNumLodLevels(), 2) << "what its file says, whether OGRE can show it or not";
    EXPECT_THAT(log.lines(), Contains(HasSubstr("far.mesh")));
}

TEST_F(LodManagerTest, ARemovedDefinitionLeavesAutomaticLevels)
{
    writeMesh("rock.mesh", makeUvSphere(40, 30), true);
    writeMesh("pebble.mesh", makeUvSphere(8, 6));
    writeDefinition("rock.loddef", kTwoLevels);
    writeDefinition("pebble.loddef", kTwoLevels);
    start();
    const Ogre::MeshPtr rock = load("rock.mesh"), pebble = load("pebble.mesh");
    ASSERT_THAT(values(rock), ElementsAre(20.0f, 40.0f));
    ASSERT_THAT(values(pebble), ElementsAre(20.0f, 40.0f));

    for (const char* name : {"rock.loddef", "pebble.loddef"}) {
        removeFile(name);
        mDefinitions.remove(name, mSession.group());
    }
    Ogre::Root::getSingleton()._fireFrameStarted();
    finish();
    EXPECT_EQ(values(rock), automaticValues(rock)) << "its own had been replaced";
    EXPECT_THAT(values(pebble), IsEmpty()) << "too small for automatic ones";
    rock->reload();
    EXPECT_THAT(values(rock), ElementsAre(7.0f)) << "its own, again";
}

TEST_F(LodManagerTest, ADefinitionThatIsRemovedButHasItsFileStillCounts)
{
    writeMesh("rock.mesh", makeUvSphere(40, 30));
    writeDefinition("rock.loddef", kTwoLevels);
    start();
    const Ogre::MeshPtr mesh = load("rock.mesh");
    mDefinitions.remove("rock.loddef", mSession.group());
    mManager->update();
    finish();
    EXPECT_THAT(values(mesh), ElementsAre(20.0f, 40.0f));
}

TEST_F(LodManagerTest, ADefinitionWhoseFileIsGoneCountsNoMore)
{
    writeMesh("rock.mesh", makeUvSphere(40, 30));
    writeDefinition("rock.loddef", kTwoLevels);
    start();
    const Ogre::MeshPtr mesh = load("rock.mesh");
    removeFile("rock.loddef");
    const OgreLog log;
    mManager->applyToAll();
    finish();
    EXPECT_EQ(values(mesh), automaticValues(mesh));
    mesh->reload();
    finish();
    EXPECT_EQ(values(mesh), automaticValues(mesh));
    writeDefinition("rock.loddef", kTwoLevels);
    mManager->applyToAll();
    finish();
    EXPECT_THAT(values(mesh), ElementsAre(20.0f, 40.0f)) << "it has come again";
    EXPECT_THAT(log.lines(), Not(Contains(HasSubstr("rock.loddef"))));
}

TEST_F(LodManagerTest, AGroupIsClearedWithoutAdo)
{
    writeMesh("rock.mesh", makeUvSphere(40, 30));
    writeDefinition("rock.loddef", kTwoLevels);
    start();
    {
        const Ogre::MeshPtr mesh = load("rock.mesh");
        ASSERT_THAT(values(mesh), ElementsAre(20.0f, 40.0f));
    }
    Ogre::ResourceGroupManager::getSingleton().clearResourceGroup(mSession.group());
    mManager->update();
    EXPECT_EQ(mQueue->queued(), 0u);
}

TEST_F(LodManagerTest, AMeshThatAllWereRemovedWithIsNotListenedTo)
{
    writeMesh("rock.mesh", makeUvSphere(40, 30));
    start();
    const Ogre::MeshPtr mesh = load("rock.mesh");
    Ogre::MeshManager::getSingleton().removeAll();
    mManager.reset();
    mesh->reload();
    EXPECT_THAT(values(mesh), IsEmpty());
}

TEST_F(LodManagerTest, AnUnloadedMeshLosesItsRequestAndIsMetAnewWhenItIsLoaded)
{
    writeMesh("rock.mesh", makeUvSphere(40, 30), true);
    start();
    const Ogre::MeshPtr mesh = Ogre::MeshManager::getSingleton().load("rock.mesh", mSession.group());
    writeDefinition("rock.loddef", kTwoLevels);
    EXPECT_EQ(mManager->apply(mesh).value(), LodDecision::Queued);
    mesh->unload();
    finish();
    EXPECT_EQ(mesh->getNumLodLevels(), 1);
    removeFile("rock.loddef");
    mesh->load();
    finish();
    EXPECT_THAT(values(mesh), ElementsAre(7.0f)) << "its own";
}

TEST_F(LodManagerTest, AutomaticLevelsAreAsThePolicySays)
{
    writeMesh("rock.mesh", makeUvSphere(40, 30));
    writeMesh("stone.mesh", makeUvSphere(40, 30));
    writeDefinition("stone.loddef", "<lod><automatic enabled='true'/></lod>");
    LodPolicy policy;
    policy.automaticLods.metric = Metric::Quadric;
    policy.automaticLods.levels = 2;
    policy.automaticLods.pixels = 2;
    start(policy);
    for (const char* name : {"rock.mesh", "stone.mesh"}) {
        const Ogre::MeshPtr mesh = load(name);
        EXPECT_EQ(values(mesh).size(), 2u);
        EXPECT_EQ(values(mesh), automaticValues(mesh, policy.automaticLods));
    }
    policy.automaticLods.levels = 9;
    mManager->setPolicy(policy);
    const Ogre::MeshPtr mesh = load("rock.mesh");
    const Result<LodDecision> decision = mManager->apply(mesh);
    ASSERT_FALSE(decision);
    EXPECT_EQ(decision.error().code, ErrorCode::InvalidSetting);
    EXPECT_EQ(values(mesh).size(), 2u);
}

TEST_F(LodManagerTest, WhatThePolicyDoesNotAskForAnyMoreGoes)
{
    writeMesh("rock.mesh", makeUvSphere(40, 30));
    writeMesh("own.mesh", makeUvSphere(40, 30), true);
    start();
    const Ogre::MeshPtr rock = load("rock.mesh"), own = load("own.mesh");
    LodPolicy policy;
    policy.automatic = false;
    mManager->setPolicy(policy);
    ASSERT_FALSE(values(rock).empty()) << "for meshes that are loaded from now on";
    mManager->applyToAll();
    EXPECT_THAT(values(rock), IsEmpty());
    EXPECT_THAT(values(own), ElementsAre(7.0f)) << "not given by the manager";
}

TEST_F(LodManagerTest, AMeshOfNoFileIsMetWhenItIsLoaded)
{
    start();
    const Ogre::MeshPtr mesh = makeOgreMesh("made", makeUvSphere(40, 30));
    mesh->load();
    mQueue->injector().finishAll();
    EXPECT_GT(mesh->getNumLodLevels(), 1);
}

TEST_F(LodManagerTest, AnotherDefinitionCountsOnce)
{
    writeMesh("rock.mesh", makeUvSphere(40, 30));
    writeDefinition("rock.loddef", kTwoLevels);
    start();
    const Ogre::MeshPtr mesh = load("rock.mesh");
    EXPECT_THAT(values(mesh), ElementsAre(20, 40));

    LodDefinition other;
    other.automatic = false;
    other.levels.resize(1);
    other.levels[0].value = 7;
    EXPECT_EQ(mManager->apply(mesh, other).value(), LodDecision::Queued);
    finish();
    EXPECT_THAT(values(mesh), ElementsAre(7));

    other.automatic = true;
    EXPECT_EQ(mManager->apply(mesh, other).value(), LodDecision::Queued);
    finish();
    EXPECT_EQ(values(mesh), automaticValues(mesh));

    other.automatic = false;
    other.levels.clear();
    EXPECT_EQ(mManager->apply(mesh, other).value(), LodDecision::Removed);
    EXPECT_THAT(values(mesh), IsEmpty());

    EXPECT_EQ(mManager->apply(mesh).value(), LodDecision::Queued);
    finish();
    EXPECT_THAT(values(mesh), ElementsAre(20, 40)) << "its own again";
}

TEST_F(LodManagerTest, AnotherDefinitionWithErrorsChangesNothing)
{
    writeMesh("rock.mesh", makeUvSphere(40, 30));
    writeDefinition("rock.loddef", kTwoLevels);
    start();
    const Ogre::MeshPtr mesh = load("rock.mesh");
    LodDefinition wrong;
    wrong.automatic = false;
    wrong.levels.resize(1);
    EXPECT_EQ(mManager->apply(mesh, wrong).error().code, ErrorCode::InvalidSetting);
    EXPECT_THAT(values(mesh), ElementsAre(20, 40));
    EXPECT_EQ(mQueue->queued(), 0u);
}

} // namespace
} // namespace lodsmith::test
