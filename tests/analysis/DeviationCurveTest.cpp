#include <lodsmith/analysis/DeviationCurve.h>

#include "support/MeshBuilders.h"

#include <gtest/gtest.h>

#include <limits>

using namespace lodsmith;
using namespace lodsmith::test;

namespace {

using Points = std::vector<LevelPoint>;

Points curveOf(const TestMesh& mesh, unsigned points, const SimplifyOptions& options = {})
{
    return deviationCurve(mesh.view(), options, points).value();
}

LodChainLevel levelOf(const TestMesh& mesh, double triangles, const SimplifyOptions& options = {})
{
    return simplify(mesh.view(), {{LevelTarget::Kind::Triangles, triangles}}, options).value().levels[0];
}

} // namespace

TEST(DeviationCurve, BeginsWithTheMesh)
{
    const TestMesh terrain = makeTerrain(20);
    const Points points = curveOf(terrain, 10);
    EXPECT_EQ(points[0].triangles, terrain.triangleCount());
    EXPECT_EQ(points[0].vertices, 21u * 21u);
    EXPECT_EQ(points[0].deviation, 0.0);
}

TEST(DeviationCurve, TrianglesFallAndDeviationNeverDoes)
{
    for (const Metric metric : {Metric::Quadric, Metric::Curvature})
        for (const TestMesh& mesh : {makeTerrain(30), makeUvSphere(40, 30), makeTorus(30, 20), makeLeafCards(200),
                                     makeSkinnedTube(24, 30), makeTwoMaterials(12, false), makeIslands(30)}) {
            SimplifyOptions options;
            options.metric = metric;
            const Points points = curveOf(mesh, 24, options);
            ASSERT_GE(points.size(), 5u);
            for (std::size_t i = 1; i < points.size(); ++i) {
                EXPECT_LT(points[i].triangles, points[i - 1].triangles);
                EXPECT_LT(points[i].vertices, points[i - 1].vertices);
                EXPECT_GE(points[i].deviation, points[i - 1].deviation);
            }
        }
}

TEST(DeviationCurve, PointsAreWhatSimplifyGives)
{
    const TestMesh mesh = makeTerrain(24);
    SimplifyOptions options;
    options.metric = Metric::Curvature;
    const Points points = curveOf(mesh, 6, options);
    ASSERT_GE(points.size(), 4u);
    for (std::size_t i = 1; i < points.size(); ++i) {
        const LodChainLevel level = levelOf(mesh, points[i].triangles, options);
        EXPECT_EQ(level.triangles, points[i].triangles);
        EXPECT_EQ(level.vertices, points[i].vertices);
        EXPECT_EQ(level.deviation, points[i].deviation);
    }
}

TEST(DeviationCurve, CountsFallByTheSameFactor)
{
    const Points points = curveOf(makeTerrain(32), 11); // 2048 = 2^11
    ASSERT_GE(points.size(), 6u);
    for (std::size_t i = 1; i < 6; ++i) {
        EXPECT_LE(points[i].triangles, 2048u >> i);
        EXPECT_GT(points[i].triangles, (2048u >> i) - 4u); // a collapse takes two, at times a few
    }
}

TEST(DeviationCurve, EndsWithTheLeastThereIs)
{
    SimplifyOptions locked;
    locked.lockBorders = true;
    const TestMesh terrain = makeTerrain(12);
    for (const SimplifyOptions& options : {SimplifyOptions{}, locked}) {
        const Points points = curveOf(terrain, 20, options);
        EXPECT_EQ(points.back().triangles, levelOf(terrain, 0.0, options).triangles);
    }
}

TEST(DeviationCurve, FewTrianglesGiveFewPoints)
{
    EXPECT_EQ(curveOf(makeTetrahedron(), 200).size(), 1u) << "nothing can go from the last piece";
    const Points points = curveOf(makeGrid(2, 2), kMaxCurvePoints);
    EXPECT_LE(points.size(), 8u);
    EXPECT_EQ(points.back().triangles, levelOf(makeGrid(2, 2), 0.0).triangles);

    TestMesh empty = makeGrid(1, 1);
    empty.subMeshes[0].indices.clear();
    const Points nothing = curveOf(empty, 5);
    ASSERT_EQ(nothing.size(), 1u);
    EXPECT_EQ(nothing[0].triangles, 0u);
}

TEST(DeviationCurve, Errors)
{
    const TestMesh mesh = makeGrid(3, 3);
    for (const unsigned points : {0u, kMaxCurvePoints + 1, std::numeric_limits<unsigned>::max()})
        EXPECT_EQ(deviationCurve(mesh.view(), {}, points).error().code, ErrorCode::InvalidSetting);
    SimplifyOptions wrong;
    wrong.weights.uv = -1.0f;
    EXPECT_EQ(deviationCurve(mesh.view(), wrong, 5).error().code, ErrorCode::InvalidSetting);
    Progress cancelled;
    cancelled.cancel();
    EXPECT_EQ(deviationCurve(mesh.view(), {}, 5, &cancelled).error().code, ErrorCode::Cancelled);
    Progress progress;
    ASSERT_TRUE(deviationCurve(mesh.view(), {}, 5, &progress));
    EXPECT_EQ(progress.fraction(), 1.0f);
}
