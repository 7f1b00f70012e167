#include <lodsmith/analysis/Deviation.h>
#include <lodsmith/analysis/SurfaceDistances.h>

#include "support/MeshBuilders.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace lodsmith;
using namespace lodsmith::test;

namespace {

constexpr float kBump = 0.25f;

/// Two by two quads in the unit square; its pose lifts the middle.
TestMesh liftedGrid()
{
    TestMesh grid = makeGrid(2, 2);
    TestBuffer& buffer = grid.buffers[0];
    buffer.poses.push_back(buffer.positions);
    buffer.poses[0][3 * 4 + 2] = kBump;
    return grid;
}

/// The same square in two triangles, without the middle.
TestMesh withoutMiddle(TestMesh grid)
{
    grid.subMeshes[0].indices = {0, 2, 8, 0, 8, 6};
    return grid;
}

Deviation measured(const MeshView& original, const MeshView& simplified)
{
    DeviationOptions options;
    options.samples = 4000;
    return measureDeviation(original, simplified, options).value();
}

TEST(DeviationPoses, WhatIsOffInAPoseOnlyIsSeen)
{
    const TestMesh grid = liftedGrid(), square = withoutMiddle(grid);
    const Deviation deviation = measured(grid.view(), square.view());
    EXPECT_EQ(deviation.poses, 1u);
    EXPECT_NEAR(deviation.surface.maximum, kBump, 1e-6);
    EXPECT_GT(deviation.surface.mean, 0.0);
    EXPECT_EQ(deviation.flippedTriangles + deviation.newBorderEdges, 0u);
}

TEST(DeviationPoses, RestAndPosesCountAlike)
{
    TestMesh grid = liftedGrid();
    TestBuffer& buffer = grid.buffers[0];
    buffer.poses.push_back(buffer.poses[0]);
    buffer.poses[1][3 * 1 + 1] = -0.1f;
    const TestMesh square = withoutMiddle(grid);
    const MeshView before = grid.view(), after = square.view();
    const Deviation all = measured(before, after);
    double mean = 0.0, squares = 0.0, maximum = 0.0;
    for (const DeviationFigures& figures :
         {measured(inPose(before, 2), inPose(after, 2)).surface, measured(inPose(before, 0), inPose(after, 0)).surface,
          measured(inPose(before, 1), inPose(after, 1)).surface}) { // there is no third pose: that is rest
        mean += figures.mean / 3.0;
        squares += figures.rms * figures.rms / 3.0;
        maximum = std::max(maximum, figures.maximum);
    }
    EXPECT_EQ(all.poses, 2u);
    EXPECT_DOUBLE_EQ(all.surface.mean, mean);
    EXPECT_DOUBLE_EQ(all.surface.rms, std::sqrt(squares));
    EXPECT_DOUBLE_EQ(all.surface.maximum, maximum);
}

TEST(DeviationPoses, WithOtherNumbersOfPosesRestIsCompared)
{
    const TestMesh grid = liftedGrid();
    TestMesh square = withoutMiddle(grid);
    square.buffers[0].poses.clear();
    const Deviation deviation = measured(grid.view(), square.view());
    EXPECT_EQ(deviation.poses, 0u);
    EXPECT_LT(deviation.surface.maximum, 1e-9);
}

TEST(DeviationPoses, APoseThatLeavesNoTriangleIsNotCounted)
{
    TestMesh grid = liftedGrid();
    grid.buffers[0].poses.emplace_back(grid.buffers[0].positions.size(), 3.0f);
    const Deviation deviation = measured(grid.view(), withoutMiddle(grid).view());
    EXPECT_EQ(deviation.poses, 1u);
    EXPECT_NEAR(deviation.surface.maximum, kBump, 1e-6);
}

TEST(DeviationPoses, TrianglesWithoutAreaAtRestDoNotCount)
{
    TestMesh grid = liftedGrid();
    TestBuffer& buffer = grid.buffers[0];
    const std::uint32_t twin = buffer.addPosition(0.0, 0.0, 0.0); // where vertex 0 is, and far from it in the pose
    buffer.addNormal(0.0, 0.0, 1.0);
    buffer.addUv(0.0, 0.0);
    buffer.poses[0].insert(buffer.poses[0].end(), {0.0f, 0.0f, 7.0f});
    const TestMesh square = withoutMiddle(grid);
    grid.subMeshes[0].addTriangle(0, twin, 1);
    EXPECT_NEAR(measured(grid.view(), square.view()).surface.maximum, kBump, 1e-6);
}

TEST(DeviationPoses, BadNumbersNameThePose)
{
    TestMesh grid = liftedGrid();
    grid.buffers[0].poses.push_back(grid.buffers[0].positions);
    grid.buffers[0].poses[1][5] = std::numeric_limits<float>::quiet_NaN();
    const Result<Deviation> deviation = measureDeviation(grid.view(), withoutMiddle(grid).view());
    ASSERT_FALSE(deviation);
    EXPECT_EQ(deviation.error().code, ErrorCode::InvalidGeometry);
    EXPECT_NE(deviation.error().message.find("pose 1"), std::string::npos) << deviation.error().message;
}

TEST(DeviationPoses, ProgressEndsAtOneAndCancellingIsNoticed)
{
    const TestMesh grid = liftedGrid(), square = withoutMiddle(grid);
    Progress progress;
    ASSERT_TRUE(measureDeviation(grid.view(), square.view(), {2000, 1}, &progress));
    EXPECT_EQ(progress.fraction(), 1.0f);
    progress.cancel();
    EXPECT_EQ(measureDeviation(grid.view(), square.view(), {2000, 1}, &progress).error().code, ErrorCode::Cancelled);
}

TEST(DeviationPoses, DistancesOfVerticesAreThoseOfTheWorstPose)
{
    const TestMesh grid = liftedGrid(), square = withoutMiddle(grid);
    const std::vector<float> distances = surfaceDistances(grid.view(), square.view()).value()[0];
    for (std::size_t vertex = 0; vertex < distances.size(); ++vertex)
        EXPECT_NEAR(distances[vertex], vertex == 4 ? kBump : 0.0f, 1e-6f) << vertex;
}

} // namespace
