#include <support/OgreMeshBuilder.h>
#include <support/OgreSession.h>

#include <lodsmith/ogre/LodConfig.h>
#include <lodsmith/ogre/ProgressiveMeshGenerator.h>
#include <lodsmith/ogre/QueuedProgressiveMeshGenerator.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

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

constexpr double kPi = 3.14159265358979;

double radiusOnScreen(const LodLevel& level)
{
    return std::sqrt(level.value / kPi);
}

class AutomaticLodsTest : public testing::Test {
protected:
    static AutomaticLods lods(Metric metric, unsigned levels, double quality = 1.0)
    {
        AutomaticLods automatic;
        automatic.metric = metric;
        automatic.levels = levels;
        automatic.quality = quality;
        return automatic;
    }

    std::vector<LodLevel> levels(const AutomaticLods& automatic) { return automaticLodConfig(mMesh, automatic).levels; }

    /// What the level's collapses may cost, in pixels on screen when it appears.
    double pixelsOfCost(const LodLevel& level)
    {
        return level.target.amount / mMesh->getBoundingSphereRadius() * radiusOnScreen(level);
    }

    OgreSession mSession;
    Ogre::MeshPtr mMesh = makeOgreMesh("mesh", makeUvSphere(20, 10));
};

TEST_F(AutomaticLodsTest, FewerLevelsAreTheLastOnesAndMoreGoOn)
{
    for (const Metric metric : {Metric::Curvature, Metric::Quadric}) {
        const std::vector<LodLevel> four = levels(lods(metric, 4));
        for (unsigned count = 1; count <= AutomaticLods::kMaxLevels; ++count) {
            const std::vector<LodLevel> some = levels(lods(metric, count));
            ASSERT_EQ(some.size(), count);
            for (unsigned i = 0; i < std::min(count, 4u); ++i) {
                const LodLevel& same = count < 4 ? four[4 - count + i] : four[i];
                EXPECT_EQ(some[i].value, same.value);
                EXPECT_EQ(some[i].target.amount, same.target.amount);
            }
            for (unsigned i = 1; i < count; ++i) {
                EXPECT_LT(some[i].value, some[i - 1].value);
                EXPECT_GT(some[i].target.amount, some[i - 1].target.amount);
            }
        }
    }
}

TEST_F(AutomaticLodsTest, BeyondTheFourthLevelTheCostStaysTheSamePixels)
{
    const std::vector<LodLevel> eight = levels(lods(Metric::Curvature, 8));
    for (std::size_t i = 4; i < 8; ++i)
        EXPECT_NEAR(pixelsOfCost(eight[i]), pixelsOfCost(eight[3]), 1e-4);
}

TEST_F(AutomaticLodsTest, TheQuadricMetricMayCostHalfAPixelAtEachLevel)
{
    for (const LodLevel& level : levels(lods(Metric::Quadric, 8)))
        EXPECT_NEAR(pixelsOfCost(level), 0.5, 1e-4);
}

TEST_F(AutomaticLodsTest, QualityScalesTheRadiusOnScreenAndNothingElse)
{
    const std::vector<LodLevel> one = levels(lods(Metric::Curvature, 4)), fine = levels(lods(Metric::Curvature, 4, 2));
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_NEAR(radiusOnScreen(fine[i]), radiusOnScreen(one[i]) / 2, 1e-3);
        EXPECT_EQ(fine[i].target.amount, one[i].target.amount);
    }
}

TEST_F(AutomaticLodsTest, SettingsOutOfRangeAreRefused)
{
    const auto nan = std::numeric_limits<double>::quiet_NaN();
    QueuedProgressiveMeshGenerator queue;
    for (const AutomaticLods& wrong :
         {lods(Metric::Curvature, 0), lods(Metric::Curvature, 9), lods(Metric::Curvature, 4, 0.09),
          lods(Metric::Curvature, 4, 11), lods(Metric::Curvature, 4, nan)}) {
        EXPECT_FALSE(troubleWith(wrong).empty());
        const auto report = ProgressiveMeshGenerator().generateAutoconfiguredLodLevels(mMesh, nullptr, wrong);
        ASSERT_FALSE(report);
        EXPECT_EQ(report.error().code, ErrorCode::InvalidSetting);
        const auto queued = queue.generateAutoconfiguredLodLevels(mMesh, 0.0f, wrong);
        ASSERT_FALSE(queued);
        EXPECT_EQ(queued.error().code, ErrorCode::InvalidSetting);
    }
    EXPECT_EQ(queue.queued(), 0u);
}

TEST_F(AutomaticLodsTest, BothGeneratorsTakeThem)
{
    const AutomaticLods automatic = lods(Metric::Quadric, 6, 0.5);
    ASSERT_TRUE(ProgressiveMeshGenerator().generateAutoconfiguredLodLevels(mMesh, nullptr, automatic));
    const auto values = [&] {
        std::vector<Ogre::Real> values;
        for (Ogre::ushort level = 1; level < mMesh->getNumLodLevels(); ++level)
            values.push_back(mMesh->getLodLevel(level).userValue);
        return values;
    };
    const std::vector<Ogre::Real> direct = values();
    EXPECT_EQ(direct.back(), levels(automatic).back().value);
    mMesh->removeLodLevels();
    QueuedProgressiveMeshGenerator queue;
    ASSERT_TRUE(queue.generateAutoconfiguredLodLevels(mMesh, 0.0f, automatic));
    queue.injector().finishAll();
    EXPECT_EQ(values(), direct);
}

} // namespace
} // namespace lodsmith::test
