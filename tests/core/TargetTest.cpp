#include "support/CheckedSimplify.h"
#include "support/MeshBuilders.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace lodsmith {

namespace {

using namespace test;

void expectInvalid(LevelTarget target)
{
    const TestMesh mesh = makeGrid(4, 4);
    const Result<LodChain> result = simplify(mesh.view(), {removedShare(0.5), target});
    ASSERT_FALSE(result.ok()) << target.amount;
    EXPECT_EQ(result.error().code, ErrorCode::InvalidSetting);
    EXPECT_FALSE(result.error().message.empty());
}

TEST(Target, ProportionalRemovesThatShareOfTheOriginal)
{
    const TestMesh mesh = makeTerrain(30);
    const LodChain chain = simplifyChecked(
        mesh.view(), {removedShare(0.5), removedShare(0.75), removedShare(0.875), removedShare(0.9375)});
    for (std::size_t i = 0; i < chain.levels.size(); ++i) {
        EXPECT_EQ(chain.levels[i].stop, StopReason::TargetReached);
        EXPECT_NEAR(chain.levels[i].vertices, 961.0 / std::pow(2.0, i + 1.0), 1.0);
    }
}

TEST(Target, ProportionalOfNothingIsSkipped)
{
    const TestMesh mesh = makeTerrain(8);
    const LodChain chain = simplifyChecked(mesh.view(), {removedShare(0.0)});
    EXPECT_TRUE(chain.levels[0].skipped);
    EXPECT_EQ(chain.levels[0].stop, StopReason::TargetReached);
    EXPECT_EQ(chain.levels[0].vertices, chain.vertices);
    EXPECT_EQ(chain.levels[0].deviation, 0.0);
    EXPECT_EQ(chain.levels[0].cost, 0.0);
}

TEST(Target, ProportionalOfAllGoesAsFarAsItCan)
{
    const TestMesh mesh = makeTerrain(8);
    const LodChain chain = simplifyChecked(mesh.view(), {removedShare(1.0)});
    EXPECT_LT(chain.levels[0].vertices, 8u);
    EXPECT_FALSE(chain.levels[0].skipped);
}

TEST(Target, ConstantRemovesThatMany)
{
    const TestMesh mesh = makeTerrain(20);
    const LodChain chain = simplifyChecked(mesh.view(), {removedVertices(1), removedVertices(100)});
    EXPECT_EQ(chain.levels[0].vertices, 440u);
    EXPECT_EQ(chain.levels[1].vertices, 341u);
}

TEST(Target, ConstantBeyondTheVertexCountMeansAll)
{
    const TestMesh mesh = makeTerrain(8);
    const LodChain all = simplifyChecked(mesh.view(), {removedShare(1.0)});
    for (const double amount : {81.0, 82.0, 4294967296.0, 1e300}) {
        const LodChain chain = simplifyChecked(mesh.view(), {removedVertices(amount)});
        EXPECT_EQ(chain.levels[0].indices, all.levels[0].indices) << amount;
        EXPECT_EQ(chain.levels[0].stop, all.levels[0].stop) << amount;
    }
}

TEST(Target, TrianglesKeepsAtMostThatMany)
{
    const TestMesh mesh = makeTerrain(20);
    const LodChain chain = simplifyChecked(mesh.view(), {keptTriangles(799), keptTriangles(300), keptTriangles(50)});
    EXPECT_GE(chain.levels[0].triangles, 797u);
    EXPECT_GE(chain.levels[1].triangles, 298u);
    EXPECT_GE(chain.levels[2].triangles, 48u);
    for (const LodChainLevel& level : chain.levels)
        EXPECT_EQ(level.stop, StopReason::TargetReached);
}

TEST(Target, AsManyTrianglesAsThereAreIsSkipped)
{
    const TestMesh mesh = makeTerrain(20);
    const LodChain chain = simplifyChecked(mesh.view(), {keptTriangles(800), keptTriangles(1e12)});
    EXPECT_TRUE(chain.levels[0].skipped);
    EXPECT_TRUE(chain.levels[1].skipped);
}

TEST(Target, DeviationIsKeptAndUsed)
{
    const TestMesh mesh = makeTerrain(24);
    const double bounds[] = {0.0005, 0.002, 0.01};
    const LodChain chain = simplifyChecked(
        mesh.view(), {greatestDeviation(bounds[0]), greatestDeviation(bounds[1]), greatestDeviation(bounds[2])});
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_LE(chain.levels[i].deviation, bounds[i]);
        EXPECT_LT(chain.levels[i].vertices, i == 0 ? chain.vertices : chain.levels[i - 1].vertices)
            << "a bound of " << bounds[i] << " leaves room";
        EXPECT_EQ(chain.levels[i].stop, StopReason::TargetReached);
    }
    EXPECT_LT(chain.levels[2].vertices, chain.vertices / 2);
}

TEST(Target, DeviationAddsUpOverCornersCutOffOneAfterTheOther)
{
    // Strips that are eaten from their ends: each cut is short, what they remove together is not.
    TestMesh strips;
    for (int i = 0; i < 6; ++i)
        strips = joined(strips, translated(makePatch(6, 1,
                                                     [](double u, double v) {
                                                         return Point{6 * u, v, 0.0};
                                                     }),
                                           0, 0, i));
    simplifyChecked(strips.view(), {removedShare(0.5), removedShare(0.8), removedShare(1.0)});

    TestMesh teeth = makeGrid(4, 1);
    teeth.subMeshes[0].indices = {0, 1, 6, 1, 2, 7, 2, 3, 8, 2, 8, 7, 3, 4, 9, 3, 9, 8};
    simplifyChecked(teeth.view(), {removedShare(0.5)});
}

TEST(Target, DeviationOfAFoldWithAFaceOnEdge)
{
    // Three triangles around the middle of a straight border. The sum of their normals lies in the plane of one of them,
    // which is a line when seen along it.
    TestMesh mesh;
    mesh.buffers.resize(1);
    mesh.subMeshes.resize(1);
    mesh.buffers[0].positions = {0.125, 0, 0, 0.25, 0, 0, 0.5, 0, 0, 0.5, 1, 0, 0.5, 0, 0.5};
    mesh.buffers[0].importance = {1, 0, 1, 1, 1};
    mesh.subMeshes[0].indices = {2, 3, 1, 1, 3, 4, 1, 4, 0};
    const LodChain chain = simplifyChecked(mesh.view(), {removedVertices(1)});
    EXPECT_FALSE(chain.levels[0].skipped);
    EXPECT_GT(chain.levels[0].deviation, 0.05) << "the fold is cut off";
}

TEST(Target, DeviationOfAFanThatWindsOneAndAHalfTimes)
{
    // Around the middle of a straight border, four triangles turn by 540 degrees instead of 180.
    TestMesh mesh;
    mesh.buffers.resize(1);
    mesh.subMeshes.resize(1);
    mesh.buffers[0].positions = {0, 0, 0, 0, 1, 0, 0, 3, 0, -0.5f, 3.8f, -1.3f, 1, 2, 0, -1.7f, 5.9f, 2.2f};
    mesh.buffers[0].importance = {1, 0, 1, 1, 1, 1};
    mesh.subMeshes[0].indices = {1, 0, 3, 1, 3, 4, 1, 4, 5, 1, 5, 2};
    const LodChain chain = simplifyChecked(mesh.view(), {removedVertices(1)});
    EXPECT_FALSE(chain.levels[0].skipped);
}

TEST(Target, NoDeviationAllowedKeepsACurvedSurface)
{
    const TestMesh mesh = makeIcosphere(2);
    const LodChain chain = simplifyChecked(mesh.view(), {greatestDeviation(0.0)});
    EXPECT_TRUE(chain.levels[0].skipped);
    EXPECT_EQ(chain.levels[0].stop, StopReason::TargetReached);
}

TEST(Target, CollapseCostStopsAtTheFirstDearerOne)
{
    const TestMesh mesh = makeTerrain(24);
    const LodChain half = simplifyChecked(mesh.view(), {removedShare(0.5)});
    const double cost = half.levels[0].cost;
    ASSERT_GT(cost, 0.0);
    const LodChain chain = simplifyChecked(mesh.view(), {dearestCollapse(cost * 0.5), dearestCollapse(cost * 2.0)});
    EXPECT_GT(chain.levels[0].vertices, half.levels[0].vertices);
    EXPECT_LT(chain.levels[1].vertices, half.levels[0].vertices);
    EXPECT_EQ(chain.levels[0].stop, StopReason::TargetReached);
}

TEST(Target, AWeakerTargetAfterAStrongerOneIsSkipped)
{
    const TestMesh mesh = makeTerrain(12);
    const LodChain chain = simplifyChecked(mesh.view(), {removedShare(0.75), removedShare(0.5), removedShare(0.75),
                                                         removedVertices(3), keptTriangles(280), removedShare(0.9)});
    for (std::size_t i = 1; i <= 4; ++i) {
        EXPECT_TRUE(chain.levels[i].skipped) << i;
        EXPECT_EQ(chain.levels[i].vertices, chain.levels[0].vertices) << i;
        EXPECT_EQ(chain.levels[i].stop, StopReason::TargetReached) << i;
    }
    EXPECT_FALSE(chain.levels[5].skipped);
}

TEST(Target, AllKindsMixInOneChain)
{
    const TestMesh mesh = makeTerrain(24);
    simplifyChecked(mesh.view(), {removedVertices(10), greatestDeviation(0.001), removedShare(0.6),
                                  dearestCollapse(0.002), keptTriangles(100)});
}

TEST(Target, OnePassForAllLevelsGivesWhatSinglePassesGive)
{
    const TestMesh mesh = makeUvSphere(24, 16);
    const std::vector<LevelTarget> targets = {removedShare(0.3), removedVertices(200), keptTriangles(60)};
    const LodChain chain = simplifyChecked(mesh.view(), targets);
    for (std::size_t i = 0; i < targets.size(); ++i) {
        const LodChain single = simplifyChecked(mesh.view(), {targets[i]});
        EXPECT_EQ(single.levels[0].vertices, chain.levels[i].vertices) << i;
        EXPECT_EQ(single.levels[0].triangles, chain.levels[i].triangles) << i;
        EXPECT_EQ(single.levels[0].stop, chain.levels[i].stop) << i;
    }
}

TEST(Target, NoLevelsAskedFor)
{
    const TestMesh mesh = makeTerrain(8);
    const LodChain chain = simplifyChecked(mesh.view(), {});
    EXPECT_TRUE(chain.levels.empty());
    EXPECT_EQ(chain.triangles, 128u);
}

TEST(Target, OutOfRangeIsAnError)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinite = std::numeric_limits<double>::infinity();
    expectInvalid(removedShare(1.0000001));
    expectInvalid(removedShare(-0.1));
    for (const auto make : {removedShare, removedVertices, keptTriangles, greatestDeviation, dearestCollapse}) {
        expectInvalid(make(nan));
        expectInvalid(make(-1.0));
        expectInvalid(make(-infinite));
    }
    expectInvalid(removedShare(infinite));
}

TEST(Target, WeightsOutOfRangeAreAnError)
{
    const TestMesh mesh = makeGrid(4, 4);
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const float bad : {nan, -0.1f, std::numeric_limits<float>::infinity()}) {
        for (float AttributeWeights::*weight :
             {&AttributeWeights::normal, &AttributeWeights::uv, &AttributeWeights::colour, &AttributeWeights::bone}) {
            SimplifyOptions options;
            options.weights.*weight = bad;
            const Result<LodChain> result = simplify(mesh.view(), {removedShare(0.5)}, options);
            ASSERT_FALSE(result.ok()) << bad;
            EXPECT_EQ(result.error().code, ErrorCode::InvalidSetting);
        }
    }
}

} // namespace

} // namespace lodsmith
