#include "ClosestPoint.h"
#include "support/CheckedSimplify.h"
#include "support/MeshBuilders.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lodsmith {

namespace {

using namespace test;

TestMesh makeTriangle(double x, double y, double z, double size)
{
    TestMesh triangle;
    triangle.buffers.resize(1);
    triangle.subMeshes.resize(1);
    TestBuffer& buffer = triangle.buffers[0];
    triangle.subMeshes[0].addTriangle(buffer.addPosition(x, y, z), buffer.addPosition(x + size, y, z),
                                      buffer.addPosition(x, y + size, z));
    return triangle;
}

/// A flat grid with single triangles hovering over it, `height` above, each in a submesh of its own.
TestMesh gridWithTriangles(const std::vector<double>& heights, double size = 0.02)
{
    TestMesh mesh = makeGrid(8, 8);
    for (const double height : heights)
        mesh = joined(mesh, makeTriangle(0.4, 0.4, height, size));
    return mesh;
}

/// Leaf cards with a back, split the other way: no collapse makes one smaller.
TestMesh makeClosedCards(std::uint32_t count)
{
    TestMesh mesh = makeLeafCards(count);
    for (std::uint32_t first = 0; first < 4 * count; first += 4)
        mesh.subMeshes[0].addQuad(first + 3, first + 2, first + 1, first);
    return mesh;
}

Vec3 positionOf(const TestMesh& mesh, std::uint32_t vertex)
{
    const float* p = &mesh.buffers[0].positions[std::size_t{3} * vertex];
    return {double(p[0]), double(p[1]), double(p[2])};
}

double distanceToSurface(const Vec3& point, const TestMesh& mesh)
{
    double least = std::numeric_limits<double>::infinity();
    const std::vector<std::uint32_t>& indices = mesh.subMeshes[0].indices;
    for (std::size_t i = 0; i < indices.size(); i += 3) {
        const Corners corners{positionOf(mesh, indices[i]), positionOf(mesh, indices[i + 1]),
                              positionOf(mesh, indices[i + 2])};
        least = std::min(least, closestPointOnTriangle(point, corners).squaredDistance);
    }
    return std::sqrt(least);
}

bool isThere(const LodChainLevel& level, std::size_t subMesh)
{
    return !level.indices[subMesh].empty();
}

TEST(Piece, ManyPiecesReachEveryTarget)
{
    for (const TestMesh& mesh : {makeSoup(100), makeIslands(40), makeLeafCards(100), makeClosedCards(100)}) {
        const LodChain chain = simplifyChecked(
            mesh.view(), {removedShare(0.5), removedShare(0.75), removedShare(0.875), removedShare(0.9375)});
        for (const LodChainLevel& level : chain.levels)
            EXPECT_EQ(level.stop, StopReason::TargetReached);
        EXPECT_LE(chain.levels.back().vertices, chain.vertices / 16 + 1);
    }
}

TEST(Piece, TheLastOneStays)
{
    for (const TestMesh& mesh : {makeSoup(10), makeIslands(3), makeLeafCards(5), makeClosedCards(5)}) {
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

TEST(Piece, IsLeftToTheNearestFace)
{
    TestMesh soup = makeSoup(500);
    soup.buffers[0].importance.assign(soup.buffers[0].vertexCount(), 1.0f); // stays as it is
    TestRandom random(7);
    for (int i = 0; i < 40; ++i) {
        const Vec3 at{random.uniform(-0.5, 1.5), random.uniform(-0.5, 1.5), random.uniform(-0.5, 1.5)};
        const double distance = distanceToSurface(at, soup), size = 1e-3 * distance;
        TestMesh speck;
        speck.buffers.resize(1);
        speck.subMeshes.resize(1);
        TestBuffer& buffer = speck.buffers[0];
        speck.subMeshes[0].addTriangle(buffer.addPosition(at.x, at.y, at.z),
                                       buffer.addPosition(at.x + size, at.y, at.z),
                                       buffer.addPosition(at.x, at.y + size, at.z));
        const TestMesh mesh = joined(soup, speck);
        const LodChain chain =
            simplifyChecked(mesh.view(), {greatestDeviation(0.99 * distance), greatestDeviation(1.01 * distance)});
        EXPECT_TRUE(chain.levels[0].skipped) << distance;
        ASSERT_FALSE(chain.levels[1].skipped) << distance;
        EXPECT_FALSE(isThere(chain.levels[1], 1)) << distance;
    }
}

TEST(Piece, IsNotTakenForASingleVertex)
{
    TestMesh mesh = makeGrid(8, 8);
    for (std::size_t i = 0; i < 81; ++i) // bumps, so that the piece is the cheapest of all
        mesh.buffers[0].positions[3 * i + 2] = 0.1f * static_cast<float>(i * 7 % 13);
    const Vec3 tip = positionOf(mesh, 40);
    mesh = joined(mesh, makeTriangle(tip.x, tip.y, tip.z + 1e-4, 1e-3));
    const LodChain chain = simplifyChecked(mesh.view(), {removedVertices(1), removedVertices(4)});
    EXPECT_EQ(chain.levels[0].vertices, chain.vertices - 1);
    EXPECT_TRUE(isThere(chain.levels[0], 1));
    EXPECT_EQ(chain.levels[1].vertices, chain.vertices - 4) << "three at once, since the target is far enough now";
    EXPECT_FALSE(isThere(chain.levels[1], 1));
}

TEST(Piece, IsTakenForASingleVertexWhereNothingElseCanGo)
{
    const TestMesh mesh = makeClosedCards(3);
    const LodChain chain = simplifyChecked(mesh.view(), {removedVertices(1)});
    EXPECT_EQ(chain.levels.at(0).vertices, chain.vertices - 4);
    EXPECT_EQ(chain.levels.at(0).stop, StopReason::TargetReached);
}

TEST(Piece, CostsLessThatSavesMore)
{
    // Beside the grid, which comes down to two triangles: one triangle, and one with a back, equally high, whose two sides
    // together have a tenth more area. It saves as many vertices, but twice the triangles.
    TestMesh mesh = gridWithTriangles({0.1});
    TestMesh closed;
    closed.buffers.resize(1);
    closed.subMeshes.resize(1);
    const double side = 0.02 * std::sqrt(0.55);
    TestBuffer& buffer = closed.buffers[0];
    const std::uint32_t a = buffer.addPosition(0.7, 0.7, 0.1), b = buffer.addPosition(0.7 + side, 0.7, 0.1),
                        c = buffer.addPosition(0.7, 0.7 + side, 0.1);
    closed.subMeshes[0].addTriangle(a, b, c);
    closed.subMeshes[0].addTriangle(c, b, a);
    mesh = joined(mesh, closed);
    const LodChain byVertices = simplifyChecked(mesh.view(), {removedVertices(9 * 9 - 4 + 3)});
    EXPECT_FALSE(isThere(byVertices.levels[0], 1));
    EXPECT_TRUE(isThere(byVertices.levels[0], 2));
    const LodChain byTriangles = simplifyChecked(mesh.view(), {keptTriangles(2 + 1)});
    EXPECT_TRUE(isThere(byTriangles.levels[0], 1));
    EXPECT_FALSE(isThere(byTriangles.levels[0], 2));
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
