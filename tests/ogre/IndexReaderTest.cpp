#include <support/OgreMeshBuilder.h>
#include <support/OgreSession.h>

#include <lodsmith/ogre/MeshReader.h>

#include <OgreSubMesh.h>

#include <gmock/gmock.h>

namespace lodsmith::test {
namespace {

using Ogre::RenderOperation;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<std::uint32_t> readIndices(const MeshData& data, std::size_t view = 0)
{
    const SubMeshView& subMesh = data.view().subMeshes[view];
    std::vector<std::uint32_t> indices;
    for (std::uint32_t i = 0; i < subMesh.indexCount; ++i)
        indices.push_back(subMesh.index(i));
    return indices;
}

/// Meshes of nine vertices whose level 0 each test sets.
class IndexReaderTest : public testing::TestWithParam<bool> {
protected:
    Result<MeshData> read(const std::vector<std::uint32_t>& indices, RenderOperation::OperationType type,
                          std::size_t before = 0)
    {
        setIndices(*mMesh->getSubMesh(0), indices, type, GetParam(), before);
        return MeshReader::read(*mMesh);
    }

    OgreSession mSession;
    Ogre::MeshPtr mMesh = makeOgreMesh("nine vertices", makeGrid(2, 2));
};

TEST_P(IndexReaderTest, ListsKeepTheirOrderAndWidth)
{
    const auto data = read({0, 1, 4, 8, 7, 5}, RenderOperation::OT_TRIANGLE_LIST);
    ASSERT_TRUE(data);
    EXPECT_THAT(readIndices(data.value()), ElementsAre(0, 1, 4, 8, 7, 5));
    EXPECT_EQ(data.value().view().subMeshes[0].indexBytes, GetParam() ? 4 : 2);
    EXPECT_THAT(data.value().notes(), IsEmpty());
}

TEST_P(IndexReaderTest, StartAndCountAreHonoured)
{
    setIndices(*mMesh->getSubMesh(0), {0, 1, 4, 8, 7, 5, 1, 2, 5}, RenderOperation::OT_TRIANGLE_LIST, GetParam(), 4);
    mMesh->getSubMesh(0)->indexData->indexStart += 3;
    mMesh->getSubMesh(0)->indexData->indexCount = 3;
    const auto data = MeshReader::read(*mMesh);
    ASSERT_TRUE(data);
    EXPECT_THAT(readIndices(data.value()), ElementsAre(8, 7, 5));
}

TEST_P(IndexReaderTest, EverySecondTriangleOfAStripIsTurned)
{
    const auto data = read({0, 1, 3, 4, 6}, RenderOperation::OT_TRIANGLE_STRIP, 2);
    ASSERT_TRUE(data);
    EXPECT_THAT(readIndices(data.value()), ElementsAre(0, 1, 3, 3, 1, 4, 3, 4, 6));
    EXPECT_THAT(data.value().notes(), ElementsAre("submesh 0: a triangle strip, read as a list"));
}

TEST_P(IndexReaderTest, StitchesOfAStripAreDroppedAndKeepTheWinding)
{
    // Two strips joined by repeating the last and the first vertex.
    const auto data = read({0, 1, 3, 4, 4, 5, 5, 8, 7}, RenderOperation::OT_TRIANGLE_STRIP);
    ASSERT_TRUE(data);
    EXPECT_THAT(readIndices(data.value()), ElementsAre(0, 1, 3, 3, 1, 4, 5, 8, 7));
}

TEST_P(IndexReaderTest, FansShareTheirFirstVertex)
{
    const auto data = read({4, 0, 1, 2, 5, 5, 8}, RenderOperation::OT_TRIANGLE_FAN, 1);
    ASSERT_TRUE(data);
    EXPECT_THAT(readIndices(data.value()), ElementsAre(4, 0, 1, 4, 1, 2, 4, 2, 5, 4, 5, 8));
}

TEST_P(IndexReaderTest, StripsAndFansTooShortForATriangleAreEmpty)
{
    for (const auto type : {RenderOperation::OT_TRIANGLE_STRIP, RenderOperation::OT_TRIANGLE_FAN}) {
        const auto data = read({0, 1}, type);
        ASSERT_TRUE(data);
        EXPECT_THAT(readIndices(data.value()), IsEmpty());
    }
}

TEST_P(IndexReaderTest, IndicesThatMakeNoTriangleAreNoted)
{
    const auto data = read({0, 1, 4, 8, 7}, RenderOperation::OT_TRIANGLE_LIST);
    ASSERT_TRUE(data);
    EXPECT_THAT(readIndices(data.value()), ElementsAre(0, 1, 4));
    EXPECT_THAT(data.value().notes(), ElementsAre(HasSubstr("no whole triangle")));
}

TEST_P(IndexReaderTest, AnIndexWithoutAVertexIsNamed)
{
    const auto data = read({0, 1, 4, 8, 9, 5}, RenderOperation::OT_TRIANGLE_LIST, 3);
    ASSERT_FALSE(data);
    EXPECT_EQ(data.error().code, ErrorCode::IndexOutOfRange);
    EXPECT_EQ(data.error().subMesh, 0);
    EXPECT_EQ(data.error().item, 4);
    EXPECT_EQ(data.error().file, "nine vertices");
}

TEST_P(IndexReaderTest, ARangeBeyondTheBufferIsRefused)
{
    setIndices(*mMesh->getSubMesh(0), {0, 1, 4}, RenderOperation::OT_TRIANGLE_LIST, GetParam());
    Ogre::IndexData& indices = *mMesh->getSubMesh(0)->indexData;
    for (const auto& [start, count] :
         {std::pair<std::size_t, std::size_t>{0, 6}, {1, 3}, {4, 3}, {~std::size_t(0), 3}}) {
        indices.indexStart = start;
        indices.indexCount = count;
        const auto data = MeshReader::read(*mMesh);
        ASSERT_FALSE(data);
        EXPECT_EQ(data.error().code, ErrorCode::IndexOutOfRange);
    }
}

INSTANTIATE_TEST_SUITE_P(, IndexReaderTest, testing::Values(false, true),
                         [](const auto& info) { return info.param ? "Wide" : "Narrow"; });

TEST(IndexReaderNotesTest, WhatIsNoTriangleIsLeftAlone)
{
    OgreSession session;
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", joined(makeGrid(2, 2), makeGrid(1, 1)));
    const std::pair<RenderOperation::OperationType, std::string> kinds[] = {
        {RenderOperation::OT_POINT_LIST, "a point list"},
        {RenderOperation::OT_LINE_LIST, "a line list"},
        {RenderOperation::OT_LINE_STRIP, "a line strip"},
        {RenderOperation::OT_PATCH_3_CONTROL_POINT, "neither points, lines nor triangles"}};
    for (const auto& [type, name] : kinds) {
        setIndices(*mesh->getSubMesh(0), {0, 1, 2}, type);
        const auto data = MeshReader::read(*mesh);
        ASSERT_TRUE(data);
        EXPECT_THAT(data.value().subMeshOf(), ElementsAre(-1, 0));
        EXPECT_THAT(data.value().notes(), ElementsAre("submesh 0: " + name + ", left as it is"));
        EXPECT_EQ(data.value().view().vertexBuffers.size(), 1u);
    }
}

TEST(IndexReaderNotesTest, SubMeshesWithoutIndicesAreLeftAlone)
{
    OgreSession session;
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", joined(makeGrid(2, 2), makeGrid(1, 1)));
    setIndices(*mesh->getSubMesh(0), {}, RenderOperation::OT_TRIANGLE_LIST);
    mesh->getSubMesh(1)->indexData->indexCount = 0;
    const auto data = MeshReader::read(*mesh);
    ASSERT_TRUE(data);
    EXPECT_THAT(data.value().subMeshOf(), ElementsAre(-1, -1));
    EXPECT_THAT(data.value().notes(),
                ElementsAre("submesh 0: without indices, left as it is", "submesh 1: without indices, left as it is"));
}

TEST(IndexReaderNotesTest, AnIndexCountWithoutBufferIsRefused)
{
    OgreSession session;
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", makeGrid(2, 2));
    mesh->getSubMesh(0)->indexData->indexBuffer.reset();
    const auto data = MeshReader::read(*mesh);
    ASSERT_FALSE(data);
    EXPECT_EQ(data.error().code, ErrorCode::InvalidGeometry);
}

} // namespace
} // namespace lodsmith::test
