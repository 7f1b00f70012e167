#include <lodsmith/analysis/Deviation.h>
#include <lodsmith/analysis/SurfaceDistances.h>

#include "support/MeshBuilders.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace lodsmith;
using namespace lodsmith::test;

namespace {

using Distances = std::vector<std::vector<float>>;

Distances distancesOf(const TestMesh& from, const TestMesh& to)
{
    return surfaceDistances(from.view(), to.view()).value();
}

ErrorCode errorOf(const TestMesh& from, const TestMesh& to)
{
    return surfaceDistances(from.view(), to.view()).error().code;
}

float greatest(const Distances& distances)
{
    float result = 0.0f;
    for (const std::vector<float>& ofBuffer : distances)
        for (const float distance : ofBuffer)
            result = std::max(result, distance);
    return result;
}

} // namespace

TEST(SurfaceDistances, AMeshLiesOnItself)
{
    for (const TestMesh& mesh : {makeGrid(5, 5), makeUvSphere(12, 8), makeCube(3), makeTwoSidedWall(4), makeSoup(60)})
        EXPECT_LT(greatest(distancesOf(mesh, mesh)), 1e-7);
}

TEST(SurfaceDistances, EachVertexHasItsOwn)
{
    // A tent over a floor: the ridge is up, the eaves are not.
    TestMesh tent = makeGrid(2, 2);
    for (std::uint32_t i = 0; i < 9; ++i)
        tent.buffers[0].positions[3 * i + 2] = 0.25f * static_cast<float>(i);
    const Distances distances = distancesOf(tent, makeGrid(1, 1));
    ASSERT_EQ(distances.size(), 1u);
    ASSERT_EQ(distances[0].size(), 9u);
    for (std::uint32_t i = 0; i < 9; ++i)
        EXPECT_FLOAT_EQ(distances[0][i], 0.25f * static_cast<float>(i)) << i;
}

TEST(SurfaceDistances, BuffersKeepTheirPlacesAndUnusedVerticesHaveNone)
{
    TestMesh from = joined(makeGrid(1, 1), translated(makeGrid(1, 1), 0.0, 0.0, 2.0));
    from.buffers[1].addPosition(50.0, 50.0, 50.0);
    from.buffers[1].normals.clear();
    from.buffers[1].uvSets.clear();
    const Distances distances = distancesOf(from, translated(makeGrid(3, 3), 0.0, 0.0, -1.0));
    EXPECT_THAT(distances,
                testing::ElementsAre(testing::Each(1.0f), testing::ElementsAre(3.0f, 3.0f, 3.0f, 3.0f, 0.0f)));
}

TEST(SurfaceDistances, WedgesOfAPositionAgree)
{
    const Distances distances = distancesOf(scaled(makeCube(), 2.0), makeCube());
    ASSERT_EQ(distances[0].size(), 24u);
    for (const float distance : distances[0])
        EXPECT_FLOAT_EQ(distance, std::sqrt(3.0f));
}

TEST(SurfaceDistances, NoneIsBeyondTheMeasuredMaximum)
{
    const TestMesh fine = makeTerrain(24), coarse = makeTerrain(5);
    const double maximum = measureDeviation(fine.view(), coarse.view()).value().surface.maximum;
    const float there = greatest(distancesOf(fine, coarse));
    EXPECT_GT(there, 0.5 * maximum);
    EXPECT_LE(there, maximum * (1.0 + 1e-6));
}

TEST(SurfaceDistances, ScalesWithTheMesh)
{
    const TestMesh fine = makeTerrain(12), coarse = makeTerrain(4);
    const Distances unit = distancesOf(fine, coarse);
    for (const int exponent : {60, -60}) {
        const double scale = std::ldexp(1.0, exponent);
        const Distances sized = distancesOf(scaled(fine, scale), scaled(coarse, scale));
        for (std::size_t i = 0; i < unit[0].size(); ++i)
            EXPECT_EQ(sized[0][i], unit[0][i] * static_cast<float>(scale));
    }
}

TEST(SurfaceDistances, NothingToMeasure)
{
    TestMesh empty = makeCube();
    empty.subMeshes[0].indices.clear();
    EXPECT_EQ(errorOf(makeCube(), empty), ErrorCode::Unsupported);
    EXPECT_EQ(errorOf(makeCube(), scaled(makeCube(), 0.0)), ErrorCode::Unsupported);
    EXPECT_EQ(greatest(distancesOf(empty, makeCube())), 0.0f);
    EXPECT_EQ(distancesOf(empty, empty)[0].size(), 24u);
    EXPECT_TRUE(surfaceDistances(MeshView{}, MeshView{}).value().empty());
}

TEST(SurfaceDistances, BadMeshes)
{
    TestMesh bad = makeGrid(2, 2);
    bad.buffers[0].positions[4] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(errorOf(bad, makeGrid(2, 2)), ErrorCode::InvalidGeometry);
    EXPECT_EQ(errorOf(makeGrid(2, 2), bad), ErrorCode::InvalidGeometry);
    bad = makeGrid(2, 2);
    bad.subMeshes[0].indices[0] = 9;
    EXPECT_EQ(errorOf(bad, makeGrid(2, 2)), ErrorCode::IndexOutOfRange);
    EXPECT_EQ(errorOf(makeGrid(2, 2), bad), ErrorCode::IndexOutOfRange);
}

TEST(SurfaceDistances, ProgressAndCancel)
{
    const TestMesh mesh = makeGrid(8, 8);
    Progress progress;
    ASSERT_TRUE(surfaceDistances(mesh.view(), mesh.view(), &progress).ok());
    EXPECT_EQ(progress.fraction(), 1.0f);
    Progress cancelled;
    cancelled.cancel();
    EXPECT_EQ(surfaceDistances(mesh.view(), mesh.view(), &cancelled).error().code, ErrorCode::Cancelled);
}
