#include <support/OgreMeshBuilder.h>
#include <support/OgreSession.h>

#include <lodsmith/ogre/LodConfig.h>

#include <gtest/gtest.h>

namespace lodsmith::test {
namespace {

TEST(LodConfigTest, TheAutomaticConfigurationFollowsItsFormula)
{
    OgreSession session;
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", makeTetrahedron());
    mesh->_setBoundingSphereRadius(50);
    const LodConfig config = automaticLodConfig(mesh);
    EXPECT_EQ(config.mesh, mesh);
    EXPECT_EQ(config.strategy, "pixel_count");
    EXPECT_EQ(config.options.metric, Metric::Curvature);
    // The published figures: pixels, and the radius over the cost.
    const double expected[4][2] = {{211788, 3125}, {41835, 411.52}, {13237, 97.656}, {5422, 32}};
    ASSERT_EQ(config.levels.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_NEAR(config.levels[i].value, expected[i][0], 0.5);
        EXPECT_EQ(config.levels[i].target.kind, LevelTarget::Kind::CollapseCost);
        EXPECT_NEAR(50 / config.levels[i].target.amount, expected[i][1], 0.01);
        EXPECT_FALSE(config.levels[i].isManual());
    }
}

} // namespace
} // namespace lodsmith::test
