#include "support/CheckedSimplify.h"
#include "support/MeshBuilders.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace lodsmith {

namespace {

using namespace test;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinite = std::numeric_limits<float>::infinity();

/// Two grids; the second is submesh 1 with a buffer of its own, which the tests spoil.
TestMesh makeTwoGrids()
{
    return joined(makeGrid(4, 4), translated(makeGrid(4, 4), 3, 0, 0));
}

void expectError(const TestMesh& mesh, ErrorCode code, int subMesh, std::int64_t item)
{
    const Result<LodChain> result = simplify(mesh.view(), {removedShare(0.5)});
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.error().code, code);
    EXPECT_EQ(result.error().subMesh, subMesh);
    EXPECT_EQ(result.error().item, item);
    EXPECT_FALSE(result.error().message.empty());
}

TEST(BadInput, PositionsThatAreNotFiniteAreNamed)
{
    for (const float bad : {kNan, kInfinite, -kInfinite}) {
        for (std::uint32_t axis = 0; axis < 3; ++axis) {
            TestMesh mesh = makeTwoGrids();
            mesh.buffers[1].positions[3 * 7 + axis] = bad;
            expectError(mesh, ErrorCode::InvalidGeometry, 1, 7);
        }
    }
}

TEST(BadInput, PositionsTooFarOutAreNamed)
{
    for (const float bad : {1e25f, -1e25f, 1.1e18f, std::numeric_limits<float>::max()}) {
        TestMesh mesh = makeTwoGrids();
        mesh.buffers[1].positions[3 * 7] = bad;
        expectError(mesh, ErrorCode::InvalidGeometry, 1, 7);
    }
}

TEST(BadInput, AttributesThatAreNotFiniteAreNamed)
{
    for (const float bad : {kNan, kInfinite}) {
        TestMesh normal = makeTwoGrids();
        normal.buffers[1].normals[3 * 7 + 1] = bad;
        expectError(normal, ErrorCode::InvalidGeometry, 1, 7);
        TestMesh uv = makeTwoGrids();
        uv.buffers[1].uvSets[0][2 * 7 + 1] = bad;
        expectError(uv, ErrorCode::InvalidGeometry, 1, 7);
        TestMesh colour = makeTwoGrids();
        colour.buffers[1].colours.assign(25 * 4, 0.5f);
        colour.buffers[1].colours[4 * 7 + 3] = bad;
        expectError(colour, ErrorCode::InvalidGeometry, 1, 7);
        TestMesh offset = makeTwoGrids();
        offset.buffers[1].offsets.emplace_back(25 * 3, 0.0f);
        offset.buffers[1].offsets[0][3 * 7 + 2] = bad;
        expectError(offset, ErrorCode::InvalidGeometry, 1, 7);
        TestMesh bones = makeTwoGrids();
        bones.buffers[1].bones.resize(25);
        bones.buffers[1].bones[7].weight[2] = bad;
        expectError(bones, ErrorCode::InvalidGeometry, 1, 7);
    }
}

TEST(BadInput, ImportanceOutsideItsRangeIsNamed)
{
    for (const float bad : {kNan, kInfinite, -0.1f, 1.1f}) {
        TestMesh mesh = makeTwoGrids();
        mesh.buffers[1].importance.assign(25, 0.5f);
        mesh.buffers[1].importance[7] = bad;
        expectError(mesh, ErrorCode::InvalidGeometry, 1, 7);
    }
}

TEST(BadInput, AttributesFarOutOfTheOrdinaryAreHarmless)
{
    constexpr float kLargest = std::numeric_limits<float>::max();
    for (const float far : {1e25f, kLargest, -kLargest, 1e-40f}) {
        TestMesh mesh = makeTerrain(8);
        TestBuffer& buffer = mesh.buffers[0];
        buffer.colours.assign(81 * 4, 0.5f);
        buffer.offsets.emplace_back(81 * 3, 0.0f);
        for (std::size_t vertex = 3; vertex < 81; vertex += 7) {
            buffer.normals[3 * vertex] = far;
            buffer.uvSets[0][2 * vertex] = far;
            buffer.colours[4 * vertex] = far;
            buffer.offsets[0][3 * vertex] = far;
        }
        simplifyChecked(mesh.view(), {removedShare(0.5)});
    }
}

TEST(BadInput, AllNormalsZeroAreHarmless)
{
    TestMesh mesh = makeTerrain(8);
    mesh.buffers[0].normals.assign(81 * 3, 0.0f);
    EXPECT_EQ(simplifyChecked(mesh.view(), {removedShare(0.5)}).levels[0].stop, StopReason::TargetReached);
}

TEST(BadInput, WhatNoTriangleUsesDoesNotMatter)
{
    TestMesh mesh = makeGrid(4, 4);
    mesh.buffers[0].addPosition(kNan, kInfinite, 1e25);
    mesh.buffers[0].addNormal(kNan, 0, 0);
    mesh.buffers[0].addUv(kInfinite, 0);
    const LodChain chain = simplifyChecked(mesh.view(), {removedShare(0.5)});
    EXPECT_EQ(chain.cleaned.unreferencedVertices, 1u);
    EXPECT_NEAR(chain.radius, std::sqrt(0.5), 1e-6);
}

TEST(BadInput, IndicesOutOfRangeAreNamed)
{
    for (const std::uint32_t bad : {25u, 26u, 0x7fffffffu, 0xffffffffu}) {
        TestMesh mesh = makeTwoGrids();
        mesh.subMeshes[1].indices[10] = bad;
        expectError(mesh, ErrorCode::IndexOutOfRange, 1, 10);
    }
}

TEST(BadInput, AnIndexIntoAnEmptyBufferIsNamed)
{
    TestMesh mesh = makeTwoGrids();
    mesh.buffers[1] = TestBuffer();
    expectError(mesh, ErrorCode::IndexOutOfRange, 1, 0);
}

TEST(BadInput, EmptyMeshes)
{
    const std::vector<LevelTarget> targets = {removedShare(0.5), removedVertices(7), keptTriangles(0),
                                              greatestDeviation(1), dearestCollapse(1)};
    TestMesh noTriangles = makeGrid(4, 4);
    noTriangles.subMeshes[0].indices.clear();
    TestMesh noVertices;
    noVertices.buffers.resize(1);
    noVertices.subMeshes.resize(2);
    for (const TestMesh& mesh : {TestMesh(), noVertices, noTriangles}) {
        const LodChain chain = simplifyChecked(mesh.view(), targets);
        EXPECT_EQ(chain.vertices, 0u);
        EXPECT_EQ(chain.radius, 0.0);
        for (const LodChainLevel& level : chain.levels) {
            EXPECT_TRUE(level.skipped);
            EXPECT_EQ(level.deviation, 0.0);
        }
    }
}

TEST(BadInput, EmptySubMeshesAmongOthers)
{
    TestMesh mesh = makeTerrain(8);
    mesh.subMeshes.insert(mesh.subMeshes.begin(), TestSubMesh());
    mesh.subMeshes.push_back(TestSubMesh());
    const LodChain chain = simplifyChecked(mesh.view(), {removedShare(0.5)});
    ASSERT_EQ(chain.levels[0].indices.size(), 3u);
    EXPECT_TRUE(chain.levels[0].indices[0].empty());
    EXPECT_FALSE(chain.levels[0].indices[1].empty());
    EXPECT_TRUE(chain.levels[0].indices[2].empty());
}

TEST(BadInput, EverythingInOnePoint)
{
    const TestMesh mesh = scaled(makeTerrain(8), 0.0);
    const LodChain chain = simplifyChecked(mesh.view(), {removedShare(0.5), keptTriangles(3), greatestDeviation(1.0)});
    EXPECT_EQ(chain.vertices, 1u);
    EXPECT_EQ(chain.triangles, 128u);
    EXPECT_EQ(chain.cleaned.degenerateTriangles, 128u);
    EXPECT_EQ(chain.radius, 0.0);
}

TEST(BadInput, EverythingOnOneLine)
{
    const TestMesh mesh = makePatch(8, 8, [](double u, double v) { return Point{u + 9.0 * v, 0.0, 0.0}; });
    simplifyChecked(mesh.view(), {removedShare(0.5), removedShare(1.0)});
}

TEST(BadInput, ZeroAreaTrianglesAreHarmless)
{
    TestMesh mesh = makeTerrain(12);
    for (std::uint32_t i = 0; i + 2 < 13; i += 3)
        mesh.subMeshes[0].addTriangle(i, i + 1, i + 2); // not quite a line on the hills, one on the flat
    TestMesh flat = makeGrid(12, 12);
    for (std::uint32_t i = 0; i + 2 < 13; i += 3)
        flat.subMeshes[0].addTriangle(40 + i, 41 + i, 42 + i);
    for (const TestMesh* each : {&mesh, &flat})
        EXPECT_EQ(simplifyChecked(each->view(), {removedShare(0.5), removedShare(0.8)}).levels[0].stop,
                  StopReason::TargetReached);
}

TEST(BadInput, RepeatedAndFlippedTrianglesAreHarmless)
{
    TestMesh mesh = makeTerrain(12);
    const std::vector<std::uint32_t> once = mesh.subMeshes[0].indices;
    mesh.subMeshes[0].indices.insert(mesh.subMeshes[0].indices.end(), once.begin(), once.end());
    for (std::size_t i = 0; i < 90; i += 3)
        mesh.subMeshes[0].addTriangle(once[i], once[i + 2], once[i + 1]);
    const LodChain chain = simplifyChecked(mesh.view(), {removedShare(0.5), removedShare(0.9)});
    EXPECT_EQ(chain.cleaned.repeatedTriangles, 288u);
    EXPECT_EQ(chain.levels[0].stop, StopReason::TargetReached);
}

TEST(BadInput, HugeAndTinyMeshesAreLikeOthers)
{
    const TestMesh mesh = makeTerrain(16);
    for (const double factor : {1e17, 1e-17, 1e-30}) {
        const LodChain chain = simplifyChecked(scaled(mesh, factor).view(), {removedShare(0.5), removedShare(0.9)});
        EXPECT_EQ(chain.levels[0].stop, StopReason::TargetReached) << factor;
        EXPECT_EQ(chain.levels[1].stop, StopReason::TargetReached) << factor;
        EXPECT_LT(chain.levels[1].deviation, factor) << "the bound is a deviation, not a guess";
    }
}

TEST(BadInput, DenormalMeshes)
{
    simplifyChecked(scaled(makeTerrain(16), 1e-41).view(), {removedShare(0.5), removedShare(0.9)});
}

TEST(BadInput, AMeshFarFromTheOrigin)
{
    const TestMesh mesh = translated(makeTerrain(16), 1e5, -1e5, 1e5); // steps of a float there: 1/128
    simplifyChecked(mesh.view(), {removedShare(0.5), removedShare(0.9)});
}

TEST(BadInput, OnePositionFarFromTheRest)
{
    TestMesh mesh = makeTerrain(12);
    mesh.buffers[0].positions[3 * 84] = 1e17f;
    simplifyChecked(mesh.view(), {removedShare(0.5), removedShare(0.9)});
}

TEST(BadInput, TinyDetailOnALargeMesh)
{
    // Areas of the detail are zero to a float.
    for (const TestMesh& mesh : {makeTerrain(8), makeSkinnedLips(4), makeUvSphere(8, 6), flatShaded(makeTorus(8, 6))}) {
        for (const double factor : {1e-22, 1e-30})
            simplifyChecked(joined(mesh, scaled(mesh, factor)).view(), {removedShare(0.5), removedShare(0.8)});
    }
}

TEST(BadInput, ANeedleTooThinForItsAreaDoesNotTurnOver)
{
    // A tiny square, and a needle from its lower side to far away: only the square's lower left corner may go.
    TestMesh mesh;
    mesh.buffers.resize(1);
    mesh.subMeshes.resize(1);
    constexpr float kSide = 2.5e-31f;
    mesh.buffers[0].positions = {0, 0, 0, kSide, 0, 0, kSide, kSide, 0, 0, kSide, 0, 1, -kSide, 0};
    mesh.buffers[0].importance = {0, 1, 1, 1, 1};
    mesh.subMeshes[0].indices = {0, 1, 2, 0, 2, 3, 1, 4, 0};
    simplifyChecked(mesh.view(), {removedVertices(1)});
}

TEST(BadInput, OneVertexOfATinyMeshIsFarAway)
{
    // Lengths of 1e-30 and of 1 in one triangle: their ratios squared are no floats any more.
    for (std::size_t vertex = 0; vertex < 25; ++vertex) {
        TestMesh mesh = scaled(makeTerrain(4), 1e-30);
        for (std::size_t i = 3 * vertex; i < 3 * vertex + 3; ++i)
            mesh.buffers[0].positions[i] = 0.5f;
        simplifyChecked(mesh.view(), {removedShare(0.5), removedShare(0.8)});
    }
}

TEST(BadInput, ManyTrianglesAtOneVertex)
{
    for (const std::uint32_t triangles : {129u, 3000u}) {
        const TestMesh mesh = makeFan(triangles);
        const LodChain chain = simplifyChecked(mesh.view(), {removedShare(0.5), removedShare(0.9)});
        EXPECT_EQ(chain.levels[0].stop, StopReason::TargetReached) << triangles;
        EXPECT_EQ(chain.levels[1].stop, StopReason::TargetReached) << triangles;
    }
}

TEST(BadInput, ManyTrianglesAtOneEdge)
{
    simplifyChecked(makeBook(40).view(), {removedShare(0.5), removedShare(1.0)});
}

TEST(BadInput, TwoSidedLeavesThatMeetInOnePointAreBothKept)
{
    TestMesh mesh;
    mesh.buffers.resize(1);
    mesh.subMeshes.resize(1);
    mesh.buffers[0].positions = {0, 0, 0, -1, 1, 0, 0, 1, 0, 1, 1, 0, 1, 0, 0};
    for (const std::uint32_t first : {1u, 3u}) {
        mesh.subMeshes[0].addTriangle(0, first, first + 1);
        mesh.subMeshes[0].addTriangle(0, first + 1, first);
    }
    for (const Metric metric : {Metric::Quadric, Metric::Curvature}) {
        SimplifyOptions options;
        options.metric = metric;
        EXPECT_TRUE(simplifyChecked(mesh.view(), {removedShare(1.0)}, options).levels[0].skipped);
    }
}

TEST(BadInput, SoupsAndIslandsGoAsFarAsTheyCan)
{
    for (const TestMesh& mesh : {makeSoup(60), makeIslands(12), makeLeafCards(30)})
        simplifyChecked(mesh.view(), {removedShare(0.5), removedShare(1.0), keptTriangles(0)});
}

TEST(BadInput, ManySubMeshesAndBuffers)
{
    TestMesh mesh;
    for (int i = 0; i < 40; ++i)
        mesh = joined(mesh, translated(makeGrid(2, 2), i, 0, 0));
    simplifyChecked(mesh.view(), {removedShare(0.4), removedShare(0.8)});
}

} // namespace

} // namespace lodsmith
