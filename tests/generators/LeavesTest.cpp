#include <lodsmith/generators/FoliageLevels.h>

#include <support/MeshBuilders.h>

#include <gtest/gtest.h>

#include <limits>

namespace lodsmith::test {
namespace {

/// How many leaves are found.
std::uint32_t leavesIn(const TestMesh& mesh, const FoliageOptions& options = {})
{
    const auto levels = foliageLevels(mesh.view(), {}, options);
    EXPECT_TRUE(levels) << describe(levels.error());
    EXPECT_TRUE(levels.value().levels.empty());
    return levels.value().leaves;
}

TestMesh turnedBoth(const TestMesh& mesh)
{
    TestMesh both = mesh;
    const auto& indices = mesh.subMeshes[0].indices;
    for (std::size_t i = 0; i < indices.size(); i += 3)
        both.subMeshes[0].addTriangle(indices[i + 2], indices[i + 1], indices[i]);
    return both;
}

/// Cards of no area: four corners at one place, or on a line.
TestMesh makeFlatCards(std::uint32_t count)
{
    TestMesh mesh = makeLeafCards(count);
    auto& positions = mesh.buffers[0].positions;
    for (std::size_t i = 0; i < positions.size(); ++i)
        if (const std::size_t corner = i / 3 % 4, card = i / 12; corner > 0)
            positions[i] = positions[12 * card + i % 3] + (card % 2 == 0 || i % 3 > 0 ? 0.0f : 0.01f * float(corner));
    return mesh;
}

TEST(Leaves, AreSmallSheets)
{
    EXPECT_EQ(leavesIn(makeLeafCards(40)), 40u);
    EXPECT_EQ(leavesIn(joined(makeLeafCards(40), makeCylinder(8, 20, 0.05, 1.0))), 40u);
    EXPECT_EQ(leavesIn(flatShaded(makeLeafCards(40))), 40u) << "what hangs together does so over positions";
    EXPECT_EQ(leavesIn(turnedBoth(makeLeafCards(40))), 40u) << "with backs";
}

TEST(Leaves, AreNotTubesBallsAndBoxes)
{
    TestMesh twigs = makeCylinder(4, 3, 0.02, 0.2);
    for (int i = 1; i < 30; ++i)
        twigs = joined(twigs, translated(makeCylinder(4, 3, 0.02, 0.2), 0.1 * i, 0.3 * (i % 3), 0.2 * (i % 5)));
    for (const TestMesh& mesh :
         {twigs, makeUvSphere(20, 12), makeCube(2), makeIslands(50), makeTerrain(12), makeSkinnedTube(12, 12)})
        EXPECT_EQ(leavesIn(mesh), 0u);
}

TEST(Leaves, AreFoliageOnlyWhenThereAreMany)
{
    EXPECT_EQ(leavesIn(makeLeafCards(1)), 0u);
    EXPECT_EQ(leavesIn(makeLeafCards(7)), 0u);
    EXPECT_EQ(leavesIn(makeLeafCards(8)), 8u);
    EXPECT_EQ(leavesIn(joined(makeLeafCards(40), translated(makeUvSphere(20, 12, 0.5), 0.5, 0.5, 0.5))), 0u)
        << "a ball with some leaves on it";
    EXPECT_EQ(leavesIn(joined(makeLeafCards(20), scaled(makeGrid(2, 2), 0.6))), 0u)
        << "one sheet larger than all others";
}

TEST(Leaves, AreThoseOfTheSubMeshesThatTheCallerNames)
{
    const TestMesh mesh = joined(makeLeafCards(1), makeUvSphere(20, 12));
    FoliageOptions options;
    options.leafSubMeshes = {true, false};
    EXPECT_EQ(leavesIn(mesh, options), 1u);
    options.leafSubMeshes = {false, true};
    EXPECT_EQ(leavesIn(mesh, options), 0u);
    const TestMesh two = joined(makeLeafCards(20), translated(makeLeafCards(30, 2), 1.0, 0.0, 0.0));
    EXPECT_EQ(leavesIn(two, options), 30u);
}

TEST(Leaves, WithoutAreaAreNone)
{
    EXPECT_EQ(leavesIn(makeFlatCards(20)), 0u);
    EXPECT_EQ(leavesIn(joined(makeLeafCards(20), makeFlatCards(20))), 20u);
}

TEST(Leaves, OfNothingAreNone)
{
    EXPECT_EQ(leavesIn(TestMesh{}), 0u);
    TestMesh empty = makeLeafCards(20);
    empty.subMeshes[0].indices.clear();
    EXPECT_EQ(leavesIn(empty), 0u);
}

TEST(Leaves, ThatTouchAtAVertexOfTheirBufferAreOnePiece)
{
    // Cards in pairs that meet in a corner: with a vertex of its own each is a leaf, with one vertex they move
    // together.
    TestMesh mesh = makeLeafCards(20);
    auto& positions = mesh.buffers[0].positions;
    for (std::size_t pair = 0; pair < 10; ++pair)
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const float shift = positions[24 * pair + axis] - positions[24 * pair + 18 + axis];
            for (std::size_t corner = 0; corner < 4; ++corner)
                positions[24 * pair + 12 + 3 * corner + axis] += shift;
            positions[24 * pair + 18 + axis] = positions[24 * pair + axis];
        }
    EXPECT_EQ(leavesIn(mesh), 20u);
    for (auto& index : mesh.subMeshes[0].indices)
        if (index % 8 == 6)
            index -= 6;
    EXPECT_EQ(leavesIn(mesh), 10u) << "two sheets that meet in a point are still a disc";
}

TEST(Leaves, OfABrokenMeshAreAnError)
{
    TestMesh mesh = makeLeafCards(20);
    mesh.buffers[0].positions[3] = std::numeric_limits<float>::quiet_NaN();
    auto levels = foliageLevels(mesh.view(), {});
    ASSERT_FALSE(levels);
    EXPECT_EQ(levels.error().code, ErrorCode::InvalidGeometry);
    mesh = makeLeafCards(20);
    mesh.subMeshes[0].indices[4] = 80;
    levels = foliageLevels(mesh.view(), {});
    ASSERT_FALSE(levels);
    EXPECT_EQ(levels.error().code, ErrorCode::IndexOutOfRange);
    EXPECT_EQ(levels.error().item, 4);
}

} // namespace
} // namespace lodsmith::test
