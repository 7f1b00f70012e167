#include <lodsmith/analysis/Deviation.h>

#include "support/MeshBuilders.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace lodsmith;
using namespace lodsmith::test;

namespace {

constexpr double kPi = 3.14159265358979323846;

Deviation deviationOf(const TestMesh& original, const TestMesh& simplified, std::uint32_t samples = 5000)
{
    DeviationOptions options;
    options.samples = samples;
    return measureDeviation(original.view(), simplified.view(), options).value();
}

ErrorCode errorOf(const TestMesh& original, const TestMesh& simplified)
{
    return measureDeviation(original.view(), simplified.view()).error().code;
}

void expectFigures(const DeviationFigures& figures, double value, double tolerance)
{
    EXPECT_NEAR(figures.mean, value, tolerance);
    EXPECT_NEAR(figures.rms, value, tolerance);
    EXPECT_NEAR(figures.maximum, value, tolerance);
}

bool sameBits(const DeviationFigures& a, const DeviationFigures& b)
{
    return a.mean == b.mean && a.rms == b.rms && a.maximum == b.maximum;
}

TestMesh withShiftedUvs(TestMesh mesh, float du)
{
    for (std::size_t i = 0; i < mesh.buffers[0].uvSets[0].size(); i += 2)
        mesh.buffers[0].uvSets[0][i] += du;
    return mesh;
}

TestMesh withoutNormals(TestMesh mesh)
{
    for (TestBuffer& buffer : mesh.buffers)
        buffer.normals.clear();
    return mesh;
}

TestMesh onlyFirstHalf(TestMesh mesh)
{
    std::vector<std::uint32_t>& indices = mesh.subMeshes[0].indices;
    indices.resize(indices.size() / 2);
    return mesh;
}

} // namespace

TEST(Deviation, AMeshDoesNotDeviateFromItself)
{
    for (const TestMesh& mesh : {makeGrid(5, 5), makeUvSphere(12, 8), makeTorus(12, 8), makeCube(3), makeCylinder(9, 4),
                                 makeTwoSidedWall(4), makeLeafCards(40), makeSoup(60), makeBook(5),
                                 makeTwoMaterials(3, false), flatShaded(makeTerrain(8)), makeClosedLips(4)}) {
        const Deviation deviation = deviationOf(mesh, mesh);
        expectFigures(deviation.surface, 0.0, 1e-12);
        expectFigures(deviation.normal, 0.0, 1e-6);
        expectFigures(deviation.uv, 0.0, 1e-6);
        EXPECT_EQ(deviation.flippedTriangles, 0u);
        EXPECT_EQ(deviation.newBorderEdges, 0u);
        EXPECT_EQ(deviation.newNonManifoldEdges, 0u);
    }
}

TEST(Deviation, ShiftedPlane)
{
    const Deviation deviation = deviationOf(makeGrid(4, 4), translated(makeGrid(7, 3), 0.0, 0.0, 0.25));
    expectFigures(deviation.surface, 0.25, 1e-15);
    expectFigures(deviation.normal, 0.0, 0.0);
}

TEST(Deviation, ShiftedPlaneFarFromTheOrigin)
{
    const TestMesh near = translated(makeGrid(4, 4, 16.0), 1048576.0, -2097152.0, 524288.0);
    expectFigures(deviationOf(near, translated(near, 0.0, 0.0, 0.5)).surface, 0.5, 1e-9);
}

TEST(Deviation, MissingHalfShowsFromTheOriginalsSide)
{
    // Over the missing half (0.5 < y < 1) the distance grows as y - 0.5; from the simplified side everything is in
    // place.
    for (const bool swapped : {false, true}) {
        const TestMesh whole = makeGrid(8, 8), half = onlyFirstHalf(makeGrid(8, 8));
        const Deviation deviation = swapped ? deviationOf(half, whole, 100000) : deviationOf(whole, half, 100000);
        EXPECT_NEAR(deviation.surface.mean, (1.0 / 8.0 + 0.0) / 2.0, 1e-4);
        EXPECT_NEAR(deviation.surface.rms, std::sqrt((1.0 / 24.0 + 0.0) / 2.0), 1e-4);
        EXPECT_DOUBLE_EQ(deviation.surface.maximum, 0.5);
    }
}

TEST(Deviation, SphereAgainstInscribedIcosahedron)
{
    // Face planes of an icosahedron in the unit sphere are this far from the centre.
    const double inner = std::sqrt((5.0 + 2.0 * std::sqrt(5.0)) / 15.0);
    const Deviation deviation = deviationOf(makeIcosphere(5), makeIcosphere(0), 50000);
    EXPECT_LE(deviation.surface.maximum, 1.0 - inner + 1e-6);
    EXPECT_GE(deviation.surface.maximum, 1.0 - inner - 2e-3);
    EXPECT_LT(deviation.surface.mean, deviation.surface.rms);
    EXPECT_LT(deviation.surface.rms, deviation.surface.maximum);
    EXPECT_EQ(deviation.flippedTriangles, 0u);
}

TEST(Deviation, ErrorFallsWithTheSquareOfTheEdgeLength)
{
    const TestMesh fine = makeIcosphere(6);
    const double coarse = deviationOf(fine, makeIcosphere(2), 20000).surface.maximum;
    const double better = deviationOf(fine, makeIcosphere(3), 20000).surface.maximum;
    EXPECT_NEAR(coarse / better, 4.0, 0.4);
}

TEST(Deviation, VerticesAreSamples)
{
    // A spike too thin for a single area sample to find: its tip is a vertex.
    TestMesh spiked = makeGrid(4, 4);
    TestBuffer& buffer = spiked.buffers[0];
    buffer = TestBuffer{buffer.positions, {}, {}, {}, {}, {}, {}, {}};
    const std::uint32_t tip = buffer.addPosition(0.5, 0.5, 7.0);
    spiked.subMeshes[0].addTriangle(12, 12 + 1, tip);
    buffer.positions[3 * 13] = buffer.positions[3 * 12] + 1e-6f;
    const TestMesh flat = withoutNormals(makeGrid(4, 4));
    EXPECT_DOUBLE_EQ(deviationOf(flat, spiked, 1).surface.maximum, 7.0);
}

TEST(Deviation, RotatedNormals)
{
    TestMesh rotated = makeGrid(4, 4);
    rotated.buffers[0].normals.clear();
    for (std::uint32_t i = 0; i < rotated.buffers[0].vertexCount(); ++i)
        rotated.buffers[0].addNormal(0.0, 5.0 * std::sin(0.3), 5.0 * std::cos(0.3)); // any length will do
    expectFigures(deviationOf(makeGrid(4, 4), rotated).normal, 0.3, 1e-6);
}

TEST(Deviation, FaceNormalsStandInForMissingOnes)
{
    const TestMesh flat = withoutNormals(makeGrid(3, 3));
    expectFigures(deviationOf(flat, makeGrid(3, 3)).normal, 0.0, 0.0);
    TestMesh nulled = makeGrid(3, 3);
    std::fill(nulled.buffers[0].normals.begin(), nulled.buffers[0].normals.end(), 0.0f);
    expectFigures(deviationOf(flat, nulled).normal, 0.0, 0.0);
    // A roof whose faces lean 45 degrees either way, lit as if it were flat.
    TestMesh roof = makePatch(2, 1, [](double u, double v) { return Point{u, v, u == 0.5 ? 0.5 : 0.0}; });
    roof.buffers[0].normals = makeGrid(2, 1).buffers[0].normals;
    expectFigures(deviationOf(roof, withoutNormals(roof)).normal, kPi / 4.0, 1e-6);
}

TEST(Deviation, ShiftedUvs)
{
    expectFigures(deviationOf(makeGrid(4, 4), withShiftedUvs(makeGrid(4, 4), 0.125f)).uv, 0.125, 3e-6);
}

TEST(Deviation, UvsAreComparedOnlyWhereBothMeshesHaveThem)
{
    TestMesh bare = makeGrid(4, 4);
    bare.buffers[0].uvSets.clear();
    expectFigures(deviationOf(makeGrid(4, 4), bare).uv, 0.0, 0.0);
}

TEST(Deviation, SeamIsNoDeviationWhenTheSurfaceIsRefined)
{
    // Flat faces and straight seams: splitting them changes neither shape nor texture, but every vertex lies on wedges
    // of other triangles than before.
    const Deviation cube = deviationOf(makeCube(12), makeCube(1), 20000);
    expectFigures(cube.surface, 0.0, 1e-7);
    expectFigures(cube.normal, 0.0, 1e-6);
    expectFigures(cube.uv, 0.0, 1e-5);
    const Deviation tube = deviationOf(makeCylinder(16, 12), makeCylinder(16, 3), 20000);
    expectFigures(tube.normal, 0.0, 1e-5);
    expectFigures(tube.uv, 0.0, 1e-5);
}

TEST(Deviation, SeamOfACurvedSurfaceIsNoDeviation)
{
    // On a coarser ring, points beside a seam have their closest point beyond it by a hair,
    // where the texture begins anew, 1 UV unit away.
    const auto ring = [](std::uint32_t sectors, std::uint32_t sides) {
        TestMesh mesh = makeTorus(sectors, sides);
        std::vector<float>& positions = mesh.buffers[0].positions;
        for (std::size_t i = 0; i < positions.size(); i += 3)
            positions[i + 2] += 0.2f * positions[i] * positions[i + 1]; // bends the seams' planes
        return mesh;
    };
    const Deviation deviation = deviationOf(ring(72, 48), ring(24, 16), 20000);
    ASSERT_GT(deviation.surface.mean, 0.001);
    EXPECT_LT(deviation.uv.maximum, 0.05);
}

TEST(Deviation, UvsThatSlideAlongACurvedSurfaceAreDeviation)
{
    // Nothing is across a seam here, so every sample keeps its shift, small or large.
    for (const float shift : {0.01f, 0.05f, 0.3f}) {
        const Deviation slid = deviationOf(makeTerrain(40), withShiftedUvs(makeTerrain(10), shift), 20000);
        const Deviation inPlace = deviationOf(makeTerrain(40), makeTerrain(10), 20000);
        EXPECT_NEAR(slid.uv.mean, shift, inPlace.uv.mean);
    }
}

TEST(Deviation, TwoSidedWallIsComparedSideBySide)
{
    const TestMesh wall = makeTwoSidedWall(6);
    const Deviation refined = deviationOf(wall, makeTwoSidedWall(2));
    expectFigures(refined.normal, 0.0, 1e-6);
    expectFigures(refined.uv, 0.0, 1e-5);
    EXPECT_EQ(refined.flippedTriangles, 0u);

    // Without its back, the back's samples find only a surface that looks away.
    const Deviation front = deviationOf(wall, onlyFirstHalf(wall));
    EXPECT_NEAR(front.normal.maximum, kPi, 1e-6);
    EXPECT_NEAR(front.normal.mean, kPi / 4.0, 0.01); // half of one side's samples
    EXPECT_NEAR(front.surface.maximum, 0.0, 1e-12);
    EXPECT_EQ(front.flippedTriangles, 0u);

    // Textures that differ between the sides: the front's own UV counts, not the nearest of both.
    TestMesh marked = wall;
    for (std::size_t i = 0; i < marked.buffers[0].uvSets[0].size() / 2; ++i)
        marked.buffers[0].uvSets[0][i] += 0.25f;
    TestMesh exchanged = wall;
    for (std::size_t i = exchanged.buffers[0].uvSets[0].size() / 2; i < exchanged.buffers[0].uvSets[0].size(); ++i)
        exchanged.buffers[0].uvSets[0][i] += 0.25f;
    EXPECT_GT(deviationOf(marked, exchanged).uv.mean, 0.25);
}

TEST(Deviation, AttributesAreComparedWithinTheSubMesh)
{
    // Submesh 0 of the simplified mesh lies nearer to the original's submesh 1, which has quite another texture.
    const TestMesh second = translated(withShiftedUvs(makeGrid(4, 4), 5.0f), 0.0, 0.0, 0.125);
    const TestMesh original = joined(makeGrid(4, 4), second);
    const TestMesh simplified = joined(translated(makeGrid(4, 4), 0.0, 0.0, 0.09375), second);
    const Deviation deviation = deviationOf(original, simplified);
    expectFigures(deviation.uv, 0.0, 1e-5);
    EXPECT_DOUBLE_EQ(deviation.surface.maximum, 0.09375);

    // An empty submesh leaves nothing to compare with: the distance counts, the texture does not.
    TestMesh vanished = original;
    vanished.subMeshes[0].indices.clear();
    const Deviation without = deviationOf(original, vanished);
    expectFigures(without.uv, 0.0, 1e-5);
    EXPECT_DOUBLE_EQ(without.surface.maximum, 0.125);
}

TEST(Deviation, ScalesWithTheMesh)
{
    const TestMesh fine = makeTerrain(24), coarse = makeTerrain(6);
    const Deviation unit = deviationOf(fine, coarse);
    ASSERT_GT(unit.surface.mean, 0.0);
    for (const int exponent : {60, 100, -60, -100}) { // powers of two: the same up to the last bit
        const double scale = std::ldexp(1.0, exponent);
        const Deviation sized = deviationOf(scaled(fine, scale), scaled(coarse, scale));
        EXPECT_EQ(sized.surface.mean, unit.surface.mean * scale);
        EXPECT_EQ(sized.surface.maximum, unit.surface.maximum * scale);
        EXPECT_EQ(sized.normal.mean, unit.normal.mean);
        EXPECT_EQ(sized.flippedTriangles, 0u);
        EXPECT_EQ(sized.newBorderEdges, 0u);
    }
    for (const double scale : {1e18, 1e-30}) {
        const Deviation sized = deviationOf(scaled(fine, scale), scaled(coarse, scale));
        EXPECT_NEAR(sized.surface.mean / scale, unit.surface.mean, 1e-4 * unit.surface.mean);
        EXPECT_NEAR(sized.surface.maximum / scale, unit.surface.maximum, 1e-4 * unit.surface.maximum);
    }
}

TEST(Deviation, DegenerateMeshes)
{
    const TestMesh point = scaled(makeCube(), 0.0);
    const Deviation nothing = deviationOf(point, point);
    expectFigures(nothing.surface, 0.0, 0.0);
    EXPECT_EQ(nothing.degenerateTriangles, 12u);
    EXPECT_EQ(errorOf(makeCube(), point), ErrorCode::Unsupported);
    EXPECT_EQ(errorOf(point, makeCube()), ErrorCode::Unsupported);
    EXPECT_TRUE(measureDeviation(MeshView{}, MeshView{}).ok());

    TestMesh needles = makeTetrahedron();
    needles.buffers[0].positions = {0, 0, 0, 1, 0, 0, 2, 0, 0, 4, 0, 0};
    const Deviation line = deviationOf(needles, translated(needles, 0.0, 3.0, 0.0));
    expectFigures(line.surface, 3.0, 1e-12);
    EXPECT_EQ(line.flippedTriangles, 0u);
    expectFigures(line.normal, 0.0, 0.0);
}

TEST(Deviation, TheSameSeedGivesTheSameFigures)
{
    const TestMesh original = makeTorus(40, 20), simplified = makeTorus(14, 9);
    DeviationOptions options;
    options.samples = 3000;
    const Deviation first = measureDeviation(original.view(), simplified.view(), options).value();
    const Deviation again = measureDeviation(original.view(), simplified.view(), options).value();
    EXPECT_TRUE(sameBits(first.surface, again.surface));
    EXPECT_TRUE(sameBits(first.normal, again.normal));
    EXPECT_TRUE(sameBits(first.uv, again.uv));
    options.seed = 2;
    const Deviation other = measureDeviation(original.view(), simplified.view(), options).value();
    EXPECT_FALSE(sameBits(first.surface, other.surface));
    EXPECT_NEAR(other.surface.mean, first.surface.mean, 0.03 * first.surface.mean);
}

TEST(Deviation, ErrorsNameTheMeshAndThePlace)
{
    TestMesh bad = makeGrid(2, 2);
    bad.buffers[0].positions[4] = std::numeric_limits<float>::quiet_NaN();
    const Error position = measureDeviation(makeGrid(2, 2).view(), bad.view()).error();
    EXPECT_EQ(position.code, ErrorCode::InvalidGeometry);
    EXPECT_EQ(position.item, 1);
    EXPECT_NE(position.message.find("simplified"), std::string::npos);

    bad = makeGrid(2, 2);
    bad.buffers[0].normals[3 * 4] = std::numeric_limits<float>::infinity();
    const Error normal = measureDeviation(bad.view(), makeGrid(2, 2).view()).error();
    EXPECT_EQ(normal.code, ErrorCode::InvalidGeometry);
    EXPECT_EQ(normal.item, 4);
    EXPECT_NE(normal.message.find("original"), std::string::npos);

    bad = makeGrid(2, 2);
    bad.buffers[0].uvSets[0][2 * 4] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(errorOf(makeGrid(2, 2), bad), ErrorCode::InvalidGeometry);
    bad = makeGrid(2, 2);
    bad.subMeshes[0].indices[0] = 9;
    EXPECT_EQ(errorOf(makeGrid(2, 2), bad), ErrorCode::IndexOutOfRange);
    EXPECT_EQ(measureDeviation(makeGrid(2, 2).view(), makeGrid(2, 2).view(), {0, 1}).error().code,
              ErrorCode::InvalidSetting);
}

TEST(Deviation, ProgressAndCancel)
{
    const TestMesh mesh = makeGrid(8, 8);
    Progress progress;
    ASSERT_TRUE(measureDeviation(mesh.view(), mesh.view(), {}, &progress).ok());
    EXPECT_EQ(progress.fraction(), 1.0f);
    Progress cancelled;
    cancelled.cancel();
    EXPECT_EQ(measureDeviation(mesh.view(), mesh.view(), {}, &cancelled).error().code, ErrorCode::Cancelled);
}
