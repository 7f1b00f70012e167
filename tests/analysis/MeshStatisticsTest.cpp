#include <lodsmith/analysis/MeshStatistics.h>

#include "support/MeshBuilders.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace lodsmith;
using namespace lodsmith::test;

namespace {

MeshStatistics statisticsOf(const TestMesh& mesh)
{
    return meshStatistics(mesh.view()).value();
}

} // namespace

TEST(MeshStatistics, EmptyMesh)
{
    const MeshStatistics statistics = meshStatistics(MeshView{}).value();
    EXPECT_EQ(statistics.triangles, 0u);
    EXPECT_EQ(statistics.vertices, 0u);
    EXPECT_EQ(statistics.edges, 0u);
    EXPECT_EQ(statistics.components, 0u);
    EXPECT_EQ(statistics.radius, 0.0);
    EXPECT_EQ(statistics.surfaceArea, 0.0);
}

TEST(MeshStatistics, Grid)
{
    const MeshStatistics statistics = statisticsOf(makeGrid(3, 2, 6.0));
    EXPECT_EQ(statistics.bufferVertices, 12u);
    EXPECT_EQ(statistics.vertices, 12u);
    EXPECT_EQ(statistics.triangles, 12u);
    EXPECT_EQ(statistics.edges, 9u + 8u + 6u); // along x, along y, diagonals
    EXPECT_EQ(statistics.borderEdges, 10u);
    EXPECT_EQ(statistics.nonManifoldEdges, 0u);
    EXPECT_EQ(statistics.inconsistentEdges, 0u);
    EXPECT_EQ(statistics.uvSeamEdges, 0u);
    EXPECT_EQ(statistics.normalSeamEdges, 0u);
    EXPECT_EQ(statistics.components, 1u);
    EXPECT_DOUBLE_EQ(statistics.surfaceArea, 36.0);
    EXPECT_DOUBLE_EQ(statistics.radius, std::sqrt(18.0));
}

TEST(MeshStatistics, CubeHasHardEdgesAllAround)
{
    const MeshStatistics statistics = statisticsOf(makeCube(1, 2.0));
    EXPECT_EQ(statistics.bufferVertices, 24u);
    EXPECT_EQ(statistics.vertices, 8u);
    EXPECT_EQ(statistics.edges, 18u);
    EXPECT_EQ(statistics.borderEdges, 0u);
    EXPECT_EQ(statistics.inconsistentEdges, 0u);
    EXPECT_EQ(statistics.normalSeamEdges, 12u);
    EXPECT_EQ(statistics.components, 1u);
    EXPECT_DOUBLE_EQ(statistics.surfaceArea, 24.0);
    EXPECT_DOUBLE_EQ(statistics.radius, std::sqrt(3.0));
}

TEST(MeshStatistics, SeamedSurfacesAreClosedOnceWelded)
{
    const MeshStatistics sphere = statisticsOf(makeUvSphere(16, 8));
    EXPECT_EQ(sphere.vertices, 16u * 7u + 2u);
    EXPECT_EQ(sphere.vertices - sphere.edges + sphere.triangles, 2u); // Euler
    EXPECT_EQ(sphere.borderEdges, 0u);
    EXPECT_EQ(sphere.inconsistentEdges, 0u);
    EXPECT_EQ(sphere.normalSeamEdges, 0u);
    // The seam's 8 edges, and those to the poles, where each sector has its own u: 15 more at either.
    EXPECT_EQ(sphere.uvSeamEdges, 8u + 2u * 15u);
    EXPECT_EQ(sphere.unreferencedVertices, 2u);

    const MeshStatistics torus = statisticsOf(makeTorus(12, 8));
    EXPECT_EQ(torus.vertices, 96u);
    EXPECT_EQ(torus.edges, 3u * 96u);
    EXPECT_EQ(torus.triangles, 2u * 96u);
    EXPECT_EQ(torus.borderEdges, 0u);
    EXPECT_EQ(torus.uvSeamEdges, 12u + 8u);
}

TEST(MeshStatistics, PlusAndMinusZeroAreOnePlace)
{
    TestMesh mesh = makeGrid(1, 1);
    mesh.buffers[0].normals.clear();
    mesh.buffers[0].uvSets.clear();
    mesh.buffers[0].positions.insert(mesh.buffers[0].positions.end(), {-0.0f, -0.0f, -0.0f});
    mesh.subMeshes[0].indices[0] = 4;
    EXPECT_EQ(statisticsOf(mesh).vertices, 4u);
}

TEST(MeshStatistics, TwoSidedWallIsRepeatedAndNonManifold)
{
    const MeshStatistics statistics = statisticsOf(makeTwoSidedWall(2));
    EXPECT_EQ(statistics.vertices, 9u);
    EXPECT_EQ(statistics.triangles, 16u);
    EXPECT_EQ(statistics.repeatedTriangles, 8u);
    EXPECT_EQ(statistics.borderEdges, 0u);
    EXPECT_EQ(statistics.nonManifoldEdges, 8u); // all but the 8 of the outline
    EXPECT_EQ(statistics.inconsistentEdges, 0u);
    EXPECT_EQ(statistics.components, 1u);
}

TEST(MeshStatistics, BookOfThreePages)
{
    const MeshStatistics statistics = statisticsOf(makeBook(3));
    EXPECT_EQ(statistics.edges, 7u);
    EXPECT_EQ(statistics.borderEdges, 6u);
    EXPECT_EQ(statistics.nonManifoldEdges, 1u);
    EXPECT_EQ(statistics.components, 1u);
}

TEST(MeshStatistics, MixedWinding)
{
    TestMesh mesh = makeGrid(1, 1);
    std::swap(mesh.subMeshes[0].indices[1], mesh.subMeshes[0].indices[2]);
    EXPECT_EQ(statisticsOf(mesh).inconsistentEdges, 1u);
}

TEST(MeshStatistics, MaterialsMeetInSharedAndInOwnBuffers)
{
    for (const bool shared : {true, false}) {
        const MeshStatistics statistics = statisticsOf(makeTwoMaterials(4, shared));
        EXPECT_EQ(statistics.materialEdges, 4u);
        EXPECT_EQ(statistics.vertices, 45u);
        EXPECT_EQ(statistics.unreferencedVertices, shared ? 0u : 40u);
        EXPECT_EQ(statistics.uvSeamEdges, 0u);
        EXPECT_EQ(statistics.components, 1u);
    }
}

TEST(MeshStatistics, DegenerateAndRepeatedTriangles)
{
    TestMesh mesh = makeGrid(2, 1); // vertices 0 1 2 below, 3 4 5 above
    TestSubMesh& subMesh = mesh.subMeshes[0];
    subMesh.addTriangle(0, 0, 1); // two corners at one position
    subMesh.addTriangle(0, 0, 1); // no repetition: it is no triangle
    subMesh.addTriangle(0, 1, 2); // zero area
    const std::vector<std::uint32_t> first(subMesh.indices.begin(), subMesh.indices.begin() + 3);
    subMesh.addTriangle(first[1], first[2], first[0]);
    subMesh.addTriangle(first[1], first[0], first[2]);
    const MeshStatistics statistics = statisticsOf(mesh);
    EXPECT_EQ(statistics.degenerateTriangles, 3u);
    EXPECT_EQ(statistics.repeatedTriangles, 2u);
    EXPECT_EQ(statistics.components, 1u);
}

TEST(MeshStatistics, EverythingInOnePoint)
{
    const MeshStatistics statistics = statisticsOf(scaled(makeCube(), 0.0));
    EXPECT_EQ(statistics.vertices, 1u);
    EXPECT_EQ(statistics.degenerateTriangles, 12u);
    EXPECT_EQ(statistics.edges, 0u);
    EXPECT_EQ(statistics.components, 0u);
    EXPECT_EQ(statistics.radius, 0.0);
}

TEST(MeshStatistics, ComponentsTouchAtEdgesNotAtVertices)
{
    EXPECT_EQ(statisticsOf(makeIslands(5)).components, 5u);
    TestMesh bowTie = makeFan(6);
    bowTie.subMeshes[0].indices = {0, 1, 2, 0, 4, 5};
    EXPECT_EQ(statisticsOf(bowTie).components, 2u);
}

TEST(MeshStatistics, IndicesOfTwoBytes)
{
    const TestMesh mesh = makeGrid(2, 2);
    const std::vector<std::uint16_t> indices(mesh.subMeshes[0].indices.begin(), mesh.subMeshes[0].indices.end());
    MeshView view = mesh.view();
    view.subMeshes[0].indices = indices.data();
    view.subMeshes[0].indexBytes = 2;
    EXPECT_EQ(meshStatistics(view).value().edges, statisticsOf(mesh).edges);
}

TEST(MeshStatistics, HugeAndTinyMeshes)
{
    for (const double scale : {1e37, 1e18, 1e-30, 1e-36}) {
        const MeshStatistics statistics = statisticsOf(scaled(makeCube(1, 2.0), scale));
        EXPECT_EQ(statistics.degenerateTriangles, 0u) << scale;
        EXPECT_NEAR(statistics.surfaceArea / scale / scale, 24.0, 1e-5) << scale;
        EXPECT_NEAR(statistics.radius / scale, std::sqrt(3.0), 1e-6) << scale;
    }
}

TEST(MeshStatistics, ErrorsNameThePlace)
{
    TestMesh outOfRange = joined(makeGrid(1, 1), makeGrid(1, 1));
    outOfRange.subMeshes[1].indices[4] = 99;
    const Error index = meshStatistics(outOfRange.view()).error();
    EXPECT_EQ(index.code, ErrorCode::IndexOutOfRange);
    EXPECT_EQ(index.subMesh, 1);
    EXPECT_EQ(index.item, 4);

    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        TestMesh notFinite = makeGrid(1, 1);
        notFinite.buffers[0].positions[3 * 3 + 1] = bad;
        const Error position = meshStatistics(notFinite.view()).error();
        EXPECT_EQ(position.code, ErrorCode::InvalidGeometry);
        EXPECT_EQ(position.subMesh, 0);
        EXPECT_EQ(position.item, 3);
    }
}

TEST(MeshStatistics, UnreferencedVerticesMayHoldAnything)
{
    TestMesh mesh = makeGrid(1, 1);
    mesh.buffers[0].addPosition(std::numeric_limits<double>::quiet_NaN(), 1e30, 0.0);
    const MeshStatistics statistics = statisticsOf(mesh);
    EXPECT_EQ(statistics.unreferencedVertices, 1u);
    EXPECT_DOUBLE_EQ(statistics.radius, std::sqrt(0.5));
}
