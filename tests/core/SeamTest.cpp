#include "support/CheckedSimplify.h"
#include "support/MeshBuilders.h"
#include "support/WeldedMesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace lodsmith {

namespace {

using namespace test;

const std::vector<LevelTarget> kHalvings = {removedShare(0.5), removedShare(0.75), removedShare(0.875),
                                            removedShare(0.9375)};

Connectivity connectivityOf(const MeshView& view, Weld weld = Weld::Rest)
{
    return Connectivity(weldedTriangles(view, weldPositions(view, weld), indexLists(view)));
}

/// A named mesh that has to reach every one of the usual targets, with its levels as sound as the invariants say.
struct Shape {
    const char* name;
    TestMesh mesh;
};

void PrintTo(const Shape& shape, std::ostream* out)
{
    *out << shape.name;
}

TestMesh mixedWinding(TestMesh mesh)
{
    for (std::size_t i = 0; i + 2 < mesh.subMeshes[0].indices.size(); i += 9)
        std::swap(mesh.subMeshes[0].indices[i], mesh.subMeshes[0].indices[i + 1]);
    return mesh;
}

class ReachesTargets : public testing::TestWithParam<Shape> {};

TEST_P(ReachesTargets, WithEitherMetric)
{
    const TestMesh& mesh = GetParam().mesh;
    for (const Metric metric : {Metric::Quadric, Metric::Curvature}) {
        SimplifyOptions options;
        options.metric = metric;
        const LodChain chain = simplifyChecked(mesh.view(), kHalvings, options);
        for (std::size_t i = 0; i < kHalvings.size(); ++i) {
            EXPECT_EQ(chain.levels[i].stop, StopReason::TargetReached) << "level " << i + 1;
            EXPECT_LE(chain.levels[i].vertices, std::ceil(chain.vertices * (1.0 - kHalvings[i].amount)))
                << "level " << i + 1;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, ReachesTargets,
    testing::Values(Shape{"SmoothSphere", makeUvSphere(24, 16)}, Shape{"Icosphere", makeIcosphere(3)},
                    Shape{"FlatShadedSphere", flatShaded(makeIcosphere(3))},
                    Shape{"FacetedTerrain", flatShaded(makeTerrain(16))},
                    Shape{"MixedWindingSphere", mixedWinding(makeIcosphere(3))},
                    Shape{"MixedWindingTerrain", mixedWinding(makeTerrain(16))},
                    Shape{"TwoSidedWall", makeTwoSidedWall(12)},
                    Shape{"FacetedTwoSidedWall", flatShaded(makeTwoSidedWall(12))}, Shape{"Cube", makeCube(8)},
                    Shape{"Torus", makeTorus(24, 12)}, Shape{"Tube", makeCylinder(24, 12)},
                    Shape{"SkinnedTube", makeSkinnedTube(24, 12)}, Shape{"ClosedLips", makeClosedLips(10)},
                    Shape{"SkinnedLips", makeSkinnedLips(10)}, Shape{"TwoMaterials", makeTwoMaterials(10, true)},
                    Shape{"TwoMaterialsInOwnBuffers", makeTwoMaterials(10, false)}),
    [](const auto& info) { return info.param.name; });

TEST(Seam, AClosedSurfaceWithSeamsStaysClosed)
{
    for (const TestMesh& mesh : {makeUvSphere(24, 16), makeTorus(24, 12), flatShaded(makeIcosphere(2)), makeCube(5)}) {
        ASSERT_EQ(connectivityOf(mesh.view()).borderEdges, 0u);
        const LodChain chain = simplifyChecked(mesh.view(), kHalvings);
        for (const LodChainLevel& level : chain.levels) {
            if (!level.skipped) {
                EXPECT_EQ(connectivityOf(mesh.view(level)).borderEdges, 0u);
            }
        }
    }
}

TEST(Seam, SubMeshesStayTogether)
{
    for (const bool shared : {true, false}) {
        const TestMesh mesh = makeTwoMaterials(8, shared);
        const LodChain chain = simplifyChecked(mesh.view(), kHalvings);
        for (const LodChainLevel& level : chain.levels) {
            const Connectivity connectivity = connectivityOf(mesh.view(level));
            EXPECT_EQ(connectivity.pieces, 1u);
            EXPECT_EQ(connectivity.eulerCharacteristic(), 1) << "a disc has no hole";
        }
    }
}

TEST(Seam, EachSideOfATornTextureKeepsItsOwnSide)
{
    // Two charts on a flat square, left with u in 0..1, right with u in 10..11: a triangle with corners of both would smear.
    const TestMesh half = makePatch(6, 12, [](double u, double v) { return Point{0.5 * u, v, 0.0}; });
    TestMesh mesh = half;
    TestBuffer& buffer = mesh.buffers[0];
    const std::uint32_t first = buffer.vertexCount();
    for (std::uint32_t vertex = 0; vertex < first; ++vertex) {
        buffer.addPosition(0.5 + buffer.positions[3 * vertex], buffer.positions[3 * vertex + 1], 0.0);
        buffer.addNormal(0, 0, 1);
        buffer.addUv(10.0 + buffer.uvSets[0][2 * vertex], buffer.uvSets[0][2 * vertex + 1]);
    }
    for (const std::uint32_t index : half.subMeshes[0].indices)
        mesh.subMeshes[0].indices.push_back(first + index);

    const LodChain chain = simplifyChecked(mesh.view(), kHalvings);
    for (const LodChainLevel& level : chain.levels) {
        for (std::size_t i = 0; i < level.indices[0].size(); i += 3) {
            const bool right = level.indices[0][i] >= first;
            EXPECT_EQ(level.indices[0][i + 1] >= first, right);
            EXPECT_EQ(level.indices[0][i + 2] >= first, right);
        }
    }
}

TEST(Seam, NoWedgeAtTheDestinationIsToldAsTheReason)
{
    // Every triangle is a submesh with a buffer of its own: no neighbour has all the wedges that a vertex would need.
    const TestMesh faceted = flatShaded(makeIcosphere(1));
    TestMesh mesh;
    for (std::uint32_t first = 0; first < faceted.buffers[0].vertexCount(); first += 3) {
        TestBuffer buffer;
        const auto positions = faceted.buffers[0].positions.begin() + 3 * first;
        buffer.positions.assign(positions, positions + 9);
        mesh.buffers.push_back(buffer);
        mesh.subMeshes.push_back({first / 3, {0, 1, 2}});
    }
    const LodChain chain = simplifyChecked(mesh.view(), {removedShare(0.5)});
    EXPECT_TRUE(chain.levels[0].skipped);
    EXPECT_EQ(chain.levels[0].stop, StopReason::Seam);
}

TEST(Seam, MotionKeepsClosedLipsApart)
{
    for (const TestMesh& mesh : {makeClosedLips(8), makeSkinnedLips(8)}) {
        const Connectivity before = connectivityOf(mesh.view(), Weld::Motion);
        ASSERT_EQ(before.pieces, 2u) << "two lips";
        const LodChain chain = simplifyChecked(mesh.view(), kHalvings);
        for (const LodChainLevel& level : chain.levels) {
            EXPECT_EQ(connectivityOf(mesh.view(level), Weld::Motion).pieces, 2u);
            EXPECT_EQ(connectivityOf(mesh.view(level)).pieces, 1u) << "the mouth is shut at rest";
        }
    }
}

/// A flat face with a slit in its middle row: at these columns the lips move apart, at all others they are welded.
TestMesh makeFaceWithMouth(std::uint32_t cells, const std::vector<std::uint32_t>& openColumns)
{
    TestMesh mesh = makeGrid(cells, cells, cells);
    TestBuffer& buffer = mesh.buffers[0];
    const std::uint32_t middle = cells / 2, welded = buffer.vertexCount();
    std::vector<std::uint32_t> upper(welded);
    for (std::uint32_t vertex = 0; vertex < welded; ++vertex)
        upper[vertex] = vertex;
    for (const std::uint32_t column : openColumns) {
        upper[middle * (cells + 1) + column] = buffer.addPosition(column, middle, 0);
        buffer.addNormal(0, 0, 1);
        buffer.addUv(double(column) / cells, 0.5);
    }
    for (std::size_t i = 0; i < mesh.subMeshes[0].indices.size(); ++i) {
        const std::size_t row = i / 6 / cells;
        if (row >= middle)
            mesh.subMeshes[0].indices[i] = upper[mesh.subMeshes[0].indices[i]];
    }
    std::vector<float> pose(buffer.positions.size(), 0.0f);
    for (std::uint32_t vertex = welded; vertex < buffer.vertexCount(); ++vertex)
        pose[3 * vertex + 1] = 0.5f;
    buffer.offsets.push_back(pose);
    return mesh;
}

void expectSoundMotion(const TestMesh& mesh, const std::vector<LevelTarget>& targets)
{
    for (const Metric metric : {Metric::Quadric, Metric::Curvature}) {
        SimplifyOptions options;
        options.metric = metric;
        simplifyChecked(mesh.view(), targets, options);
    }
}

TEST(Seam, AMouthInAFaceOpensOnlyWhereItDid)
{
    constexpr std::uint32_t kCells = 12;
    const TestMesh mesh = makeFaceWithMouth(kCells, {4, 5, 6, 7, 8});
    ASSERT_EQ(connectivityOf(mesh.view(), Weld::Motion).borderEdges, 4 * kCells + 12u);
    expectSoundMotion(mesh, {removedShare(0.5), removedShare(0.8), removedShare(1.0)});
}

TEST(Seam, ThePointWhereTwoMouthsMeetStays)
{
    // Column 6 is sewn up. Left along either mouth, it would take a half of its triangles across to the other lip.
    constexpr std::uint32_t kCells = 12;
    TestMesh mesh = makeFaceWithMouth(kCells, {4, 5, 7, 8});
    ASSERT_EQ(connectivityOf(mesh.view(), Weld::Motion).borderEdges, 4 * kCells + 12u);
    expectSoundMotion(mesh, {removedShare(0.5), removedShare(0.8), removedShare(1.0)});
    mesh.buffers[0].importance.assign(mesh.buffers[0].vertexCount(), 1.0f);
    mesh.buffers[0].importance[6 * (kCells + 1) + 6] = 0.0f;
    for (const Metric metric : {Metric::Quadric, Metric::Curvature}) {
        SimplifyOptions options;
        options.metric = metric;
        EXPECT_TRUE(simplifyChecked(mesh.view(), {removedVertices(1)}, options).levels[0].skipped);
    }
}

TEST(Seam, SheetsThatLieOnEachOtherOpenOnlyWhereTheyDid)
{
    // A bag, flat at rest: two equal sheets, the front one bulging, welded at their upper rims. Edges inside have four triangles.
    TestMesh mesh = makeTwoSidedWall(4);
    TestBuffer& buffer = mesh.buffers[0];
    std::vector<float> pose(buffer.positions.size(), 0.0f);
    for (std::uint32_t vertex = 0; vertex < 20; ++vertex)
        pose[3 * vertex + 2] = 0.1f;
    buffer.offsets.push_back(pose);
    const Connectivity before = connectivityOf(mesh.view(), Weld::Motion);
    ASSERT_EQ(before.pieces, 1u);
    ASSERT_EQ(before.borderEdges, 24u);
    expectSoundMotion(mesh, kHalvings);
    expectSoundMotion(mesh, {removedShare(1.0)});
}

TEST(Seam, WhatFillsAGapInMotionIsNotReplacedByAThirdFace)
{
    // In motion: a bent sheet, another one that hangs on the bend by its two outer corners, and a triangle of its own
    // between the two. Its inner corner is the vertex that costs nothing.
    TestMesh mesh;
    mesh.buffers.resize(1);
    mesh.subMeshes.resize(1);
    TestBuffer& buffer = mesh.buffers[0];
    for (const Point& p : {Point{0.1, 0.3, 0.0}, Point{0, 0, 0}, Point{0, 1, 0}, Point{1, 0.5, 0}, Point{-1, 0.5, 0.3},
                           Point{-1, 0.5, -0.3}, Point{0.1, 0.3, 0.0}, Point{0, 0, 0}, Point{0, 1, 0}}) {
        BoneInfluences influences;
        influences.bone[0] = buffer.vertexCount() < 6 ? 0 : 1;
        influences.weight[0] = 1.0f;
        buffer.bones.push_back(influences);
        buffer.addPosition(p[0], p[1], p[2]);
    }
    mesh.subMeshes[0].indices = {0, 2, 3, 0, 3, 1, 6, 7, 8, 2, 1, 4, 1, 2, 5};
    ASSERT_EQ(connectivityOf(mesh.view(), Weld::Motion).nonManifoldEdges, 0u);
    for (const double count : {1.0, 2.0, 3.0})
        expectSoundMotion(mesh, {removedVertices(count)});
}

TEST(Seam, ASubMeshMayBeReducedToNothing)
{
    // One small quad of another material in the middle of a flat floor.
    TestMesh mesh = makeGrid(8, 8, 8.0);
    mesh.subMeshes.resize(2);
    std::vector<std::uint32_t>& floor = mesh.subMeshes[0].indices;
    const auto first = floor.begin() + 6 * (3 * 8 + 3);
    mesh.subMeshes[1].indices.assign(first, first + 6);
    floor.erase(first, first + 6);
    SimplifyOptions options;
    options.metric = Metric::Curvature; // knows nothing of materials
    const LodChain chain = simplifyChecked(mesh.view(), {removedShare(1.0)}, options);
    EXPECT_EQ(chain.levels[0].indices[1].size(), 0u);
    EXPECT_FALSE(chain.levels[0].indices[0].empty());
    EXPECT_EQ(connectivityOf(mesh.view(chain.levels[0])).eulerCharacteristic(), 1) << "no hole where it was";
}

TEST(Seam, TheLargerSubMeshPaysForTheWholeMesh)
{
    // The budget is for the mesh: a dense sphere beside a coarse one of the same shape gives nearly all.
    const TestMesh mesh = joined(makeIcosphere(3), translated(makeIcosphere(1), 5, 0, 0));
    const LodChain chain = simplifyChecked(mesh.view(), {removedShare(0.5)});
    EXPECT_LT(chain.levels[0].indices[0].size(), mesh.subMeshes[0].indices.size() * 6 / 10);
    EXPECT_GE(chain.levels[0].indices[1].size(), mesh.subMeshes[1].indices.size() * 9 / 10);
}

} // namespace

} // namespace lodsmith
