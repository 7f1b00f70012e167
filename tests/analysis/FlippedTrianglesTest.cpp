#include <lodsmith/analysis/Deviation.h>

#include "support/MeshBuilders.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

using namespace lodsmith;
using namespace lodsmith::test;

namespace {

constexpr double kPi = 3.14159265358979323846;

std::uint32_t flipsOf(const TestMesh& original, const TestMesh& simplified)
{
    DeviationOptions options;
    options.samples = 100;
    return measureDeviation(original.view(), simplified.view(), options).value().flippedTriangles;
}

/// The `number`th triangle, counted over all submeshes, with its winding turned over.
TestMesh withTurnedTriangle(TestMesh mesh, std::size_t number)
{
    for (TestSubMesh& subMesh : mesh.subMeshes) {
        const std::size_t count = subMesh.indices.size() / 3;
        if (number < count) {
            std::swap(subMesh.indices[3 * number], subMesh.indices[3 * number + 1]);
            return mesh;
        }
        number -= count;
    }
    ADD_FAILURE() << "no such triangle";
    return mesh;
}

/// Nothing is flipped as it is, each triangle is when turned over alone, and all are when all are.
void expectEachTurnedTriangleCounts(const TestMesh& original, const TestMesh& simplified)
{
    EXPECT_EQ(flipsOf(original, simplified), 0u);
    EXPECT_EQ(flipsOf(original, turnedInsideOut(simplified)), simplified.triangleCount());
    for (std::size_t i = 0; i < simplified.triangleCount(); ++i)
        EXPECT_EQ(flipsOf(original, withTurnedTriangle(simplified, i)), 1u) << "triangle " << i;
}

TestMesh moved(TestMesh mesh, std::uint32_t vertex, const Point& to)
{
    std::copy(to.begin(), to.end(), mesh.buffers[0].positions.begin() + 3 * vertex);
    return mesh;
}

/// How many triangles of a mesh that faces up turn their back when looked at from above.
std::uint32_t countFacingDown(const TestMesh& mesh)
{
    const std::vector<float>& p = mesh.buffers[0].positions;
    const std::vector<std::uint32_t>& indices = mesh.subMeshes[0].indices;
    std::uint32_t down = 0;
    for (std::size_t i = 0; i < indices.size(); i += 3) {
        const float *a = &p[3 * indices[i]], *b = &p[3 * indices[i + 1]], *c = &p[3 * indices[i + 2]];
        down += (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) < 0.0f;
    }
    return down;
}

TestMesh makeWaves(std::uint32_t cells)
{
    return makePatch(cells, cells, [](double u, double v) {
        return Point{u, v, 0.1 * std::sin(2.0 * kPi * u) * std::cos(kPi * v)};
    });
}

/// Two layers of waves that look away from each other, `thickness` apart.
TestMesh makeThinSheet(std::uint32_t cells, double thickness)
{
    return joined(makeWaves(cells), translated(turnedInsideOut(makeWaves(cells)), 0.0, 0.0, -thickness));
}

/// A curved blade: its two sides meet at two sharp edges, 0.02 apart at most.
TestMesh makeBlade(std::uint32_t columns, std::uint32_t rows)
{
    return makePatch(columns, rows, [](double u, double v) {
        const double across = std::abs(2.0 * u - 1.0), side = u < 0.5 ? -0.01 : 0.01;
        return Point{0.2 * across, v, side * 4.0 * across * (1.0 - across) + 0.2 * v * v};
    });
}

TestMesh makeSpike(std::uint32_t sectors, std::uint32_t stacks)
{
    return makePatch(sectors, stacks, [](double u, double v) {
        const double radius = 0.02 * (1.0 - v);
        return Point{radius * std::cos(2.0 * kPi * u), radius * std::sin(2.0 * kPi * u), v};
    });
}

/// A sheet bent by a right angle at x = 0.45, up or down.
TestMesh makeCorner(std::uint32_t columns, std::uint32_t rows, double up)
{
    return makePatch(columns, rows, [up](double u, double v) {
        return Point{std::min(u, 0.45), v, up * std::max(0.0, u - 0.45)};
    });
}

} // namespace

TEST(FlippedTriangles, TurnedTriangleOfASmoothSurface)
{
    expectEachTurnedTriangleCounts(makeIcosphere(3), makeIcosphere(1));
    expectEachTurnedTriangleCounts(makeIcosphere(2), makeIcosphere(2));
    expectEachTurnedTriangleCounts(makeIcosphere(4), makeIcosphere(0));
    EXPECT_EQ(flipsOf(makeIcosphere(5), withTurnedTriangle(makeIcosphere(5), 12345)), 1u);
}

TEST(FlippedTriangles, TurnedTriangleOfAnOpenSheet)
{
    expectEachTurnedTriangleCounts(makeGrid(8, 8), makeGrid(4, 4));
    expectEachTurnedTriangleCounts(makeWaves(24), makeWaves(6));
}

TEST(FlippedTriangles, TurnedTriangleBetweenCreases)
{
    expectEachTurnedTriangleCounts(makeCube(4), makeCube(1));
    expectEachTurnedTriangleCounts(makeCube(3), makeCube(3));
    expectEachTurnedTriangleCounts(makeTetrahedron(), makeTetrahedron());
}

TEST(FlippedTriangles, TurnedTriangleOfAThinSheet)
{
    // The coarse layers are farther from their own than from the other one.
    const TestMesh fine = makeThinSheet(24, 0.001), coarse = makeThinSheet(6, 0.001);
    ASSERT_GT(measureDeviation(fine.view(), coarse.view()).value().surface.maximum, 0.01);
    expectEachTurnedTriangleCounts(fine, coarse);
}

TEST(FlippedTriangles, TurnedSliverBesideLargeTriangles)
{
    // Columns from 2e-4 to 0.41 wide.
    const TestMesh mesh = makePatch(8, 2, [](double u, double v) { return Point{u * u * u * u, v, 0.0}; });
    expectEachTurnedTriangleCounts(mesh, mesh);
}

TEST(FlippedTriangles, TurnedTriangleOfARemodelledSurface)
{
    expectEachTurnedTriangleCounts(makeTorus(40, 20), makeTorus(11, 9));
}

TEST(FlippedTriangles, FoldedOverTriangles)
{
    // A vertex of the middle leaves its ring: to no vertex of the original, then to one.
    const TestMesh outside = moved(makeGrid(2, 2), 4, {1.25, 0.5, 0.0});
    ASSERT_GT(countFacingDown(outside), 0u);
    EXPECT_EQ(flipsOf(makeGrid(2, 2), outside), countFacingDown(outside));

    const TestMesh across = moved(makeGrid(4, 4), 12, {0.875, 0.375, 0.0});
    ASSERT_GE(countFacingDown(across), 2u);
    EXPECT_EQ(flipsOf(makeGrid(8, 8), across), countFacingDown(across));
}

TEST(FlippedTriangles, FoldedOverTrianglesOfAThinSheet)
{
    const TestMesh lower = translated(turnedInsideOut(makeGrid(8, 8)), 0.0, 0.0, -1e-4);
    const TestMesh folded = moved(makeGrid(4, 4), 12, {0.875, 0.375, 0.0});
    EXPECT_EQ(flipsOf(joined(makeGrid(8, 8), lower), joined(folded, lower)), countFacingDown(folded));
}

TEST(FlippedTriangles, SidesOfBladesAndSpikesAreNotFlipped)
{
    EXPECT_EQ(flipsOf(makeBlade(32, 24), makeBlade(8, 6)), 0u);
    EXPECT_EQ(flipsOf(makeBlade(32, 24), makeBlade(4, 2)), 0u);
    EXPECT_EQ(flipsOf(makeSpike(24, 24), makeSpike(6, 4)), 0u);
    EXPECT_EQ(flipsOf(makeSpike(24, 24), makeSpike(3, 1)), 0u);
}

TEST(FlippedTriangles, LayersThatCoincideAreNotFlipped)
{
    EXPECT_EQ(flipsOf(makeThinSheet(24, 0.0), makeThinSheet(6, 0.0)), 0u);
    EXPECT_EQ(flipsOf(makeTwoSidedWall(6), makeTwoSidedWall(2)), 0u);
    EXPECT_EQ(flipsOf(makeClosedLips(8), makeClosedLips(2)), 0u);
    EXPECT_EQ(flipsOf(makeLeafCards(40), makeLeafCards(40)), 0u);
    EXPECT_EQ(flipsOf(makeSoup(60), makeSoup(60)), 0u);
}

TEST(FlippedTriangles, BridgesOverCornersAreNotFlipped)
{
    for (const double up : {1.0, -1.0})
        for (const std::uint32_t columns : {1u, 4u, 5u})
            EXPECT_EQ(flipsOf(makeCorner(20, 4, up), makeCorner(columns, 1, up)), 0u) << columns << " columns";
    // A lid over a deep groove faces its floor's way, though the groove's walls are nearer.
    const auto groove = [](std::uint32_t columns) {
        return makePatch(columns, 1, [](double u, double v) {
            const double across = std::abs(u - 0.5);
            return Point{u, v, across < 0.06 ? -0.5 : 0.0};
        });
    };
    EXPECT_EQ(flipsOf(groove(20), groove(1)), 0u);
}

TEST(FlippedTriangles, BridgesFromOneSideOfASheetToTheOtherAreNotFlipped)
{
    // The sheet turns back at x = 0.55; without that edge, triangles lead from the front at 0.4 to the back at 0.5.
    // Those that face the front's way have two corners on the back.
    const auto hairpin = [](std::uint32_t columns) {
        return makePatch(columns, 1, [](double u, double v) {
            const bool front = u < 0.56;
            return Point{front ? u : 1.1 - u, v, front ? 0.0 : -0.01};
        });
    };
    EXPECT_EQ(flipsOf(hairpin(20), hairpin(5)), 0u);
}

TEST(FlippedTriangles, TrianglesThatStandAcrossAreNotFlipped)
{
    // A wall between two floors at right angles to it, all leaning so that coordinates are rounded.
    TestMesh floors = joined(makeGrid(4, 4), translated(makeGrid(4, 4), 0.0, 0.0, 1.0));
    const auto lean = [](float* p) {
        const double x = p[0], z = p[2];
        p[0] = static_cast<float>(std::cos(0.3) * x + std::sin(0.3) * z);
        p[2] = static_cast<float>(std::cos(0.3) * z - std::sin(0.3) * x);
    };
    for (TestBuffer& buffer : floors.buffers)
        for (std::uint32_t i = 0; i < buffer.vertexCount(); ++i)
            lean(&buffer.positions[3 * i]);
    TestMesh wall;
    wall.buffers.resize(1);
    wall.subMeshes.resize(1);
    for (const double y : {0.25, 0.5, 0.75})
        for (const double z : {0.0, 1.0})
            lean(&wall.buffers[0].positions[3 * wall.buffers[0].addPosition(0.5, y, z)]);
    wall.subMeshes[0].addQuad(0, 2, 3, 1);
    wall.subMeshes[0].addQuad(2, 4, 5, 3);
    EXPECT_EQ(flipsOf(floors, joined(floors, wall)), 0u);
    EXPECT_EQ(flipsOf(floors, joined(floors, turnedInsideOut(wall))), 0u);
}

TEST(FlippedTriangles, CoarseLevelsOfCurvedSurfacesAreNotFlipped)
{
    EXPECT_EQ(flipsOf(makeIcosphere(5), makeIcosphere(0)), 0u);
    EXPECT_EQ(flipsOf(makeTorus(64, 32), makeTorus(8, 4)), 0u);
    EXPECT_EQ(flipsOf(makeTerrain(40), makeTerrain(5)), 0u);
}

TEST(FlippedTriangles, TrianglesWithoutAreaAreNotFlipped)
{
    TestMesh needles = makeGrid(4, 4);
    needles.subMeshes[0].addTriangle(0, 2, 1);
    needles.subMeshes[0].addTriangle(0, 1, 2);
    EXPECT_EQ(flipsOf(makeGrid(4, 4), needles), 0u);
    EXPECT_EQ(flipsOf(needles, withTurnedTriangle(needles, 7)), 1u);
}
