#include "support/CheckedSimplify.h"
#include "support/MeshBuilders.h"
#include "support/WeldedMesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace lodsmith {

namespace {

using namespace test;

/// An importance for every vertex, by its position.
template <class Importance>
TestMesh weighted(TestMesh mesh, const Importance& importance)
{
    for (TestBuffer& buffer : mesh.buffers) {
        for (std::uint32_t vertex = 0; vertex < buffer.vertexCount(); ++vertex) {
            const float* p = &buffer.positions[3 * std::size_t(vertex)];
            buffer.importance.push_back(static_cast<float>(importance(Point{p[0], p[1], p[2]})));
        }
    }
    return mesh;
}

std::size_t countWhere(const TestMesh& mesh, const LodChainLevel& level, bool (*condition)(const Point&))
{
    const MeshView view = mesh.view();
    const WeldedPositions welded = weldPositions(view);
    std::set<std::uint32_t> found;
    for (const WeldedTriangle& triangle : weldedTriangles(view, welded, level.indices)) {
        for (const std::uint32_t position : triangle.positions) {
            if (condition(welded.points[position]))
                found.insert(position);
        }
    }
    return found.size();
}

bool isLeft(const Point& p)
{
    return p[0] < 0.5;
}

TEST(Lock, ImportanceOneStays)
{
    const TestMesh mesh = weighted(makeTerrain(16), [](const Point& p) { return isLeft(p) ? 1.0 : 0.0; });
    const LodChain chain = simplifyChecked(mesh.view(), {removedShare(0.3), removedShare(1.0)});
    EXPECT_EQ(countWhere(mesh, chain.levels[1], &isLeft), 8u * 17u);
    EXPECT_EQ(chain.levels[1].stop, StopReason::Locked);
}

TEST(Lock, EverythingLockedIsSkipped)
{
    const TestMesh mesh = weighted(makeTerrain(8), [](const Point&) { return 1.0; });
    const LodChain chain = simplifyChecked(mesh.view(), {removedShare(0.5), keptTriangles(3)});
    for (const LodChainLevel& level : chain.levels) {
        EXPECT_TRUE(level.skipped);
        EXPECT_EQ(level.stop, StopReason::Locked);
    }
}

TEST(Lock, NoImportanceIsImportanceZero)
{
    const TestMesh plain = makeTerrain(12);
    const TestMesh mesh = weighted(plain, [](const Point&) { return 0.0; });
    EXPECT_EQ(simplifyChecked(mesh.view(), {removedShare(0.6)}).levels[0].indices,
              simplifyChecked(plain.view(), {removedShare(0.6)}).levels[0].indices);
}

TEST(Lock, EqualImportanceEverywhereChangesNoOrder)
{
    const TestMesh plain = makeTerrain(12);
    const TestMesh mesh = weighted(plain, [](const Point&) { return 0.5; });
    EXPECT_EQ(simplifyChecked(mesh.view(), {removedShare(0.6)}).levels[0].indices,
              simplifyChecked(plain.view(), {removedShare(0.6)}).levels[0].indices);
}

TEST(Lock, MoreImportantPlacesKeepMore)
{
    const auto hills = [](double u, double v) { return Point{u, v, 0.1 * std::sin(25.0 * u) * std::sin(25.0 * v)}; };
    const TestMesh plain = makePatch(24, 24, hills);
    const TestMesh mesh = weighted(plain, [](const Point& p) { return isLeft(p) ? 0.8 : 0.0; });
    for (const Metric metric : {Metric::Quadric, Metric::Curvature}) {
        SimplifyOptions options;
        options.metric = metric;
        const LodChain chain = simplifyChecked(mesh.view(), {removedShare(0.6)}, options);
        const LodChain even = simplifyChecked(plain.view(), {removedShare(0.6)}, options);
        const std::size_t left = countWhere(mesh, chain.levels[0], &isLeft);
        EXPECT_GT(left, countWhere(plain, even.levels[0], &isLeft) * 5 / 4);
        EXPECT_GT(2 * left, chain.levels[0].vertices);
    }
}

TEST(Lock, TheMostImportantWedgeCounts)
{
    TestMesh mesh = flatShaded(makeCube(1));
    mesh.buffers[0].importance.assign(mesh.buffers[0].vertexCount(), 0.0f);
    for (std::uint32_t vertex = 0; vertex < mesh.buffers[0].vertexCount(); vertex += 5)
        mesh.buffers[0].importance[vertex] = 1.0f;
    simplifyChecked(mesh.view(), {removedShare(1.0)});
}

TEST(Lock, BordersStayWhenLocked)
{
    const TestMesh mesh = makeTerrain(16);
    SimplifyOptions options;
    options.lockBorders = true;
    const LodChain chain = simplifyChecked(mesh.view(), {removedShare(0.5), removedShare(1.0)}, options);
    EXPECT_EQ(countWhere(mesh, chain.levels[1],
                         [](const Point& p) { return p[0] == 0.0 || p[0] == 1.0 || p[1] == 0.0 || p[1] == 1.0; }),
              64u);
    EXPECT_EQ(chain.levels[1].stop, StopReason::Locked);
}

TEST(Lock, NeighbouringChunksMatchWhenBordersAreLocked)
{
    // Two halves simplified apart, put together again, are as closed as they were.
    const auto hills = [](double u, double v) { return Point{u, v, 0.1 * std::sin(9.0 * u) * std::cos(7.0 * v)}; };
    const TestMesh left = makePatch(12, 12, hills);
    const TestMesh right = makePatch(12, 12, [&](double u, double v) { return hills(u + 1.0, v); });
    SimplifyOptions options;
    options.lockBorders = true;
    TestMesh both = joined(left, right);
    const auto borderEdges = [](const TestMesh& mesh) {
        const MeshView view = mesh.view();
        return Connectivity(weldedTriangles(view, weldPositions(view), indexLists(view))).borderEdges;
    };
    const std::uint32_t before = borderEdges(both);
    EXPECT_EQ(before, 72u);
    both.subMeshes[0].indices = simplifyChecked(left.view(), {removedShare(0.5)}, options).levels[0].indices[0];
    both.subMeshes[1].indices = simplifyChecked(right.view(), {removedShare(0.5)}, options).levels[0].indices[0];
    EXPECT_EQ(borderEdges(both), before);
}

TEST(Lock, AClosedMeshHasNoBorderToLock)
{
    const TestMesh mesh = makeUvSphere(16, 12);
    SimplifyOptions options;
    options.lockBorders = true;
    EXPECT_EQ(simplifyChecked(mesh.view(), {removedShare(0.7)}, options).levels[0].indices,
              simplifyChecked(mesh.view(), {removedShare(0.7)}).levels[0].indices);
}

TEST(Lock, SeamsStayWhenLocked)
{
    const TestMesh mesh = makeUvSphere(16, 12);
    SimplifyOptions options;
    options.lockSeams = true;
    const LodChain chain = simplifyChecked(mesh.view(), {removedShare(0.5), removedShare(1.0)}, options);
    EXPECT_EQ(countWhere(mesh, chain.levels[1], [](const Point& p) { return p[1] == 0.0 && p[0] >= 0.0; }), 13u)
        << "the seam runs from pole to pole over 11 rings";
    EXPECT_EQ(chain.levels[1].stop, StopReason::Locked);
}

TEST(Lock, AFacetedMeshIsAllSeam)
{
    const TestMesh mesh = flatShaded(makeIcosphere(1));
    SimplifyOptions options;
    options.lockSeams = true;
    const LodChain chain = simplifyChecked(mesh.view(), {removedShare(0.5)}, options);
    EXPECT_TRUE(chain.levels[0].skipped);
    EXPECT_EQ(chain.levels[0].stop, StopReason::Locked);
}

} // namespace

} // namespace lodsmith
