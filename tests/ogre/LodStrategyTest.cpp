#include <support/OgreMeshBuilder.h>
#include <support/OgreSession.h>

#include <lodsmith/ogre/DefinedLodConfig.h>
#include <lodsmith/ogre/ProgressiveMeshGenerator.h>
#include <lodsmith/ogre/SwitchDistance.h>

#include <OgreCamera.h>
#include <OgreEntity.h>
#include <OgreLodStrategy.h>
#include <OgreRoot.h>
#include <OgreSceneManager.h>
#include <OgreSceneNode.h>

#include <gtest/gtest.h>

#include <cmath>

namespace lodsmith::test {
namespace {

constexpr double kPi = 3.14159265358979;
constexpr Ogre::Real kAspect = 16.0f / 9.0f;

/// An entity at the origin and a camera that looks at it from somewhere on the z axis.
class LodStrategyTest : public testing::Test {
protected:
    LodStrategyTest()
    {
        mScene = Ogre::Root::getSingleton().createSceneManager();
        mCamera = mScene->createCamera("camera");
        mCamera->setAspectRatio(kAspect);
        mCamera->setFOVy(Ogre::Degree(50));
        mCameraNode = mScene->getRootSceneNode()->createChildSceneNode();
        mCameraNode->attachObject(mCamera);
        mEntity = mScene->createEntity(mMesh);
        mNode = mScene->getRootSceneNode()->createChildSceneNode();
        mNode->attachObject(mEntity);
    }

    /// Gives the mesh one level under a strategy, as a definition says it.
    void define(LodStrategy strategy, float value)
    {
        LodDefinition definition;
        definition.automatic = false;
        definition.strategy = strategy;
        definition.levels.resize(1);
        definition.levels[0].value = value;
        const auto defined = lodConfig(definition, mMesh);
        ASSERT_TRUE(defined) << describe(defined.error());
        const auto report = ProgressiveMeshGenerator().generateLodLevels(defined.value().config);
        ASSERT_TRUE(report) << describe(report.error());
        EXPECT_EQ(mMesh->getLodStrategy()->getName(), ogreName(strategy));
    }

    bool showsLevelOneFrom(double distance)
    {
        mCameraNode->setPosition(0, 0, static_cast<Ogre::Real>(distance));
        mScene->getRootSceneNode()->_update(true, false);
        mEntity->_notifyCurrentCamera(mCamera);
        return mEntity->getCurrentLodIndex() == 1;
    }

    /// The distance between camera and node from which on level 1 is shown.
    double switchDistance()
    {
        double near = 2, far = 10000;
        EXPECT_FALSE(showsLevelOneFrom(near));
        EXPECT_TRUE(showsLevelOneFrom(far));
        while (far - near > 1e-5 * far)
            (showsLevelOneFrom((near + far) / 2) ? far : near) = (near + far) / 2;
        return far;
    }

    /// What the library says about level 1, at scale 1.
    double saidDistance(const View& view = {}) const
    {
        const auto distance = lodsmith::switchDistance(*mMesh, mMesh->getLodLevel(1).userValue, view);
        EXPECT_TRUE(distance) << describe(distance.error());
        return distance.value();
    }

    double radius() const { return mMesh->getBoundingSphereRadius() * mNode->getScale().x; }

    /// The bounding sphere's radius in pixels, on a screen of this height.
    double radiusOnScreen(double distance, double height) const
    {
        return radius() / distance * height / 2 / std::tan(mCamera->getFOVy().valueRadians() / 2);
    }

    OgreSession mSession;
    Ogre::MeshPtr mMesh = makeOgreMesh("mesh", makeUvSphere(20, 10));
    Ogre::SceneManager* mScene;
    Ogre::Camera* mCamera;
    Ogre::SceneNode* mCameraNode;
    Ogre::Entity* mEntity;
    Ogre::SceneNode* mNode;
};

TEST_F(LodStrategyTest, DistanceSphereIsTheLengthOfATangentToTheSphere)
{
    define(LodStrategy::DistanceSphere, 30);
    EXPECT_NEAR(switchDistance(), std::hypot(30, radius()), 1e-2);
    EXPECT_NEAR(switchDistance(), saidDistance(), 1e-2);
    mNode->setScale(10, 10, 10);
    EXPECT_NEAR(switchDistance(), std::hypot(30, radius()), 1e-2);
}

TEST_F(LodStrategyTest, DistanceBoxCountsFromTheBox)
{
    define(LodStrategy::DistanceBox, 30);
    EXPECT_NEAR(switchDistance(), 30 + mMesh->getBounds().getMaximum().z, 1e-2);
    // The sphere's poles lie on an axis, the corners of its sides not quite on the other two.
    EXPECT_NEAR(switchDistance(), saidDistance(), 0.1 * radius());
}

TEST_F(LodStrategyTest, ScreenRatioIsTheShareOfTheSpheresCircle)
{
    // What pixel_count multiplies by the viewport's area.
    constexpr double kHeight = 720;
    define(LodStrategy::ScreenRatioPixelCount, 0.01f);
    for (const Ogre::Real scale : {1.0f, 4.0f})
        for (const Ogre::Real angle : {50.0f, 20.0f}) {
            mNode->setScale(scale, scale, scale);
            mCamera->setFOVy(Ogre::Degree(angle));
            const double circle = kPi * std::pow(radiusOnScreen(switchDistance(), kHeight), 2);
            EXPECT_NEAR(circle / (kHeight * kHeight * kAspect), 0.01, 1e-5);
        }
}

TEST_F(LodStrategyTest, TheSaidDistanceIsWhereOgreSwitches)
{
    define(LodStrategy::ScreenRatioPixelCount, 0.01f);
    for (const double degrees : {50.0, 20.0}) {
        mCamera->setFOVy(Ogre::Degree(static_cast<Ogre::Real>(degrees)));
        EXPECT_NEAR(switchDistance(), saidDistance({1280, 720, degrees * kPi / 180}), 1e-3 * switchDistance());
    }
}

TEST_F(LodStrategyTest, PixelsAndTheirDistanceBelongTogether)
{
    define(LodStrategy::PixelCount, 5000);
    const View view{1280, 720, 50 * kPi / 180};
    EXPECT_NEAR(pixelsAt(*mMesh, saidDistance(view), view), 5000, 1e-6);
    EXPECT_NEAR(kPi * std::pow(radiusOnScreen(saidDistance(view), 720), 2), 5000, 1e-2);
    const auto never = lodsmith::switchDistance(*mMesh, 0, view);
    ASSERT_TRUE(never);
    EXPECT_TRUE(std::isinf(never.value()));
    EXPECT_FALSE(lodsmith::switchDistance(*mMesh, -1, view));
    EXPECT_FALSE(lodsmith::switchDistance(*mMesh, std::nan(""), view));
}

TEST_F(LodStrategyTest, ScreenRatioOfAnOrthographicCameraDoesNotDependOnTheDistance)
{
    define(LodStrategy::ScreenRatioPixelCount, 0.01f);
    mCamera->setProjectionType(Ogre::PT_ORTHOGRAPHIC);
    const double area = kPi * radius() * radius();
    for (const double share : {0.009, 0.011}) {
        const double height = std::sqrt(area / share / kAspect);
        mCamera->setOrthoWindow(static_cast<Ogre::Real>(height * kAspect), static_cast<Ogre::Real>(height));
        EXPECT_EQ(showsLevelOneFrom(5), share < 0.01);
        EXPECT_EQ(showsLevelOneFrom(5000), share < 0.01);
    }
}

TEST_F(LodStrategyTest, PixelCountIsAskedForByItsName)
{
    // It needs a viewport, which needs a window.
    define(LodStrategy::PixelCount, 5000);
    EXPECT_EQ(mMesh->getLodLevel(1).value, 5000);
}

} // namespace
} // namespace lodsmith::test
