#include "support/CheckedSimplify.h"
#include "support/MeshBuilders.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lodsmith {

namespace {

using namespace test;

/// A flat grid with single triangles hovering over it, `height` above, each in a submesh of its own.
TestMesh gridWithTriangles(const std::vector<double>& heights, double size = 0.02)
{
    TestMesh mesh = makeGrid(8, 8);
    for (const double height : heights) {
        TestMesh triangle;
        triangle.buffers.resize(1);
        triangle.subMeshes.resize(1);
        TestBuffer& buffer = triangle.buffers[0];
        triangle.subMeshes[0].addTriangle(buffer.addPosition(0.4, 0.4, height),
                                          buffer.addPosition(0.4 + size, 0.4, height),
                                          buffer.addPosition(0.4, 0.4 + size, height));
        mesh = joined(mesh, triangle);
    }
    return mesh;
}

bool isThere(const LodChainLevel& level, std::size_t subMesh)
{
    return !level.indices[subMesh].empty();
}

TEST(Piece, ManyPiecesReachEveryTarget)
{
    for (const TestMesh& mesh : {makeSoup(100), makeIslands(40), makeLeafCards(100)}) {
        const LodChain chain = simplifyChecked(
            mesh.view(), {removedShare(0.5), removedShare(0.75), removedShare(0.875), removedShare(0.9375)});
        for (const LodChainLevel& level : chain.levels)
            EXPECT_EQ(level.stop, StopReason::TargetReached);
        EXPECT_LE(chain.levels.back().vertices, chain.vertices / 16 + 1);
    }
}

TEST(Piece, TheLastOneStays)
{
    for (const TestMesh& mesh : {makeSoup(10), makeIslands(3), makeLeafCards(5)}) {
        const LodChain chain = simplifyChecked(mesh.view(), {removedShare(1.0)});
        EXPECT_EQ(chain.levels[0].stop, StopReason::Topology);
        EXPECT_GE(chain.levels[0].triangles, 1u);
        EXPECT_LE(chain.levels[0].triangles, 4u);
    }
}

TEST(Piece, TheNearerOneGoesFirst)
{
    const TestMesh mesh = gridWithTriangles({0.5, 0.001, 0.2});
    // Flat as the grid is, its inner vertices go first.
    const LodChain chain = simplifyChecked(mesh.view(), {keptTriangles(4), keptTriangles(3), keptTriangles(2)});
    EXPECT_TRUE(isThere(chain.levels[0], 1));
    EXPECT_FALSE(isThere(chain.levels[0], 2));
    EXPECT_TRUE(isThere(chain.levels[0], 3));
    EXPECT_TRUE(isThere(chain.levels[1], 1));
    EXPECT_FALSE(isThere(chain.levels[1], 3));
}

TEST(Piece, TheDistanceToWhatStaysIsItsDeviation)
{
    const TestMesh mesh = gridWithTriangles({0.25});
    const LodChain chain = simplifyChecked(mesh.view(), {greatestDeviation(0.2), greatestDeviation(0.3)});
    EXPECT_TRUE(isThere(chain.levels[0], 1));
    EXPECT_EQ(chain.levels[0].stop, StopReason::TargetReached);
    EXPECT_FALSE(isThere(chain.levels[1], 1));
    // A corner may be off the edge of the face below the centre, by less than the triangle is long.
    EXPECT_GE(chain.levels[1].deviation, 0.25);
    EXPECT_LT(chain.levels[1].deviation, std::hypot(0.25, 0.03));
}

TEST(Piece, TheDistanceToWhatStaysIsItsCost)
{
    const TestMesh mesh = gridWithTriangles({0.25});
    for (const Metric metric : {Metric::Quadric, Metric::Curvature}) {
        SimplifyOptions options;
        options.metric = metric;
        options.lockBorders = true; // of the grid; a triangle is all border
        EXPECT_TRUE(isThere(simplifyChecked(mesh.view(), {dearestCollapse(10.0)}, options).levels[0], 1));
        options.lockBorders = false;
        const LodChain chain = simplifyChecked(mesh.view(), {dearestCollapse(0.24), dearestCollapse(0.26)}, options);
        EXPECT_TRUE(isThere(chain.levels[0], 1));
        EXPECT_FALSE(isThere(chain.levels[1], 1));
    }
}

TEST(Piece, ImportanceDelays)
{
    TestMesh mesh = gridWithTriangles({0.1});
    mesh.buffers[1].importance = {0.0f, 0.5f, 0.0f}; // doubles the cost
    const LodChain chain = simplifyChecked(mesh.view(), {dearestCollapse(0.15), dearestCollapse(0.25)});
    EXPECT_TRUE(isThere(chain.levels[0], 1));
    EXPECT_FALSE(isThere(chain.levels[1], 1));
}

TEST(Piece, ImportanceOneStays)
{
    TestMesh mesh = gridWithTriangles({0.1});
    mesh.buffers[1].importance = {0.0f, 0.0f, 1.0f};
    EXPECT_TRUE(isThere(simplifyChecked(mesh.view(), {keptTriangles(1)}).levels[0], 1));
}

TEST(Piece, LargePiecesCollapseFirst)
{
    const TestMesh mesh = joined(makeIcosphere(3), translated(makeIcosphere(3, 0.5), 3, 0, 0));
    const LodChain chain = simplifyChecked(mesh.view(), {removedShare(0.9)});
    EXPECT_TRUE(isThere(chain.levels[0], 0));
    EXPECT_TRUE(isThere(chain.levels[0], 1));
}

} // namespace

} // namespace lodsmith
