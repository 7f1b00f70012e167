#include <lodsmith/analysis/Deviation.h>

#include "support/MeshBuilders.h"

#include <gtest/gtest.h>

using namespace lodsmith;
using namespace lodsmith::test;

namespace {

Deviation deviationOf(const TestMesh& original, const TestMesh& simplified)
{
    DeviationOptions options;
    options.samples = 100;
    return measureDeviation(original.view(), simplified.view(), options).value();
}

TestMesh withIndices(TestMesh mesh, std::vector<std::uint32_t> indices)
{
    mesh.subMeshes[0].indices = std::move(indices);
    return mesh;
}

TestMesh withoutTriangle(TestMesh mesh, std::size_t triangle)
{
    std::vector<std::uint32_t>& indices = mesh.subMeshes[0].indices;
    indices.erase(indices.begin() + 3 * triangle, indices.begin() + 3 * triangle + 3);
    return mesh;
}

} // namespace

// The grid of 2 x 2 cells:
//   6 7 8
//   3 4 5
//   0 1 2

TEST(DeviationTopology, CoarserBordersAreOldBorders)
{
    const Deviation grid = deviationOf(makeGrid(8, 8), makeGrid(1, 1));
    EXPECT_EQ(grid.newBorderEdges, 0u);
    EXPECT_EQ(grid.newNonManifoldEdges, 0u);
    EXPECT_EQ(deviationOf(makeCylinder(16, 8), makeCylinder(4, 2)).newBorderEdges, 0u);
    EXPECT_EQ(deviationOf(makeTwoMaterials(4, false), makeTwoMaterials(1, true)).newBorderEdges, 0u);
}

TEST(DeviationTopology, CornerCutAwayIsACollapse)
{
    // Triangle 3 of the grid is the only one at vertex 2: without it the border runs from 1 to 5.
    const TestMesh grid = makeGrid(2, 2);
    EXPECT_EQ(deviationOf(grid, withoutTriangle(grid, 2)).newBorderEdges, 0u);
}

TEST(DeviationTopology, Hole)
{
    const TestMesh grid = makeGrid(4, 4), sphere = makeUvSphere(12, 8);
    EXPECT_EQ(deviationOf(grid, withoutTriangle(grid, 13)).newBorderEdges, 3u);
    EXPECT_EQ(deviationOf(sphere, withoutTriangle(sphere, 40)).newBorderEdges, 3u);
    EXPECT_EQ(deviationOf(withoutTriangle(sphere, 40), withoutTriangle(sphere, 40)).newBorderEdges, 0u);
}

TEST(DeviationTopology, CrackBetweenDifferentSubdivisions)
{
    // The left half leaves out vertex 4, which the right half still uses: a slit between 1 and 7, though both are
    // border vertices and lie on one border.
    const TestMesh cracked = withIndices(makeGrid(2, 2), {0, 1, 7, 0, 7, 6, 1, 2, 5, 1, 5, 4, 4, 5, 8, 4, 8, 7});
    const Deviation deviation = deviationOf(makeGrid(2, 2), cracked);
    EXPECT_EQ(deviation.newBorderEdges, 3u); // 1-7, 1-4, 4-7
    EXPECT_EQ(deviation.newNonManifoldEdges, 0u);
    EXPECT_NEAR(deviation.surface.maximum, 0.0, 1e-12); // nothing else would tell
}

TEST(DeviationTopology, CrackAlongASeamThatMovedApart)
{
    TestMesh torn = makeCylinder(12, 4);
    // One of the two wedges at the seam, half-way up: first column of the third row.
    torn.buffers[0].positions[3 * (2 * 13)] += 0.01f;
    EXPECT_EQ(deviationOf(makeCylinder(12, 4), torn).newBorderEdges, 4u); // both sides of two edges
}

TEST(DeviationTopology, BorderPulledIntoTheSurfaceIsNew)
{
    // Vertex 1 of the grid went to vertex 4: the border now dips into the surface.
    const TestMesh dipped = withIndices(makeGrid(2, 2), {0, 4, 3, 4, 2, 5, 3, 4, 7, 3, 7, 6, 4, 5, 8, 4, 8, 7});
    EXPECT_EQ(deviationOf(makeGrid(2, 2), dipped).newBorderEdges, 2u);
}

TEST(DeviationTopology, ClosedHoleIsNotCounted)
{
    const TestMesh sphere = makeUvSphere(12, 8);
    EXPECT_EQ(deviationOf(withoutTriangle(sphere, 40), sphere).newBorderEdges, 0u);
}

TEST(DeviationTopology, RepeatedTriangles)
{
    const TestMesh grid = makeGrid(2, 2);
    TestMesh doubled = grid;
    doubled.subMeshes[0].addTriangle(4, 3, 0); // the second triangle again, from another corner
    const Deviation deviation = deviationOf(grid, doubled);
    EXPECT_EQ(deviation.repeatedTriangles, 1u);
    EXPECT_EQ(deviation.newNonManifoldEdges, 0u);
    EXPECT_EQ(deviation.newBorderEdges, 0u);
    EXPECT_EQ(deviationOf(makeTwoSidedWall(2), makeTwoSidedWall(2)).repeatedTriangles, 0u); // other winding
    EXPECT_EQ(deviationOf(joined(grid, grid), joined(grid, grid)).repeatedTriangles, 0u);   // other submesh
}

TEST(DeviationTopology, CleaningTheOriginalIsNoDeviation)
{
    TestMesh dirty = makeGrid(2, 2);
    for (const std::uint32_t corner : {0u, 1u, 4u, 0u, 1u, 4u, 3u, 3u, 5u})
        dirty.subMeshes[0].indices.push_back(corner);
    const Deviation deviation = deviationOf(dirty, makeGrid(2, 2));
    EXPECT_EQ(deviation.newBorderEdges, 0u);
    EXPECT_EQ(deviation.newNonManifoldEdges, 0u);
    EXPECT_EQ(deviation.repeatedTriangles, 0u);
    EXPECT_EQ(deviation.degenerateTriangles, 0u);
    EXPECT_EQ(deviationOf(makeGrid(2, 2), dirty).degenerateTriangles, 1u);
}

TEST(DeviationTopology, FinIsNonManifold)
{
    // A third triangle on edge 1-4, with its tip at 6: neither 1-6 nor 4-6 is an edge of the grid.
    TestMesh finned = makeGrid(2, 2);
    finned.subMeshes[0].addTriangle(1, 4, 6);
    const Deviation deviation = deviationOf(makeGrid(2, 2), finned);
    EXPECT_EQ(deviation.newNonManifoldEdges, 1u);
    EXPECT_EQ(deviation.newBorderEdges, 2u);
    EXPECT_EQ(deviationOf(finned, finned).newNonManifoldEdges, 0u);
}

TEST(DeviationTopology, NonManifoldEdgesMayLoseTrianglesButNotGainThem)
{
    const TestMesh four = makeBook(4);
    const TestMesh three = withoutTriangle(four, 3);
    EXPECT_EQ(deviationOf(four, three).newNonManifoldEdges, 0u);
    EXPECT_EQ(deviationOf(three, four).newNonManifoldEdges, 1u);
}

TEST(DeviationTopology, CoarserTwoSidedWall)
{
    const Deviation deviation = deviationOf(makeTwoSidedWall(8), makeTwoSidedWall(2));
    EXPECT_EQ(deviation.newBorderEdges, 0u);
    EXPECT_EQ(deviation.newNonManifoldEdges, 0u);
}

TEST(DeviationTopology, NonManifoldEdgeMayMoveAlongTheOutlineOfAWall)
{
    // On both sides of a wall vertex 1 of the 2 x 2 grid went to vertex 0 along the outline, where edges have two
    // triangles: edge 1-4, which had four, and edge 1-5 now start at 0.
    const TestMesh wall = makeTwoSidedWall(2);
    const std::vector<std::uint32_t> front{0, 4, 3, 0, 2, 5, 0, 5, 4, 3, 4, 7, 3, 7, 6, 4, 5, 8, 4, 8, 7};
    TestMesh moved = withIndices(wall, front);
    for (std::size_t i = 0; i < front.size(); i += 3)
        moved.subMeshes[0].addTriangle(9 + front[i], 9 + front[i + 2], 9 + front[i + 1]);
    const Deviation deviation = deviationOf(wall, moved);
    EXPECT_EQ(deviation.newNonManifoldEdges, 0u);
    EXPECT_EQ(deviation.newBorderEdges, 0u);
}

TEST(DeviationTopology, ReverseOfATwoSidedWallMissing)
{
    TestMesh front = makeTwoSidedWall(2);
    front.subMeshes[0].indices.resize(front.subMeshes[0].indices.size() / 2);
    EXPECT_EQ(deviationOf(makeTwoSidedWall(2), front).newBorderEdges, 8u); // its outline had two triangles an edge
}
