#include <lodsmith/analysis/Coverage.h>

#include <support/MeshBuilders.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace lodsmith::test {
namespace {

Coverage coverageOf(const TestMesh& original, const TestMesh& level, unsigned pixels = 512)
{
    const auto meter = CoverageMeter::of(original.view(), pixels);
    EXPECT_TRUE(meter) << describe(meter.error());
    const auto coverage = meter.value().measure(level.view());
    EXPECT_TRUE(coverage) << describe(coverage.error());
    return coverage.value();
}

/// A square in a plane of constant z around the origin.
TestMesh makeSquare(double size)
{
    return translated(makeGrid(1, 1, size), -size / 2, -size / 2, 0.0);
}

TEST(Coverage, OfAMeshByItselfIsWhole)
{
    for (const TestMesh& mesh : {makeUvSphere(20, 12), makeLeafCards(50), makeCube(3)}) {
        const Coverage coverage = coverageOf(mesh, mesh);
        EXPECT_EQ(coverage.kept, 1.0);
        EXPECT_EQ(coverage.leastKept, 1.0);
        EXPECT_EQ(coverage.gained, 0.0);
    }
}

TEST(Coverage, IsTheShareOfTheOutlinesArea)
{
    // From each direction but edge-on, where both are nothing, a square of half the side has a quarter of the area.
    const Coverage less = coverageOf(makeSquare(2.0), makeSquare(1.0));
    EXPECT_NEAR(less.leastKept, 0.25, 0.01);
    EXPECT_EQ(less.gained, 0.0);
    // Beyond the margin nothing is seen; 1.2 times the side is within it.
    const Coverage more = coverageOf(makeSquare(2.0), makeSquare(2.4));
    EXPECT_EQ(more.kept, 1.0);
    EXPECT_NEAR(more.gained, 7.0 / 8.0 * 0.44, 0.02) << "in one of eight directions the squares are edge-on";
    EXPECT_NEAR(more.size(), 1.0 + more.gained, 1e-12);
}

TEST(Coverage, LooksFromAllSides)
{
    // A wall of which the half is gone, and one at right angles to it that stays.
    const TestMesh wall = makeSquare(2.0);
    TestMesh across = wall;
    for (std::size_t i = 0; i < across.buffers[0].positions.size(); i += 3)
        std::swap(across.buffers[0].positions[i], across.buffers[0].positions[i + 2]);
    const Coverage coverage = coverageOf(joined(wall, across), across);
    EXPECT_LT(coverage.leastKept, 0.01) << "where the wall is seen from the front the other is edge-on";
    EXPECT_GT(coverage.kept, 0.4);
    EXPECT_LT(coverage.kept, 0.8);
}

TEST(Coverage, OfATurnedMeshIsTheSameWithinAFewPercent)
{
    const TestMesh cards = jittered(makeLeafCards(200), 0.05); // they all hold the z axis, along which one looks
    TestMesh fewer = cards;
    fewer.subMeshes[0].indices.resize(cards.subMeshes[0].indices.size() / 4);
    const double angle = 0.3;
    const auto turned = [&](TestMesh mesh) {
        auto& p = mesh.buffers[0].positions;
        for (std::size_t i = 0; i < p.size(); i += 3) {
            const double x = p[i], z = p[i + 2];
            p[i] = static_cast<float>(std::cos(angle) * x - std::sin(angle) * z);
            p[i + 2] = static_cast<float>(std::sin(angle) * x + std::cos(angle) * z);
        }
        return mesh;
    };
    EXPECT_NEAR(coverageOf(cards, fewer).kept, coverageOf(turned(cards), turned(fewer)).kept, 0.02);
}

TEST(Coverage, DependsLittleOnThePixelsAndNotOnSizeOrPlace)
{
    const TestMesh cards = makeLeafCards(100);
    TestMesh fewer = cards;
    fewer.subMeshes[0].indices.resize(cards.subMeshes[0].indices.size() / 2);
    const double kept = coverageOf(cards, fewer).kept;
    EXPECT_NEAR(coverageOf(cards, fewer, 64).kept, kept, 0.03);
    EXPECT_NEAR(coverageOf(cards, fewer, 2048).kept, kept, 0.005);
    EXPECT_NEAR(coverageOf(scaled(cards, 1024.0), scaled(fewer, 1024.0)).kept, kept, 1e-12);
    EXPECT_NEAR(coverageOf(translated(cards, 5, 6, 7), translated(fewer, 5, 6, 7)).kept, kept, 0.002);
}

TEST(Coverage, OfNothingIsNothingAndOfNothingOriginalWhole)
{
    const TestMesh square = makeSquare(2.0);
    TestMesh empty = square;
    empty.subMeshes[0].indices.clear();
    const Coverage none = coverageOf(square, empty);
    EXPECT_LE(none.kept, 1.0 / 8.0) << "edge-on there is nothing to lose";
    EXPECT_EQ(none.leastKept, 0.0);
    EXPECT_EQ(none.gained, 0.0);
    EXPECT_EQ(coverageOf(empty, square).kept, 1.0);
    EXPECT_EQ(coverageOf(empty, empty).kept, 1.0);
}

TEST(Coverage, RefusesWhatCannotBeDrawn)
{
    TestMesh mesh = makeSquare(1.0);
    const auto meter = CoverageMeter::of(mesh.view());
    ASSERT_TRUE(meter);
    for (const float wrong : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), 1e30f}) {
        mesh.buffers[0].positions[4] = wrong;
        const auto made = CoverageMeter::of(mesh.view());
        ASSERT_FALSE(made);
        EXPECT_EQ(made.error().code, ErrorCode::InvalidGeometry);
        EXPECT_EQ(made.error().item, 1);
        EXPECT_FALSE(meter.value().measure(mesh.view()));
    }
    mesh = makeSquare(1.0);
    mesh.subMeshes[0].indices[2] = 4;
    const auto made = CoverageMeter::of(mesh.view());
    ASSERT_FALSE(made);
    EXPECT_EQ(made.error().code, ErrorCode::IndexOutOfRange);
}

} // namespace
} // namespace lodsmith::test
