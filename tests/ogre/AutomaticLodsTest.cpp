#include <support/OgreMeshBuilder.h>
#include <support/OgreSession.h>

#include <lodsmith/ogre/AutomaticLods.h>
#include <lodsmith/ogre/ProgressiveMeshGenerator.h>
#include <lodsmith/ogre/QueuedProgressiveMeshGenerator.h>

#include <OgreSubMesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lodsmith::test {
namespace {

TEST(AutomaticLods, ClassicOnesFollowTheFormulaOf2012)
{
    OgreSession session;
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", makeTetrahedron());
    mesh->_setBoundingSphereRadius(50);
    AutomaticLods classic;
    classic.method = AutomaticLods::Method::Classic;
    const LodConfig config = automaticLodConfig(mesh, classic);
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

class ClassicLodsTest : public testing::Test {
protected:
    static AutomaticLods lods(Metric metric, unsigned levels, double pixels = 1.0)
    {
        AutomaticLods automatic;
        automatic.method = AutomaticLods::Method::Classic;
        automatic.metric = metric;
        automatic.levels = levels;
        automatic.pixels = pixels;
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

TEST_F(ClassicLodsTest, FewerLevelsAreTheLastOnesAndMoreGoOn)
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

TEST_F(ClassicLodsTest, BeyondTheFourthLevelTheCostStaysTheSamePixels)
{
    const std::vector<LodLevel> eight = levels(lods(Metric::Curvature, 8));
    for (std::size_t i = 4; i < 8; ++i)
        EXPECT_NEAR(pixelsOfCost(eight[i]), pixelsOfCost(eight[3]), 1e-4);
}

TEST_F(ClassicLodsTest, TheQuadricMetricMayCostHalfAPixelAtEachLevel)
{
    for (const LodLevel& level : levels(lods(Metric::Quadric, 8)))
        EXPECT_NEAR(pixelsOfCost(level), 0.5, 1e-4);
}

TEST_F(ClassicLodsTest, PixelsScaleTheRadiusOnScreenAndNothingElse)
{
    const std::vector<LodLevel> one = levels(lods(Metric::Curvature, 4)),
                                fine = levels(lods(Metric::Curvature, 4, 0.5));
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_NEAR(radiusOnScreen(fine[i]), radiusOnScreen(one[i]) / 2, 1e-3);
        EXPECT_EQ(fine[i].target.amount, one[i].target.amount);
    }
}

TEST_F(ClassicLodsTest, SettingsOutOfRangeAreRefused)
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

TEST_F(ClassicLodsTest, BothGeneratorsTakeThem)
{
    const AutomaticLods automatic = lods(Metric::Quadric, 6, 2);
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

/// The levels that are on a mesh: radius on screen, and triangles.
struct StoredLevel {
    double size = 0.0;
    std::size_t triangles = 0;
};

class BalancedLodsTest : public testing::Test {
protected:
    std::vector<StoredLevel> generate(const AutomaticLods& automatic = {})
    {
        const auto report = ProgressiveMeshGenerator().generateAutoconfiguredLodLevels(mMesh, nullptr, automatic);
        EXPECT_TRUE(report) << describe(report.error());
        mReport = report.value();
        std::vector<StoredLevel> levels;
        for (Ogre::ushort i = 1; i < mMesh->getNumLodLevels(); ++i)
            levels.push_back({std::sqrt(mMesh->getLodLevel(i).userValue / kPi),
                              mMesh->getSubMesh(0)->mLodFaceList[i - 1]->indexCount / 3});
        return levels;
    }

    OgreSession mSession;
    Ogre::MeshPtr mMesh = makeOgreMesh("mesh", makeUvSphere(60, 40));
    LodReport mReport;
};

TEST_F(BalancedLodsTest, NoLevelIsFartherOffThanItsPixels)
{
    for (const double pixels : {0.25, 1.0, 4.0}) {
        AutomaticLods automatic;
        automatic.pixels = pixels;
        const std::vector<StoredLevel> levels = generate(automatic);
        ASSERT_GE(levels.size(), 3u);
        auto level = levels.begin();
        for (const LodLevelReport& reported : mReport.levels) {
            if (reported.skipped)
                continue;
            ASSERT_NE(level, levels.end());
            EXPECT_EQ(reported.triangles, level->triangles);
            const double error = reported.deviation / mMesh->getBoundingSphereRadius() * level->size;
            EXPECT_LE(error, pixels * 1.001);
            EXPECT_GE(error, pixels * 0.1) << "it could go on";
            ++level;
        }
        EXPECT_EQ(level, levels.end());
    }
}

TEST_F(BalancedLodsTest, MorePixelsAreFewerTriangles)
{
    AutomaticLods coarse;
    coarse.pixels = 4;
    EXPECT_LT(generate(coarse).front().triangles, generate().front().triangles);
}

TEST_F(BalancedLodsTest, EachLevelIsWorthItsIndexBuffer)
{
    const std::vector<StoredLevel> levels = generate();
    double before = static_cast<double>(mReport.triangles);
    for (std::size_t i = 0; i < levels.size(); ++i) {
        const double until = i + 1 < levels.size() ? levels[i + 1].size : 1.0;
        const double doublings = std::log2(levels[i].size / until);
        EXPECT_GE((before - double(levels[i].triangles)) * doublings, 0.1 * mReport.triangles * 0.999)
            << "without level " << i + 1 << " the one before would be drawn";
        before = static_cast<double>(levels[i].triangles);
    }
}

TEST_F(BalancedLodsTest, AreNoMoreThanAskedFor)
{
    for (unsigned most = 1; most <= AutomaticLods::kMaxLevels; ++most) {
        AutomaticLods automatic;
        automatic.levels = most;
        EXPECT_LE(generate(automatic).size(), most);
        EXPECT_GE(generate(automatic).size(), std::min(most, 3u));
    }
}

TEST_F(BalancedLodsTest, HandMadeLevelsAreNoCandidates)
{
    LodConfig config = automaticLodConfig(mMesh);
    config.levels[3].manualMeshName = makeOgreMesh("other", makeTetrahedron())->getName();
    const auto report = ProgressiveMeshGenerator().generateLodLevels(config);
    ASSERT_FALSE(report);
    EXPECT_EQ(report.error().code, ErrorCode::InvalidSetting);
}

} // namespace
} // namespace lodsmith::test
