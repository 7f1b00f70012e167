#include "RenderTest.h"

#include <support/MeshBuilders.h>
#include <support/OgreMeshBuilder.h>

#include <lodsmith/ogre/ProgressiveMeshGenerator.h>

#include <OgreCamera.h>
#include <OgreEntity.h>
#include <OgreMath.h>
#include <OgreSceneNode.h>
#include <OgreViewport.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>

namespace lodsmith::test {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// How the mesh is looked at.
struct View {
    std::string name;
    float width = 1.0f; ///< shares of the window
    float height = 1.0f;
    float fieldOfView = 45.0f; ///< degrees, from bottom to top
    float scale = 1.0f;        ///< of the entity's node
    bool orthographic = false;
    float yaw = 0.0f; ///< degrees by which the camera looks past the mesh
};

void PrintTo(const View& view, std::ostream* stream)
{
    *stream << view.name;
}

/// At which size on screen the automatic levels appear: when a disc of the bounding sphere's radius, at the mesh's place and
/// turned to the camera, covers as many pixels as the level's value says.
class SwitchSizeTest : public RenderTest, public testing::WithParamInterface<View> {
protected:
    SwitchSizeTest() : RenderTest(1280, 1024) {}

    void SetUp() override
    {
        RenderTest::SetUp();
        if (!mSession)
            return;
        const View& view = GetParam();
        mSession->viewport().setDimensions(0, 0, view.width, view.height);
        mSession->camera().setFOVy(Ogre::Degree(view.fieldOfView));
        mSession->camera().setProjectionType(view.orthographic ? Ogre::PT_ORTHOGRAPHIC : Ogre::PT_PERSPECTIVE);
        // Far off its own origin, as a tree is, whose origin is at its foot: what counts is the sphere around the origin.
        mMesh = makeOgreMesh("mesh", translated(makeUvSphere(96, 64, 3.0), 0.0, 4.0, 0.0));
        ASSERT_TRUE(ProgressiveMeshGenerator().generateAutoconfiguredLodLevels(mMesh));
        mRadius = mMesh->getBoundingSphereRadius();
        mEntity = &showScaled(mMesh);
        mDisc = &showScaled(makeOgreMesh("disc", scaled(makeFan(256), mRadius)));
    }

    void TearDown() override { mMesh.reset(); }

    Ogre::Entity& showScaled(const Ogre::MeshPtr& mesh)
    {
        Ogre::Entity& entity = mSession->show(mesh);
        entity.setMaterialName("BaseWhiteNoLighting");
        entity.getParentSceneNode()->setScale(Ogre::Vector3(GetParam().scale));
        return entity;
    }

    /// Moves the camera to where a pinhole camera sees a disc of the bounding radius with so many pixels.
    void lookAtPixels(double pixels)
    {
        const View& view = GetParam();
        const double height = mSession->viewport().getActualHeight();
        const double radius = mRadius * view.scale, radiusOnScreen = std::sqrt(pixels / kPi);
        mSession->camera().setOrthoWindowHeight(static_cast<Ogre::Real>(height * radius / radiusOnScreen));
        const double focal = height / 2.0 / std::tan(view.fieldOfView / 360.0 * kPi);
        const double distance = view.orthographic ? 10.0 * radius : radius * focal / radiusOnScreen;
        const Ogre::Quaternion turn(Ogre::Degree(view.yaw), Ogre::Vector3::UNIT_Y);
        mSession->cameraNode().setPosition(0, 0, static_cast<Ogre::Real>(distance));
        mSession->cameraNode().setOrientation(turn);
    }

    int shownLevel()
    {
        mEntity->setVisible(true);
        mSession->frame();
        return mEntity->getCurrentLodIndex();
    }

    /// How many pixels the disc has in a picture.
    double measuredPixels()
    {
        mEntity->setVisible(false);
        mDisc->setVisible(true);
        const auto pixels = static_cast<double>(mSession->picture().pixelsCovered());
        mDisc->setVisible(false);
        return pixels;
    }

    bool fits(double pixels) const
    {
        const auto& viewport = mSession->viewport();
        return 2.0 * std::sqrt(pixels / kPi) < std::min(viewport.getActualWidth(), viewport.getActualHeight());
    }

    Ogre::MeshPtr mMesh;
    double mRadius = 0.0;
    Ogre::Entity* mEntity = nullptr;
    Ogre::Entity* mDisc = nullptr;
};

TEST_P(SwitchSizeTest, IsTheLevelsValueInPixels)
{
    ASSERT_GE(mMesh->getNumLodLevels(), 4);
    int measured = 0;
    for (int level = 1; level < mMesh->getNumLodLevels(); ++level) {
        const double value = mMesh->getLodLevel(level).userValue;
        for (const double share : {1.02, 0.98}) {
            SCOPED_TRACE("level " + std::to_string(level) + " at " + std::to_string(share) + " of its size");
            lookAtPixels(share * value);
            EXPECT_EQ(shownLevel(), share > 1.0 ? level - 1 : level);
            if (GetParam().yaw != 0.0f || !fits(share * value))
                continue; // the disc is cut off, or stretched at the picture's side
            EXPECT_NEAR(measuredPixels(), share * value, 0.01 * value);
            ++measured;
        }
    }
    EXPECT_TRUE(measured >= 4 || GetParam().yaw != 0.0f);
}

INSTANTIATE_TEST_SUITE_P(Views, SwitchSizeTest,
                         testing::Values(View{"Standard"}, View{"Telephoto", 1.0f, 1.0f, 15.0f},
                                         View{"WideAngle", 1.0f, 1.0f, 100.0f}, View{"HalfWindow", 0.5f, 0.5f},
                                         View{"Tall", 0.3f, 1.0f}, View{"Flat", 1.0f, 0.3f, 30.0f},
                                         View{"LargerEntity", 1.0f, 1.0f, 45.0f, 7.0f},
                                         View{"Orthographic", 1.0f, 1.0f, 45.0f, 1.0f, true},
                                         View{"TallOrthographic", 0.3f, 1.0f, 45.0f, 2.0f, true},
                                         View{"PastTheMesh", 1.0f, 1.0f, 45.0f, 1.0f, false, 20.0f}),
                         [](const auto& view) { return view.param.name; });

} // namespace
} // namespace lodsmith::test
