#include "RenderTest.h"

#include <support/MeshBuilders.h>
#include <support/OgreMeshBuilder.h>

#include <lodsmith/ogre/DefinedLodConfig.h>
#include <lodsmith/ogre/MeshReader.h>
#include <lodsmith/ogre/MeshWriter.h>
#include <lodsmith/ogre/ProgressiveMeshGenerator.h>
#include <lodsmith/ogre/QueuedProgressiveMeshGenerator.h>

#include <OgreAnimationState.h>
#include <OgreCamera.h>
#include <OgreEntity.h>
#include <OgreLight.h>
#include <OgreMeshSerializer.h>
#include <OgreSceneManager.h>
#include <OgreSceneNode.h>
#include <OgreSubEntity.h>

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <map>
#include <string>
#include <thread>

namespace lodsmith::test {
namespace {

// Far beyond what anything here takes: a test that has gone wrong ends too.
constexpr std::chrono::seconds kPatience(60);

/// The share of the pixels of `a` or `b` that only one of them covers.
double difference(const Picture& a, const Picture& b)
{
    const auto inA = a.silhouette(), inB = b.silhouette();
    double either = 0.0, one = 0.0;
    for (std::size_t i = 0; i < inA.size(); ++i) {
        either += inA[i] || inB[i] ? 1.0 : 0.0;
        one += inA[i] != inB[i] ? 1.0 : 0.0;
    }
    return one / either;
}

double brightness(const Picture& picture)
{
    double sum = 0.0;
    for (const std::uint8_t value : picture.rgb)
        sum += value;
    return sum / static_cast<double>(picture.rgb.size());
}

/// What the levels of a mesh look like, with each forced in turn.
class LevelPicturesTest : public RenderTest {
protected:
    void TearDown() override { mMesh.reset(); }

    static void force(Ogre::Entity& entity, int level)
    {
        const auto index = static_cast<Ogre::ushort>(level);
        entity.setMeshLodBias(1.0f, index, index);
    }

    void generate(const std::vector<double>& removed)
    {
        const auto report = ProgressiveMeshGenerator().generateLodLevels(proportional(mMesh, removed));
        ASSERT_TRUE(report) << describe(report.error());
        ASSERT_EQ(mMesh->getNumLodLevels(), removed.size() + 1);
    }

    void loadDrake() { mMesh = mSession->load(LODSMITH_MEDIA_DIR "/drake/drake.mesh"); }

    /// The drake from its side, filling the picture.
    Ogre::Entity& showWalkingDrake()
    {
        Ogre::Entity& drake = mSession->show(mMesh);
        drake.getAnimationState("walk")->setEnabled(true);
        const Ogre::Vector3 centre = mMesh->getBounds().getCenter();
        mSession->cameraNode().setPosition(centre + Ogre::Vector3(1.8f * mMesh->getBoundingSphereRadius(), 0, 0));
        mSession->cameraNode().setOrientation(Ogre::Quaternion(Ogre::Degree(90), Ogre::Vector3::UNIT_Y));
        return drake;
    }

    Picture pictureAt(Ogre::Entity& walker, double seconds)
    {
        walker.getAnimationState("walk")->setTimePosition(static_cast<Ogre::Real>(seconds));
        return mSession->picture();
    }

    void shine(const Ogre::Vector3& direction)
    {
        Ogre::SceneManager& scene = mSession->scene();
        scene.setAmbientLight(Ogre::ColourValue(0.2f, 0.2f, 0.2f));
        Ogre::Light* sun = scene.createLight();
        sun->setType(Ogre::Light::LT_DIRECTIONAL);
        Ogre::SceneNode* sky = scene.getRootSceneNode()->createChildSceneNode();
        sky->attachObject(sun);
        sky->setDirection(direction);
    }

    /// The mesh above a floor, lit from above.
    Ogre::Entity& showAboveFloor()
    {
        shine({0.2f, -1.0f, -0.1f});
        const Ogre::MeshPtr floorMesh = makeOgreMesh("floor", translated(makeGrid(20, 20, 12.0), -6.0, -6.0, 0.0));
        Ogre::Entity& floor = mSession->show(floorMesh, {0, -2, 0});
        floor.getParentSceneNode()->setOrientation(Ogre::Quaternion(Ogre::Degree(-90), Ogre::Vector3::UNIT_X));
        floor.setCastShadows(false);
        mSession->cameraNode().setPosition(0, 2, 8);
        mSession->cameraNode().setOrientation(Ogre::Quaternion(Ogre::Degree(-15), Ogre::Vector3::UNIT_X));
        return mSession->show(mMesh);
    }

    /// How much darker the picture is for the entity's shadow.
    double shadowOf(Ogre::Entity& caster)
    {
        caster.setCastShadows(true);
        const double with = brightness(mSession->picture());
        caster.setCastShadows(false);
        const double without = brightness(mSession->picture());
        caster.setCastShadows(true);
        return without - with;
    }

    Ogre::MeshPtr mMesh;
};

TEST_F(LevelPicturesTest, SkinnedLevelsWalkLikeTheOriginal)
{
    loadDrake();
    generate({0.5, 0.75, 0.9});
    Ogre::Entity& drake = showWalkingDrake();
    const Picture wholeNow = pictureAt(drake, 0.0), wholeLater = pictureAt(drake, 0.6);
    const double stride = difference(wholeNow, wholeLater);
    ASSERT_GT(stride, 0.05) << "legs that are elsewhere";
    for (const int level : {1, 2, 3}) {
        SCOPED_TRACE("level " + std::to_string(level));
        force(drake, level);
        const Picture now = pictureAt(drake, 0.0), later = pictureAt(drake, 0.6);
        ASSERT_EQ(drake.getCurrentLodIndex(), level);
        EXPECT_GT(difference(now, later), 0.7 * stride);
        // By far nearer to the original at the same moment than at the other.
        EXPECT_LT(difference(now, wholeNow), 0.4 * difference(now, wholeLater));
        EXPECT_LT(difference(later, wholeLater), 0.4 * difference(later, wholeNow));
    }
}

TEST_F(LevelPicturesTest, SkinnedLevelsCastShadowsWhileTheyMove)
{
    mSession->scene().setShadowTechnique(Ogre::SHADOWTYPE_STENCIL_ADDITIVE);
    loadDrake();
    mMesh->buildEdgeList(); // the file has none, and OGRE expects them in files
    generate({0.5, 0.75, 0.9});
    Ogre::Entity& drake = showAboveFloor();
    drake.getParentSceneNode()->setScale(Ogre::Vector3(2.0f / mMesh->getBoundingSphereRadius()));
    drake.getAnimationState("walk")->setEnabled(true);
    std::map<double, double> whole;
    for (const int level : {0, 1, 2, 3}) {
        force(drake, level);
        for (const double seconds : {0.0, 0.3, 0.6}) {
            drake.getAnimationState("walk")->setTimePosition(static_cast<Ogre::Real>(seconds));
            const double shadow = shadowOf(drake);
            EXPECT_GT(shadow, 0.2);
            EXPECT_NEAR(shadow, whole.try_emplace(seconds, shadow).first->second, 0.1 * shadow)
                << "level " << level << " at " << seconds << " s";
            ASSERT_EQ(drake.getCurrentLodIndex(), level);
        }
    }
}

TEST_F(LevelPicturesTest, ALevelWithAnEmptiedSubMeshIsDrawnWithoutIt)
{
    mMesh = makeOgreMesh("mesh", joined(makeUvSphere(24, 16), translated(makeUvSphere(12, 8, 0.5), 2.0, 0.0, 0.0)));
    const auto data = MeshReader::read(*mMesh);
    ASSERT_TRUE(data);
    LodConfig config = proportional(mMesh, {0.5});
    LodChain chain = shortenedChain(data.value().view(), {1.0});
    chain.levels[0].indices[1].clear();
    ASSERT_TRUE(MeshWriter::write(config, data.value(), chain));
    shine({0, 0, -1});
    for (const bool shadows : {false, true}) {
        mSession->scene().setShadowTechnique(shadows ? Ogre::SHADOWTYPE_STENCIL_ADDITIVE : Ogre::SHADOWTYPE_NONE);
        Ogre::Entity& entity = mSession->show(mMesh);
        mSession->cameraNode().setPosition(0, 0, 8);
        const Picture both = mSession->picture();
        force(entity, 1);
        const Picture one = mSession->picture();
        ASSERT_EQ(entity.getCurrentLodIndex(), 1);
        EXPECT_LT(one.pixelsCovered(), both.pixelsCovered());
        force(entity, 0);
        entity.getSubEntity(1)->setVisible(false);
        EXPECT_EQ(mSession->picture().rgb, one.rgb) << (shadows ? "with shadows" : "without");
        mSession->scene().destroyEntity(&entity);
    }
}

TEST_F(LevelPicturesTest, APictureIsNoHandMadeLevel)
{
    // OGRE knows a codec for it here, and throws what is no exception of its own.
    std::ofstream(mSession->directory() / "picture.png") << "paint";
    Ogre::MeshSerializer().exportMesh(makeOgreMesh("sphere", makeUvSphere(20, 12)).get(),
                                      (mSession->directory() / "ball.mesh").string());
    LodDefinition definition;
    definition.automatic = false;
    definition.levels.resize(1);
    definition.levels[0].value = 20;
    definition.levels[0].meshName = "picture.png";
    const auto config = lodConfig(definition, mSession->load(mSession->directory() / "ball.mesh"));
    ASSERT_TRUE(config) << describe(config.error());
    EXPECT_TRUE(config.value().config.levels.empty());
    ASSERT_EQ(config.value().leftOut.size(), 1u);
    EXPECT_NE(config.value().leftOut[0].message.find("\"picture.png\" cannot be loaded"), std::string::npos)
        << describe(config.value().leftOut[0]);
}

TEST_F(LevelPicturesTest, ShadowsFallAtEveryLevelOnceItIsInjected)
{
    mSession->scene().setShadowTechnique(Ogre::SHADOWTYPE_STENCIL_ADDITIVE);
    mMesh = makeOgreMesh("mesh", makeUvSphere(40, 30));
    Ogre::Entity& ball = showAboveFloor();
    const double whole = shadowOf(ball);
    ASSERT_GT(whole, 0.2);
    ASSERT_TRUE(mMesh->isEdgeListBuilt());
    QueuedProgressiveMeshGenerator queue;
    ASSERT_TRUE(queue.generateLodLevels(proportional(mMesh, {0.5, 0.75, 0.9})));
    queue.injector().finishAll();
    ASSERT_EQ(mMesh->getNumLodLevels(), 4);
    for (const int level : {0, 1, 2, 3}) {
        force(ball, level);
        EXPECT_NEAR(shadowOf(ball), whole, 0.1 * whole) << "level " << level;
        EXPECT_EQ(ball.getCurrentLodIndex(), level);
    }
}

TEST_F(LevelPicturesTest, AnEntityShowsItsLevelsFromTheFrameInWhichTheyAreInjected)
{
    mMesh = makeOgreMesh("mesh", makeUvSphere(80, 60));
    Ogre::Entity& ball = mSession->show(mMesh);
    mSession->cameraNode().setPosition(0, 0, 200);
    const std::size_t whole = mSession->frame().triangleCount;
    QueuedProgressiveMeshGenerator queue;
    bool injected = false;
    queue.signals().injected.connect([&](const Ogre::MeshPtr&, const LodReport&) { injected = true; });
    ASSERT_TRUE(queue.generateLodLevels(proportional(mMesh, {0.5, 0.75, 0.9})));
    const auto end = std::chrono::steady_clock::now() + kPatience;
    while (!injected && std::chrono::steady_clock::now() < end) {
        const std::size_t drawn = mSession->frame().triangleCount;
        ASSERT_EQ(drawn < whole, injected);
    }
    ASSERT_TRUE(injected);
    EXPECT_EQ(ball.getCurrentLodIndex(), 3);
    EXPECT_LT(mSession->frame().triangleCount, whole / 5);
}

} // namespace
} // namespace lodsmith::test
