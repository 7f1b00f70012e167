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

TEST(Seam, AMouthInAFaceOpensOnlyWhereItDid)
{
    // A flat face with a slit in the middle row from column 3 to column 9; its ends are welded, its lips move apart.
    constexpr std::uint32_t kCells = 12;
    TestMesh mesh = makeGrid(kCells, kCells, 12.0);
    TestBuffer& buffer = mesh.buffers[0];
    std::vector<std::uint32_t> upper(buffer.vertexCount());
    for (std::uint32_t vertex = 0; vertex < upper.size(); ++vertex)
        upper[vertex] = vertex;
    for (std::uint32_t column = 4; column < 9; ++column) {
        const std::uint32_t lower = 6 * (kCells + 1) + column;
        upper[lower] = buffer.addPosition(column, 6, 0);
        buffer.addNormal(0, 0, 1);
        buffer.addUv(column / 12.0, 0.5);
    }
    for (std::size_t i = 0; i < mesh.subMeshes[0].indices.size(); ++i) {
        const std::size_t row = i / 6 / kCells;
        if (row >= 6)
            mesh.subMeshes[0].indices[i] = upper[mesh.subMeshes[0].indices[i]];
    }
    std::vector<float> pose(buffer.positions.size(), 0.0f);
    for (std::uint32_t vertex = (kCells + 1) * (kCells + 1); vertex < buffer.vertexCount(); ++vertex)
        pose[3 * vertex + 1] = 0.5f;
    buffer.offsets.push_back(pose);

    const Connectivity before = connectivityOf(mesh.view(), Weld::Motion);
    ASSERT_EQ(before.borderEdges, 4 * kCells + 12u);
    for (const Metric metric : {Metric::Quadric, Metric::Curvature}) {
        SimplifyOptions options;
        options.metric = metric;
        simplifyChecked(mesh.view(), {removedShare(0.5), removedShare(0.8), removedShare(1.0)}, options);
    }
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
