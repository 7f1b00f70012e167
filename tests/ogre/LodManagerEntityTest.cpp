#include "LodManagerFixture.h"

#include <support/OgreLog.h>

#include <lodsmith/ogre/MeshWriter.h>

#include <OgreCamera.h>
#include <OgreEntity.h>
#include <OgreMeshManager.h>
#include <OgreRoot.h>
#include <OgreSceneManager.h>
#include <OgreSceneNode.h>

#include <gmock/gmock.h>

namespace lodsmith::test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Definitions that change under entities that live. OGRE ends the process when an entity shows a level of a mesh with hand-made ones
/// that the entity holds no entity for.
class LodManagerEntityTest : public LodManagerTest {
protected:
    LodManagerEntityTest()
    {
        writeMesh("rock.mesh", makeUvSphere(40, 30));
        writeMesh("near.mesh", makeUvSphere(30, 20));
        writeMesh("far.mesh", makeUvSphere(20, 10));
        mScene = Ogre::Root::getSingleton().createSceneManager();
        mCamera = mScene->createCamera("camera");
        mCameraNode = mScene->getRootSceneNode()->createChildSceneNode(Ogre::Vector3(0, 0, 1000));
        mCameraNode->attachObject(mCamera);
    }

    /// Loads the mesh with that definition, and puts an entity of it far away.
    void show(const std::string& definition)
    {
        writeDefinition("rock.loddef", definition);
        mMesh = load("rock.mesh");
        mEntity = mScene->createEntity(mMesh);
        mScene->getRootSceneNode()->createChildSceneNode()->attachObject(mEntity);
    }

    void edit(const std::string& definition)
    {
        writeDefinition("rock.loddef", definition);
        mDefinitions.definitionFor(*mMesh)->reload();
        finish();
    }

    /// What OGRE asserts when it shows the farthest level.
    void expectShowable()
    {
        mScene->getRootSceneNode()->_update(true, false);
        mEntity->_notifyCurrentCamera(mCamera);
        const std::size_t levels = mMesh->getNumLodLevels() - 1u;
        EXPECT_EQ(mEntity->getCurrentLodIndex(), levels);
        if (mMesh->hasManualLodLevel()) {
            EXPECT_GE(mEntity->getNumManualLodLevels(), levels);
        }
    }

    static LodPolicy reinitialising()
    {
        LodPolicy policy;
        policy.reinitialiseEntities = true;
        return policy;
    }

    const std::string kThreeLevels = "<lod><automatic enabled='false'/><manual><level distance='5'/>"
                                     "<level distance='10'><value>0.7</value></level>"
                                     "<level distance='15'><value>0.9</value></level></manual></lod>";
    const std::string kHandMade = handMade({{"20", "near.mesh"}, {"60", "far.mesh"}});
    Ogre::SceneManager* mScene;
    Ogre::Camera* mCamera;
    Ogre::SceneNode* mCameraNode;
    Ogre::MeshPtr mMesh;
    Ogre::Entity* mEntity = nullptr;
};

TEST_F(LodManagerEntityTest, HandMadeLevelsAreRefusedWhileEntitiesLive)
{
    start();
    show(kTwoLevels);
    const OgreLog log;
    edit(kHandMade);
    EXPECT_THAT(values(mMesh), ElementsAre(20.0f, 40.0f)) << "as it was";
    EXPECT_THAT(log.lines(), Contains(HasSubstr("rock.mesh: ")));
    EXPECT_THAT(log.lines(), Contains(HasSubstr("load the mesh again")));
    expectShowable();

    mScene->destroyEntity(mEntity);
    EXPECT_EQ(mManager->apply(mMesh).value(), LodDecision::Attached);
    EXPECT_THAT(values(mMesh), ElementsAre(20.0f, 60.0f));
}

TEST_F(LodManagerEntityTest, HandMadeLevelsReachEntitiesThatAreInitialisedAgain)
{
    start(reinitialising());
    show(kTwoLevels);
    expectShowable();
    edit(kHandMade);
    EXPECT_THAT(values(mMesh), ElementsAre(20.0f, 60.0f));
    expectShowable();
    ASSERT_EQ(mEntity->getNumManualLodLevels(), 2u);
    EXPECT_EQ(mEntity->getManualLodLevel(1)->getMesh()->getName(), "far.mesh");
    for (const std::size_t level : {0u, 1u})
        EXPECT_EQ(mEntity->getManualLodLevel(level)->getParentNode(), mEntity->getParentNode())
            << "is drawn where it is";

    edit(handMade({{"30", "far.mesh"}}));
    expectShowable();
    EXPECT_EQ(mEntity->getManualLodLevel(0)->getMesh()->getName(), "far.mesh");
}

TEST_F(LodManagerEntityTest, LoadingTheMeshAgainAppliesWhatWasRefused)
{
    start();
    show(kTwoLevels);
    edit(kHandMade);
    mMesh->reload();
    EXPECT_THAT(values(mMesh), ElementsAre(20.0f, 60.0f));
    expectShowable();
    EXPECT_EQ(mEntity->getManualLodLevel(0)->getMesh()->getName(), "near.mesh");
}

TEST_F(LodManagerEntityTest, GeneratedLevelsAfterHandMadeOnesAreRefusedWhileEntitiesLive)
{
    start();
    show(kHandMade);
    expectShowable();
    edit(kThreeLevels);
    EXPECT_THAT(values(mMesh), ElementsAre(20.0f, 60.0f)) << "as it was";
    expectShowable();
    mMesh->reload();
    finish();
    EXPECT_THAT(values(mMesh), ElementsAre(5.0f, 10.0f, 15.0f));
    expectShowable();
}

TEST_F(LodManagerEntityTest, GeneratedLevelsAfterHandMadeOnesReachEntitiesThatAreInitialisedAgain)
{
    start(reinitialising());
    show(kHandMade);
    edit(kThreeLevels);
    EXPECT_THAT(values(mMesh), ElementsAre(5.0f, 10.0f, 15.0f));
    expectShowable();
    EXPECT_EQ(mEntity->getManualLodLevel(2), mEntity) << "a generated level is the entity itself";
}

TEST_F(LodManagerEntityTest, ADefinitionWithoutLevelsTakesHandMadeOnesOffLivingEntities)
{
    start();
    show(kHandMade);
    expectShowable();
    edit("<lod><automatic enabled='false'/></lod>");
    EXPECT_THAT(values(mMesh), IsEmpty());
    expectShowable();
}

TEST_F(LodManagerEntityTest, AnEntityMadeWhileLevelsAreOnTheirWayDoesNotEndTheProcess)
{
    start();
    show(kHandMade);
    mScene->destroyEntity(mEntity);
    writeDefinition("rock.loddef", kTwoLevels);
    mDefinitions.definitionFor(*mMesh)->reload();
    mEntity = mScene->createEntity(mMesh);
    mScene->getRootSceneNode()->createChildSceneNode()->attachObject(mEntity);
    std::vector<ErrorCode> failures;
    mQueue->signals().failed.connect([&](const Ogre::MeshPtr&, const Error& error) { failures.push_back(error.code); });
    finish();
    EXPECT_THAT(failures, ElementsAre(ErrorCode::Unsupported));
    EXPECT_THAT(values(mMesh), ElementsAre(20.0f, 60.0f));
    expectShowable();
}

} // namespace
} // namespace lodsmith::test
