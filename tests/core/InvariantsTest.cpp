// The checks that every other test relies on: each has to notice the one thing that is wrong.

#include "support/Invariants.h"
#include "support/MeshBuilders.h"
#include "support/SurfaceDistance.h"
#include "support/WeldedMesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace lodsmith {

namespace {

using namespace test;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

const std::vector<LevelTarget> kOneRemoved = {{LevelTarget::Kind::Constant, 1.0}};

/// A disc of six triangles around vertex 0, raised in the middle, and the level in which 0 has gone to 1: sound in all.
struct Disc {
    Disc() : mesh(makeFan(6))
    {
        mesh.buffers[0].positions[2] = 0.25f;
        chain.vertices = 7;
        chain.bufferVertices = 7;
        chain.triangles = 6;
        chain.radius = 1.0;
        chain.levels.resize(1);
        LodChainLevel& level = chain.levels[0];
        level.indices = {{1, 2, 3, 1, 3, 4, 1, 4, 5, 1, 5, 6}};
        level.vertices = 6;
        level.triangles = 4;
        level.deviation = 0.3;
        level.cost = 0.1;
    }

    std::vector<std::string> broken(const SimplifyOptions& options = {}) const
    {
        return brokenInvariants(mesh.view(), kOneRemoved, options, chain);
    }

    LodChainLevel& level() { return chain.levels[0]; }

    TestMesh mesh;
    LodChain chain;
};

TEST(Invariants, ASoundChainBreaksNone)
{
    EXPECT_THAT(Disc().broken(), IsEmpty());
}

TEST(Invariants, NoticeIndices)
{
    Disc outOfRange;
    outOfRange.level().indices[0][4] = 7;
    EXPECT_THAT(outOfRange.broken(), Contains(HasSubstr("did not use")));
    Disc cut;
    cut.level().indices[0].pop_back();
    EXPECT_THAT(cut.broken(), Contains(HasSubstr("no triangle list")));
    Disc lists;
    lists.level().indices.push_back({});
    EXPECT_THAT(lists.broken(), Contains(HasSubstr("2 index lists")));
}

TEST(Invariants, NoticeTrianglesThatDrawNothingOrTwice)
{
    Disc degenerate;
    degenerate.level().indices[0][2] = 2;
    EXPECT_THAT(degenerate.broken(), Contains(HasSubstr("1 degenerate")));
    Disc repeated;
    repeated.level().indices[0].insert(repeated.level().indices[0].end(), {3, 1, 2});
    EXPECT_THAT(repeated.broken(), Contains(HasSubstr("1 repeated")));
}

TEST(Invariants, NoticeWrongCounts)
{
    Disc triangles;
    triangles.level().triangles = 5;
    EXPECT_THAT(triangles.broken(), Contains(HasSubstr("reports 5 triangles, has 4")));
    Disc vertices;
    vertices.level().vertices = 5;
    EXPECT_THAT(vertices.broken(), Contains(HasSubstr("reports 5 vertices, has 6")));
    Disc input;
    input.chain.vertices = 8;
    EXPECT_THAT(input.broken(), Contains(HasSubstr("vertices is 8, counted 7")));
}

TEST(Invariants, NoticeAHole)
{
    Disc hole;
    hole.level().indices = {{0, 1, 2, 0, 3, 4, 0, 4, 5, 0, 5, 6, 0, 6, 1}};
    hole.level().triangles = 5;
    hole.level().vertices = 7;
    EXPECT_THAT(hole.broken(), Contains(HasSubstr("no part of a border")));
    EXPECT_THAT(hole.broken(), Contains(HasSubstr("7 border edges at rest, the input had 6")));
}

TEST(Invariants, NoticeAFallingEulerCharacteristic)
{
    // A tube's wall in place of a disc: two triangles of the middle are missing.
    const TestMesh mesh = makeGrid(3, 3);
    LodChain chain;
    chain.vertices = chain.bufferVertices = 16;
    chain.triangles = 18;
    chain.radius = std::sqrt(0.5);
    chain.levels.resize(1);
    LodChainLevel& level = chain.levels[0];
    level.indices = {mesh.subMeshes[0].indices};
    level.indices[0].erase(level.indices[0].begin() + 24, level.indices[0].begin() + 30);
    level.vertices = 16;
    level.triangles = 16;
    level.deviation = 1.0;
    EXPECT_THAT(brokenInvariants(mesh.view(), kOneRemoved, {}, chain), Contains(HasSubstr("skipped is 0")));
    EXPECT_THAT(brokenInvariants(mesh.view(), kOneRemoved, {}, chain),
                Contains(HasSubstr("Euler characteristic 0 at rest")));
}

TEST(Invariants, NoticeANewNonManifoldEdge)
{
    Disc fin;
    fin.level().indices[0].insert(fin.level().indices[0].end(), {1, 3, 5});
    fin.level().triangles = 5;
    EXPECT_THAT(fin.broken(), Contains(HasSubstr("non-manifold edges at rest, the input had 0")));
}

TEST(Invariants, NoticeAFlip)
{
    Disc flipped;
    std::swap(flipped.level().indices[0][0], flipped.level().indices[0][1]);
    EXPECT_THAT(flipped.broken(), Contains(HasSubstr("triangle 0 is flipped")));
}

TEST(Invariants, NoticeADeviationThatIsTooSmall)
{
    Disc off;
    off.level().deviation = 0.2; // the apex is 0.25 above the level
    EXPECT_THAT(off.broken(), Contains(HasSubstr("off the level")));
    off.level().deviation = 0.25 + 1e-9;
    EXPECT_THAT(off.broken(), IsEmpty());
}

TEST(Invariants, NoticeLevelsThatGetFiner)
{
    Disc disc;
    disc.chain.levels.push_back(disc.chain.levels[0]);
    LodChainLevel& second = disc.chain.levels[1];
    second.deviation = 0.29;
    second.cost = 0.0;
    const std::vector<LevelTarget> targets = {kOneRemoved[0], kOneRemoved[0]};
    const std::vector<std::string> broken = brokenInvariants(disc.mesh.view(), targets, {}, disc.chain);
    EXPECT_THAT(broken, Contains(HasSubstr("level 2: less deviation")));
    EXPECT_THAT(broken, Contains(HasSubstr("level 2: cost")));
    EXPECT_THAT(broken, Contains(HasSubstr("level 2: skipped is 0")));
}

TEST(Invariants, NoticeAWrongStopReason)
{
    Disc disc;
    disc.level().stop = StopReason::Topology;
    EXPECT_THAT(disc.broken(), Contains(HasSubstr("did not reach")));
    const auto check = [&](LevelTarget target) { return brokenInvariants(disc.mesh.view(), {target}, {}, disc.chain); };
    disc.level().stop = StopReason::TargetReached;
    EXPECT_THAT(check({LevelTarget::Kind::Constant, 3}), Contains(HasSubstr("says that it reached 4")));
    EXPECT_THAT(check({LevelTarget::Kind::Triangles, 2}), Contains(HasSubstr("says that it reached 2")));
    EXPECT_THAT(check({LevelTarget::Kind::Proportional, 0.01}), IsEmpty());
    EXPECT_THAT(check({LevelTarget::Kind::Deviation, 0.2}), Contains(HasSubstr("beyond the bound")));
    EXPECT_THAT(check({LevelTarget::Kind::CollapseCost, 0.05}), Contains(HasSubstr("beyond the bound")));
    EXPECT_THAT(check({LevelTarget::Kind::Triangles, 5}), IsEmpty()) << "one collapse may take two";
    disc.level().indices = {{1, 2, 3}};
    disc.level().triangles = 1;
    EXPECT_THAT(check({LevelTarget::Kind::Triangles, 5}), Contains(HasSubstr("went beyond 5, to 1")));
}

TEST(Invariants, NoticeALostLock)
{
    Disc disc;
    disc.mesh.buffers[0].importance = {1.0f, 0, 0, 0, 0, 0, 0};
    EXPECT_THAT(disc.broken(), Contains(HasSubstr("locked position")));
    Disc border;
    border.level().indices = {{0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 5, 0, 5, 1}};
    border.level().triangles = 5;
    border.level().deviation = 1.0;
    SimplifyOptions options;
    options.lockBorders = true;
    EXPECT_THAT(border.broken(), IsEmpty());
    EXPECT_THAT(border.broken(options), Contains(HasSubstr("locked position")));
}

TEST(Invariants, NoticeAJoinOfWhatMovesApart)
{
    // One triangle across the shut mouth.
    const TestMesh mesh = makeClosedLips(2);
    LodChain chain;
    chain.vertices = 15;
    chain.bufferVertices = 18;
    chain.triangles = 16;
    chain.levels.resize(1);
    chain.levels[0].indices = {{0, 1, 12}};
    chain.levels[0].vertices = 3;
    chain.levels[0].triangles = 1;
    chain.levels[0].deviation = 10.0;
    EXPECT_THAT(brokenInvariants(mesh.view(), {{LevelTarget::Kind::Triangles, 1}}, {}, chain),
                Contains(HasSubstr("joins two pieces of the input in motion")));
}

TEST(SurfaceDistance, OfAPointToATriangle)
{
    const Triangle triangle{Point{0, 0, 0}, Point{4, 0, 0}, Point{0, 4, 0}};
    EXPECT_DOUBLE_EQ(distanceToTriangle({1, 1, 3}, triangle), 3.0);
    EXPECT_DOUBLE_EQ(distanceToTriangle({2, -5, 0}, triangle), 5.0);
    EXPECT_DOUBLE_EQ(distanceToTriangle({7, -4, 0}, triangle), 5.0);
    EXPECT_DOUBLE_EQ(distanceToTriangle({4, 4, 0}, triangle), std::sqrt(8.0));
    EXPECT_DOUBLE_EQ(distanceToTriangle({1, 1, 0}, triangle), 0.0);
}

TEST(SurfaceDistance, OfAPointToADegenerateTriangle)
{
    EXPECT_DOUBLE_EQ(distanceToTriangle({1, 2, 0}, {Point{0, 0, 0}, Point{4, 0, 0}, Point{2, 0, 0}}), 2.0);
    EXPECT_DOUBLE_EQ(distanceToTriangle({3, 4, 0}, {Point{0, 0, 0}, Point{0, 0, 0}, Point{0, 0, 0}}), 5.0);
}

TEST(SurfaceDistance, SamplesNeverExceedTheTrueDistance)
{
    const std::vector<Triangle> low = {{Point{0, 0, 0}, Point{1, 0, 0}, Point{0, 1, 0}}};
    const std::vector<Triangle> high = {{Point{0, 0, 2}, Point{1, 0, 2}, Point{0, 1, 2}}};
    EXPECT_DOUBLE_EQ(sampledDistance(low, high, 100, 1), 2.0);
    EXPECT_TRUE(std::isinf(sampledDistance(low, {}, 100, 1)));
}

TEST(Connectivity, OfKnownShapes)
{
    const auto of = [](const TestMesh& mesh) {
        const MeshView view = mesh.view();
        CleaningReport report;
        return Connectivity(cleaned(weldedTriangles(view, weldPositions(view), indexLists(view)), report));
    };
    const Connectivity sphere = of(makeUvSphere(8, 6));
    EXPECT_EQ(sphere.eulerCharacteristic(), 2);
    EXPECT_EQ(sphere.borderEdges, 0u);
    EXPECT_TRUE(sphere.manifold());
    EXPECT_EQ(of(makeTorus(8, 6)).eulerCharacteristic(), 0);
    const Connectivity tube = of(makeCylinder(8, 3));
    EXPECT_EQ(tube.eulerCharacteristic(), 0);
    EXPECT_EQ(tube.borderEdges, 16u);
    EXPECT_EQ(of(makeIslands(5)).pieces, 5u);
    EXPECT_FALSE(of(makeBook(3)).manifold());
    EXPECT_EQ(of(makeBook(3)).nonManifoldEdges, 1u);
    TestMesh bow = makeGrid(2, 2);
    bow.subMeshes[0].indices = {0, 1, 4, 4, 5, 8}; // two triangles that share a corner
    EXPECT_EQ(of(bow).fans.at(4), 2u);
    EXPECT_FALSE(of(bow).manifold());
}

} // namespace

} // namespace lodsmith
