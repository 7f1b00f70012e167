#include "RenderTest.h"

#include <support/MeshBuilders.h>
#include <support/OgreMeshBuilder.h>

#include <lodsmith/ogre/ProgressiveMeshGenerator.h>
#include <lodsmith/render/LevelRenderer.h>
#include <lodsmith/render/SeenLevels.h>

#include <OgreCamera.h>
#include <OgreEntity.h>
#include <OgreSceneNode.h>
#include <OgreViewport.h>

#include <gtest/gtest.h>

#include <cmath>

namespace lodsmith::test {
namespace {

constexpr double kPi = 3.14159265358979323846;

class SeenLevelsTest : public RenderTest {
protected:
    void SetUp() override
    {
        RenderTest::SetUp();
        mOptions.closeUpSize = 64;
    }

    std::vector<SeenLevel> measure(const Ogre::MeshPtr& mesh)
    {
        const auto renderer = LevelRenderer::create(mesh);
        EXPECT_TRUE(renderer) << describe(renderer.error());
        const auto levels = measureSeenLevels(*renderer.value(), mOptions);
        EXPECT_TRUE(levels) << describe(levels.error());
        return levels ? levels.value() : std::vector<SeenLevel>();
    }

    SeenOptions mOptions;
};

void expectNone(const PaintedDifference& difference)
{
    for (const SeenDifference& seen : {difference.lit, difference.checker}) {
        EXPECT_EQ(seen.largest, 0);
        EXPECT_EQ(seen.mean, 0);
        EXPECT_EQ(seen.ssim, 1);
        EXPECT_EQ(seen.leastSsim, 1);
        EXPECT_EQ(seen.silhouetteShare, 0);
        EXPECT_EQ(seen.silhouetteDistance, 0);
        EXPECT_EQ(seen.coverage, 1);
        EXPECT_EQ(seen.leastCoverage, 1);
    }
}

TEST_F(SeenLevelsTest, AMeshDoesNotDifferFromItself)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", makeTorus(24, 12)), same = makeOgreMesh("same", makeTorus(24, 12));
    setHandMadeLevel(*mesh, "same");
    const std::vector<SeenLevel> levels = measure(mesh);
    ASSERT_EQ(levels.size(), 2u);
    for (const SeenLevel& level : levels) {
        EXPECT_EQ(level.triangles, 2u * 24 * 12);
        expectNone(level.atSwitch);
        expectNone(level.popping);
        expectNone(level.closeUp);
    }
}

TEST_F(SeenLevelsTest, ASmallerSphereCoversLess)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", makeIcosphere(4)),
                        small = makeOgreMesh("small", makeIcosphere(4, 0.9));
    setHandMadeLevel(*mesh, "small");
    const SeenLevel level = measure(mesh).at(1);
    // By distance_sphere, at 10: 8 directions, all of which see the same disc.
    const double radius = mesh->getBoundingSphereRadius(), distance = std::hypot(10, radius);
    EXPECT_NEAR(level.switchDistance, distance, 1e-4);
    EXPECT_NEAR(level.switchRadius, 540 / std::tan(kPi / 8) * radius / distance, 1e-2);
    const double larger = 1 / std::sqrt(distance * distance - 1), smaller = 0.9 / std::sqrt(distance * distance - 0.81);
    for (const SeenDifference& seen : {level.atSwitch.lit, level.popping.checker}) {
        EXPECT_NEAR(seen.coverage, smaller * smaller / larger / larger, 0.005);
        EXPECT_NEAR(seen.silhouetteShare, 1 - smaller * smaller / larger / larger, 0.01);
        EXPECT_NEAR(seen.silhouetteDistance, 540 / std::tan(kPi / 8) * (larger - smaller), 1.5);
        EXPECT_LT(seen.ssim, 1);
    }
    EXPECT_NEAR(level.closeUp.lit.coverage, 0.81, 0.02);
}

TEST_F(SeenLevelsTest, PoppingIsFromTheLevelBefore)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", makeUvSphere(60, 40));
    ASSERT_TRUE(ProgressiveMeshGenerator().generateLodLevels(proportional(mesh, {0.9, 0.95})));
    const std::vector<SeenLevel> levels = measure(mesh);
    ASSERT_EQ(levels.size(), 3u);
    EXPECT_EQ(levels[1].popping.lit.mean, levels[1].atSwitch.lit.mean) << "which is the original";
    EXPECT_GT(levels[1].popping.lit.mean, 0);
    EXPECT_NE(levels[2].popping.lit.mean, levels[2].atSwitch.lit.mean);
    EXPECT_LT(levels[2].triangles, levels[1].triangles);
}

TEST_F(SeenLevelsTest, ALevelThatNeverAppearsIsSeenCloseUpAlone)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", makeUvSphere(40, 30));
    LodConfig config = proportional(mesh, {0.8, 0.9});
    config.strategy = "pixel_count";
    config.levels[0].value = 1000;
    config.levels[1].value = 100;
    ASSERT_TRUE(ProgressiveMeshGenerator().generateLodLevels(config));
    Ogre::MeshLodUsage last = mesh->getLodLevel(2);
    last.userValue = 0;
    mesh->_setLodUsage(2, last);
    const std::vector<SeenLevel> levels = measure(mesh);
    ASSERT_EQ(levels.size(), 3u);
    EXPECT_TRUE(levels[1].appears());
    EXPECT_FALSE(levels[2].appears());
    EXPECT_EQ(levels[2].switchRadius, 0);
    expectNone(levels[2].atSwitch);
    EXPECT_GT(levels[2].closeUp.lit.mean, 0);
}

TEST_F(SeenLevelsTest, ACancelledMeasurementSaysSo)
{
    const auto renderer = LevelRenderer::create(makeOgreMesh("mesh", makeCube()));
    ASSERT_TRUE(renderer);
    Progress progress;
    progress.cancel();
    const auto levels = measureSeenLevels(*renderer.value(), mOptions, &progress);
    ASSERT_FALSE(levels);
    EXPECT_EQ(levels.error().code, ErrorCode::Cancelled);
}

/// OGRE's own choice of levels around switchDistance().
class SwitchDistanceTest : public RenderTest, public testing::WithParamInterface<const char*> {
protected:
    int levelAt(Ogre::Entity& entity, const Ogre::Vector3& position)
    {
        mSession->cameraNode().setPosition(position);
        mSession->cameraNode().lookAt(Ogre::Vector3::ZERO, Ogre::Node::TS_WORLD);
        mSession->frame();
        return entity.getCurrentLodIndex();
    }
};

TEST_P(SwitchDistanceTest, IsWhereOgreSwitches)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", translated(makeUvSphere(40, 30, 2.0), 1.0, 3.0, 0.0));
    LodConfig config = proportional(mesh, {0.5, 0.8});
    config.strategy = GetParam();
    const bool isRatio = config.strategy == "screen_ratio_pixel_count", isPixels = config.strategy == "pixel_count";
    config.levels[0].value = isRatio ? 0.05f : isPixels ? 20000.0f : 12.0f;
    config.levels[1].value = isRatio ? 0.004f : isPixels ? 900.0f : 40.0f;
    ASSERT_TRUE(ProgressiveMeshGenerator().generateLodLevels(config));
    Ogre::Entity& entity = mSession->show(mesh);
    const Screen screen{640, 480, static_cast<double>(mSession->camera().getFOVy().valueRadians())};
    for (const Ogre::Vector3& direction : viewDirections())
        for (const unsigned level : {1u, 2u}) {
            const Result<double> distance = switchDistance(*mesh, level, direction, screen);
            ASSERT_TRUE(distance) << describe(distance.error());
            const auto exact = static_cast<float>(distance.value());
            EXPECT_EQ(levelAt(entity, direction * (exact * 0.999f)), int(level) - 1);
            EXPECT_EQ(levelAt(entity, direction * (exact * 1.001f)), int(level));
        }
}

TEST_P(SwitchDistanceTest, IsNotThereForOtherLevels)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", makeUvSphere(40, 30));
    LodConfig config = proportional(mesh, {0.5});
    config.strategy = GetParam();
    ASSERT_TRUE(ProgressiveMeshGenerator().generateLodLevels(config));
    for (const unsigned level : {0u, 2u}) {
        const Result<double> distance = switchDistance(*mesh, level, Ogre::Vector3::UNIT_Z);
        ASSERT_FALSE(distance);
        EXPECT_EQ(distance.error().code, ErrorCode::InvalidSetting);
    }
}

INSTANTIATE_TEST_SUITE_P(Strategies, SwitchDistanceTest,
                         testing::Values("distance_sphere", "distance_box", "pixel_count", "screen_ratio_pixel_count"),
                         [](const auto& strategy) { return std::string(strategy.param); });

TEST(ViewDirections, AreOfLengthOneAndLieApart)
{
    for (const Ogre::Vector3& direction : viewDirections()) {
        EXPECT_NEAR(direction.length(), 1, 1e-6);
        for (const Ogre::Vector3& other : viewDirections()) {
            EXPECT_TRUE(&other == &direction || direction.dotProduct(other) < 0.8f) << direction << " and " << other;
        }
    }
}

} // namespace
} // namespace lodsmith::test
