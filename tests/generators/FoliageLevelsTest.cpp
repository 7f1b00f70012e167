#include <lodsmith/analysis/Coverage.h>
#include <lodsmith/generators/FoliageLevels.h>

#include <support/MeshBuilders.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <ctime>

namespace lodsmith::test {
namespace {

using testing::Each;
using testing::IsSubsetOf;

/// A trunk along z through a cloud of cards.
TestMesh makeTree(std::uint32_t cards)
{
    return joined(makeLeafCards(cards), translated(makeCylinder(10, 40, 0.04, 1.4), 0.5, 0.5, -0.5));
}

std::vector<std::uint32_t> sharesOf(const TestMesh& mesh, const std::vector<double>& shares)
{
    std::vector<std::uint32_t> triangles;
    for (const double share : shares)
        triangles.push_back(static_cast<std::uint32_t>(share * double(mesh.triangleCount())));
    return triangles;
}

FoliageLevels levelsOf(const TestMesh& mesh, const std::vector<std::uint32_t>& triangles,
                       const FoliageOptions& options = {})
{
    auto levels = foliageLevels(mesh.view(), triangles, options);
    EXPECT_TRUE(levels) << describe(levels.error());
    EXPECT_EQ(levels.value().levels.size(), levels.value().leaves == 0 ? 0 : triangles.size());
    return std::move(levels).value();
}

double keptBy(const TestMesh& mesh, const MeshView& level)
{
    const auto coverage = CoverageMeter::of(mesh.view()).value().measure(level);
    EXPECT_TRUE(coverage) << describe(coverage.error());
    return coverage.value().kept;
}

double keptByIndices(const TestMesh& mesh, std::uint32_t triangles)
{
    const auto chain = simplify(mesh.view(), {{LevelTarget::Kind::Triangles, double(triangles)}});
    EXPECT_TRUE(chain);
    return keptBy(mesh, mesh.view(chain.value().levels[0]));
}

std::uint32_t trianglesIn(const FoliageLevel& level)
{
    std::size_t count = 0;
    for (const auto& list : level.indices)
        count += list.size() / 3;
    return static_cast<std::uint32_t>(count);
}

TEST(FoliageLevels, KeepTheOutlineWhereDroppedLeavesLoseIt)
{
    const TestMesh tree = makeTree(400);
    const auto triangles = sharesOf(tree, {0.4, 0.2, 0.1});
    const FoliageLevels levels = levelsOf(tree, triangles);
    ASSERT_EQ(levels.leaves, 400u);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        SCOPED_TRACE(i);
        const FoliageLevel& level = levels.levels[i];
        ASSERT_TRUE(level.made);
        EXPECT_LE(level.triangles, triangles[i]);
        EXPECT_EQ(level.triangles, trianglesIn(level));
        EXPECT_GT(keptBy(tree, level.view(tree.view())), keptByIndices(tree, triangles[i]));
    }
    EXPECT_GE(keptBy(tree, levels.levels[0].view(tree.view())), 0.95);
}

TEST(FoliageLevels, KeepNoLeafThatTheLevelBeforeHasNot)
{
    const TestMesh tree = makeTree(200);
    const FoliageLevels levels = levelsOf(tree, sharesOf(tree, {0.5, 0.3, 0.2, 0.1, 0.05}));
    for (std::size_t i = 1; i < levels.levels.size(); ++i) {
        ASSERT_TRUE(levels.levels[i].made);
        EXPECT_TRUE(std::is_sorted(levels.levels[i].leaves.begin(), levels.levels[i].leaves.end()));
        EXPECT_THAT(levels.levels[i].leaves, IsSubsetOf(levels.levels[i - 1].leaves));
    }
    EXPECT_LT(levels.levels.back().leaves.size(), levels.levels.front().leaves.size());
}

TEST(FoliageLevels, AreTheSameEveryTime)
{
    const TestMesh tree = makeTree(150), copy = tree;
    const auto triangles = sharesOf(tree, {0.4, 0.15});
    const FoliageLevels one = levelsOf(tree, triangles), other = levelsOf(copy, triangles);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        EXPECT_EQ(one.levels[i].indices, other.levels[i].indices);
        EXPECT_EQ(one.levels[i].positions, other.levels[i].positions);
        EXPECT_EQ(one.levels[i].leaves, other.levels[i].leaves);
    }
}

TEST(FoliageLevels, MoveNothingButLeavesAndTheseOnlyApart)
{
    const TestMesh tree = makeTree(200);
    const FoliageLevels levels = levelsOf(tree, sharesOf(tree, {0.12}));
    const FoliageLevel& level = levels.levels[0];
    EXPECT_EQ(level.positions[1], tree.buffers[1].positions) << "the trunk";
    EXPECT_GT(level.largestScale, 1.0);
    const auto sizeOf = [](const std::vector<float>& p, std::size_t card) { // half the diagonal
        return std::hypot(p[12 * card] - p[12 * card + 6], p[12 * card + 1] - p[12 * card + 7],
                          p[12 * card + 2] - p[12 * card + 8]);
    };
    double largest = 1.0;
    for (std::size_t card = 0; card < 200; ++card) {
        const double scale = sizeOf(level.positions[0], card) / sizeOf(tree.buffers[0].positions, card);
        const bool isKept = std::binary_search(level.leaves.begin(), level.leaves.end(), card);
        EXPECT_TRUE(scale > 0.9999 && scale < 2.0001 && (isKept || scale < 1.0001)) << scale;
        largest = std::max(largest, scale);
    }
    EXPECT_NEAR(largest, level.largestScale, 1e-4);
}

TEST(FoliageLevels, CanBeAllLeaves)
{
    const TestMesh cards = makeLeafCards(300);
    const FoliageLevels levels = levelsOf(cards, {300, 150, 1, 0});
    for (const FoliageLevel& level : levels.levels)
        EXPECT_TRUE(level.made);
    EXPECT_EQ(levels.levels[2].triangles, 1u);
    EXPECT_EQ(levels.levels[3].triangles, 0u);
    EXPECT_GT(keptBy(cards, levels.levels[0].view(cards.view())), keptByIndices(cards, 300));
}

TEST(FoliageLevels, OfASingleLeafIsThatLeaf)
{
    const TestMesh mesh = joined(makeLeafCards(1), makeUvSphere(20, 12));
    FoliageOptions options;
    options.leafSubMeshes = {true, false};
    const FoliageLevels levels = levelsOf(mesh, sharesOf(mesh, {0.3}), options);
    ASSERT_EQ(levels.leaves, 1u);
    EXPECT_THAT(levels.levels[0].leaves, testing::SizeIs(testing::Le(1u)));
    EXPECT_LE(levels.levels[0].triangles, static_cast<std::uint32_t>(0.3 * double(mesh.triangleCount())));
}

TEST(FoliageLevels, OfAMeshWithoutFoliageAreNone)
{
    EXPECT_EQ(levelsOf(makeUvSphere(20, 12), {100, 50}).leaves, 0u);
}

TEST(FoliageLevels, WithFewerTrianglesThanTheWoodCanHaveAreNotMade)
{
    // Of a closed surface simplify() leaves a tetrahedron at least.
    const FoliageLevels levels =
        levelsOf(joined(makeLeafCards(100), translated(makeUvSphere(12, 8, 0.05), 0.5, 0.5, 0.5)), {50, 3});
    ASSERT_EQ(levels.leaves, 100u);
    EXPECT_TRUE(levels.levels[0].made);
    EXPECT_FALSE(levels.levels[1].made);
    EXPECT_TRUE(levels.levels[1].indices.empty());
}

TEST(FoliageLevels, CarryEveryAttribute)
{
    TestMesh tree = makeTree(120);
    TestBuffer& leaves = tree.buffers[0];
    leaves.colours.assign(4 * std::size_t(leaves.vertexCount()), 0.5f);
    leaves.bones.resize(leaves.vertexCount());
    for (std::uint32_t i = 0; i < leaves.vertexCount(); ++i)
        leaves.bones[i] = {{static_cast<std::uint16_t>(i / 4), 0, 0, 0}, {1.0f, 0.0f, 0.0f, 0.0f}};
    const MeshView original = tree.view();
    const FoliageLevels levels = levelsOf(tree, sharesOf(tree, {0.2}));
    const MeshView level = levels.levels[0].view(original);
    for (std::size_t i = 0; i < original.vertexBuffers.size(); ++i) {
        const VertexBufferView &before = original.vertexBuffers[i], &after = level.vertexBuffers[i];
        EXPECT_EQ(after.vertexCount, before.vertexCount);
        EXPECT_EQ(after.normals.data, before.normals.data);
        EXPECT_EQ(after.colours.data, before.colours.data);
        EXPECT_EQ(after.bones, before.bones);
        ASSERT_EQ(after.uvSets.size(), before.uvSets.size());
        EXPECT_EQ(after.uvSets[0].stream.data, before.uvSets[0].stream.data);
    }
    // The corners of a level's triangle are of one card, and so of one bone.
    const auto& indices = levels.levels[0].indices[0];
    for (std::size_t i = 0; i < indices.size(); i += 3)
        EXPECT_THAT((std::vector<std::uint32_t>{indices[i + 1] / 4, indices[i + 2] / 4}), Each(indices[i] / 4));
}

TEST(FoliageLevels, MoveAsTheOriginalInItsPoses)
{
    TestMesh cards = makeLeafCards(120);
    TestBuffer& buffer = cards.buffers[0];
    TestRandom random(3);
    std::vector<float> offsets;
    for (std::uint32_t card = 0; card < 120; ++card) {
        // Each card moves, and opens or closes along its diagonal like a door.
        const double x = random.uniform(), y = random.uniform(), bend = random.uniform(-0.05, 0.05);
        for (int corner = 0; corner < 4; ++corner)
            for (const double value : {x, y + (corner == 1 ? bend : 0.0), corner == 3 ? bend : 0.0})
                offsets.push_back(static_cast<float>(value));
    }
    buffer.offsets = {offsets};
    const FoliageLevels levels = levelsOf(cards, {60});
    const FoliageLevel& level = levels.levels[0];
    ASSERT_GT(level.largestScale, 1.0);
    // A posed enlarged leaf is the posed leaf enlarged: lengths between corners are `scale` times as long.
    for (const std::uint32_t card : level.leaves) {
        const auto posed = [&](const std::vector<float>& p, const std::vector<float>& o, std::size_t corner, int axis) {
            const std::size_t at = 12 * std::size_t(card) + 3 * corner + std::size_t(axis);
            return double(p[at]) + double(o[at]);
        };
        const double scale = (double(level.positions[0][12 * card + 6]) - level.positions[0][12 * card])
                             / (double(buffer.positions[12 * card + 6]) - buffer.positions[12 * card]);
        for (std::size_t corner = 1; corner < 4; ++corner)
            for (int axis = 0; axis < 3; ++axis) {
                const double before =
                    posed(buffer.positions, offsets, corner, axis) - posed(buffer.positions, offsets, 0, axis);
                const double after = posed(level.positions[0], level.offsets[0][0], corner, axis)
                                     - posed(level.positions[0], level.offsets[0][0], 0, axis);
                EXPECT_NEAR(after, scale * before, 1e-4);
            }
    }
}

TEST(FoliageLevels, RefuseOptionsOutOfRange)
{
    const TestMesh cards = makeLeafCards(20);
    for (const double opacity : {0.0, 0.04, 1.01, std::nan("")}) {
        FoliageOptions options;
        options.leafOpacity = opacity;
        const auto levels = foliageLevels(cards.view(), {10}, options);
        ASSERT_FALSE(levels);
        EXPECT_EQ(levels.error().code, ErrorCode::InvalidSetting);
    }
    FoliageOptions options;
    options.leafSubMeshes = {true, true};
    EXPECT_FALSE(foliageLevels(cards.view(), {10}, options));
}

TEST(FoliageLevels, CanBeCancelled)
{
    Progress progress;
    progress.cancel();
    const auto levels = foliageLevels(makeTree(50).view(), {100}, {}, &progress);
    ASSERT_FALSE(levels);
    EXPECT_EQ(levels.error().code, ErrorCode::Cancelled);
}

TEST(FoliageLevels, OfTenTimesTheLeavesTakeAboutTenTimesAsLong)
{
    const auto secondsFor = [](std::uint32_t count) {
        const TestMesh forest = makeLeafCards(count);
        const std::clock_t start = std::clock();
        EXPECT_EQ(levelsOf(forest, {count / 2}).leaves, count);
        return double(std::clock() - start) / CLOCKS_PER_SEC;
    };
    EXPECT_LT(secondsFor(100000), 30.0 * secondsFor(10000));
}

} // namespace
} // namespace lodsmith::test
