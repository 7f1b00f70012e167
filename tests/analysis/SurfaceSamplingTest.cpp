#include "SurfaceSampling.h"

#include "support/MeshBuilders.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace lodsmith;
using namespace lodsmith::analysis;
using namespace lodsmith::test;

namespace {

struct SurfaceOf {
    explicit SurfaceOf(const TestMesh& source) : mesh(source), view(mesh.view())
    {
        triangles = weldTriangles(view, table).value();
        const LocalFrame frame(table.positions());
        for (const Position& position : table.positions())
            points.push_back(frame.toLocal(position));
    }

    Surface surface() const { return {view, triangles, points}; }

    TestMesh mesh;
    MeshView view;
    PositionTable table;
    std::vector<WeldedTriangle> triangles;
    std::vector<Vec3> points;
};

} // namespace

TEST(SurfaceSampling, EachTriangleGetsItsShareOfTheArea)
{
    // Areas 1/2 and 2: the larger one gets four of five samples, give or take the one across the limit.
    TestMesh mesh = makeTetrahedron();
    mesh.buffers[0].positions = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, -2, 0, 2, -2, 0, 0, 0, 0};
    mesh.subMeshes[0].indices = {0, 1, 2, 3, 4, 5};
    const SurfaceOf source(mesh);
    int larger = 0;
    for (const SurfaceSample& sample : sampleArea(source.surface(), 1000, 3))
        larger += sample.triangle == 1;
    EXPECT_NEAR(larger, 800, 1);
}

TEST(SurfaceSampling, EvenOverTheTriangle)
{
    const SurfaceOf source(makeGrid(1, 1));
    Barycentric sums{}, squares{};
    const int count = 100000;
    for (const SurfaceSample& sample : sampleArea(source.surface(), count, 5))
        for (int i = 0; i < 3; ++i) {
            EXPECT_GE(sample.weights[i], 0.0);
            sums[i] += sample.weights[i];
            squares[i] += sample.weights[i] * sample.weights[i];
        }
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(sums[i] / count, 1.0 / 3.0, 0.005);
        EXPECT_NEAR(squares[i] / count, 1.0 / 6.0, 0.005); // second moment of a barycentric coordinate
    }
}

TEST(SurfaceSampling, SurfaceWithoutAreaIsSampledAllTheSame)
{
    TestMesh mesh = makeTetrahedron();
    mesh.buffers[0].positions = {0, 0, 0, 1, 0, 0, 2, 0, 0, 4, 0, 0};
    const SurfaceOf source(mesh);
    std::vector<int> counts(4, 0);
    for (const SurfaceSample& sample : sampleArea(source.surface(), 400, 1))
        ++counts[sample.triangle];
    for (const int count : counts)
        EXPECT_NEAR(count, 100, 1);
}

TEST(SurfaceSampling, VerticesOnceEach)
{
    const SurfaceOf source(makeUvSphere(8, 4));
    EXPECT_EQ(sampleVertices(source.surface()).size(), 9u * 5u - 2u); // one at each pole is not used
}
