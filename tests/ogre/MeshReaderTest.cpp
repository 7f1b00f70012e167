#include <support/OgreMeshBuilder.h>
#include <support/OgreSession.h>

#include <lodsmith/ogre/MeshReader.h>

#include <OgreAnimation.h>
#include <OgreAnimationTrack.h>
#include <OgreHardwareBufferManager.h>
#include <OgreKeyFrame.h>
#include <OgreMeshManager.h>
#include <OgrePose.h>
#include <OgreSubMesh.h>

#include <gmock/gmock.h>

#include <array>
#include <numeric>

namespace lodsmith::test {
namespace {

using testing::ElementsAre;
using testing::ElementsAreArray;
using testing::FloatEq;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<float> allOf(const FloatStream& stream, std::uint32_t count, int components)
{
    std::vector<float> values(std::size_t(count) * static_cast<std::size_t>(components));
    for (std::uint32_t i = 0; stream && i < count; ++i)
        stream.read(i, components, &values[std::size_t(i) * static_cast<std::size_t>(components)]);
    return values;
}

class MeshReaderTest : public testing::Test {
protected:
    static MeshData read(const Ogre::Mesh& mesh)
    {
        auto data = MeshReader::read(mesh);
        EXPECT_TRUE(data) << describe(data.error());
        return std::move(data).value();
    }

    static ErrorCode refusal(const Ogre::Mesh& mesh)
    {
        const auto data = MeshReader::read(mesh);
        EXPECT_FALSE(data);
        EXPECT_EQ(data.error().file, mesh.getName());
        return data.error().code;
    }

    static Ogre::VertexData& vertices(const Ogre::MeshPtr& mesh, std::size_t subMesh = 0)
    {
        return *mesh->getSubMesh(subMesh)->vertexData;
    }

    OgreSession mSession;
};

TEST_F(MeshReaderTest, CopiesEveryStream)
{
    TestMesh source = makeUvSphere(8, 6);
    source.buffers[0].uvSets.push_back(source.buffers[0].uvSets[0]);
    source.buffers[0].colours.resize(4 * source.buffers[0].vertexCount());
    std::iota(source.buffers[0].colours.begin(), source.buffers[0].colours.end(), 0.0f);
    const MeshData data = read(*makeOgreMesh("mesh", source));
    const TestBuffer& buffer = source.buffers[0];
    ASSERT_EQ(data.view().vertexBuffers.size(), 1u);
    const VertexBufferView& view = data.view().vertexBuffers[0];
    ASSERT_EQ(view.vertexCount, buffer.vertexCount());
    EXPECT_THAT(allOf(view.positions, view.vertexCount, 3), ElementsAreArray(buffer.positions));
    EXPECT_THAT(allOf(view.normals, view.vertexCount, 3), ElementsAreArray(buffer.normals));
    ASSERT_EQ(view.uvSets.size(), 2u);
    EXPECT_THAT(allOf(view.uvSets[1].stream, view.vertexCount, 2), ElementsAreArray(buffer.uvSets[1]));
    EXPECT_THAT(allOf(view.colours, view.vertexCount, 4), ElementsAreArray(buffer.colours));
    EXPECT_EQ(view.bones, nullptr);
    EXPECT_THAT(view.offsets, IsEmpty());
    EXPECT_FALSE(view.importance);
}

TEST_F(MeshReaderTest, AbsentAttributesAreNull)
{
    const MeshData data = read(*makeOgreMesh("mesh", makeTetrahedron()));
    EXPECT_FALSE(data.view().vertexBuffers[0].normals);
    EXPECT_FALSE(data.view().vertexBuffers[0].colours);
    EXPECT_THAT(data.view().vertexBuffers[0].uvSets, IsEmpty());
}

TEST_F(MeshReaderTest, SharedVerticesAreReadOnce)
{
    const TestMesh source = makeTwoMaterials(4, true);
    const MeshData data = read(*makeOgreMesh("mesh", source, {true, false}));
    EXPECT_EQ(data.view().vertexBuffers.size(), 1u);
    ASSERT_EQ(data.view().subMeshes.size(), 2u);
    EXPECT_EQ(data.view().subMeshes[0].vertexBuffer, 0u);
    EXPECT_EQ(data.view().subMeshes[1].vertexBuffer, 0u);
}

TEST_F(MeshReaderTest, SharedAndOwnVerticesMix)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", makeTwoMaterials(4, true), {true, false});
    const Ogre::MeshPtr other = makeOgreMesh("other", makeTetrahedron());
    Ogre::SubMesh* own = mesh->createSubMesh();
    own->useSharedVertices = false;
    own->vertexData = vertices(other).clone();
    setIndices(*own, {0, 1, 2}, Ogre::RenderOperation::OT_TRIANGLE_LIST, true);
    const MeshData data = read(*mesh);
    ASSERT_EQ(data.view().vertexBuffers.size(), 2u);
    EXPECT_EQ(data.view().vertexBuffers[data.view().subMeshes[2].vertexBuffer].vertexCount, 4u);
    EXPECT_EQ(data.view().subMeshes[0].vertexBuffer, data.view().subMeshes[1].vertexBuffer);
    EXPECT_EQ(data.view().subMeshes[2].indexBytes, 4);
}

TEST_F(MeshReaderTest, VertexStartIsWhereIndexZeroLies)
{
    const TestMesh source = makeGrid(4, 4);
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", source);
    vertices(mesh).vertexStart = 10;
    vertices(mesh).vertexCount = 15;
    setIndices(*mesh->getSubMesh(0), {0, 1, 5}, Ogre::RenderOperation::OT_TRIANGLE_LIST);
    const MeshData data = read(*mesh);
    const VertexBufferView& view = data.view().vertexBuffers[0];
    ASSERT_EQ(view.vertexCount, 15u);
    EXPECT_THAT(allOf(view.positions, 15, 3),
                ElementsAreArray(source.buffers[0].positions.begin() + 30, source.buffers[0].positions.end()));
}

TEST_F(MeshReaderTest, PositionsAndNormalsMayLieInDifferentBuffers)
{
    const TestMesh source = makeUvSphere(8, 6);
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", source);
    auto* apart = vertices(mesh).vertexDeclaration->clone();
    apart->modifyElement(0, 0, 0, Ogre::VET_FLOAT3, Ogre::VES_POSITION);
    apart->modifyElement(1, 1, 0, Ogre::VET_FLOAT3, Ogre::VES_NORMAL);
    apart->modifyElement(2, 1, 12, Ogre::VET_FLOAT2, Ogre::VES_TEXTURE_COORDINATES);
    vertices(mesh).reorganiseBuffers(apart);
    ASSERT_EQ(vertices(mesh).vertexBufferBinding->getBufferCount(), 2u);
    const MeshData data = read(*mesh);
    const VertexBufferView& view = data.view().vertexBuffers[0];
    EXPECT_THAT(allOf(view.positions, view.vertexCount, 3), ElementsAreArray(source.buffers[0].positions));
    EXPECT_THAT(allOf(view.normals, view.vertexCount, 3), ElementsAreArray(source.buffers[0].normals));
    EXPECT_THAT(allOf(view.uvSets[0].stream, view.vertexCount, 2), ElementsAreArray(source.buffers[0].uvSets[0]));
}

TEST_F(MeshReaderTest, DoubledBuffersOfShadowVolumesAreReadOnce)
{
    const TestMesh source = makeUvSphere(8, 6);
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", source);
    mesh->prepareForShadowVolume();
    const auto* position = vertices(mesh).vertexDeclaration->findElementBySemantic(Ogre::VES_POSITION);
    ASSERT_EQ(vertices(mesh).vertexBufferBinding->getBuffer(position->getSource())->getNumVertices(),
              2 * source.buffers[0].vertexCount());
    const MeshData data = read(*mesh);
    const VertexBufferView& view = data.view().vertexBuffers[0];
    ASSERT_EQ(view.vertexCount, source.buffers[0].vertexCount());
    EXPECT_THAT(allOf(view.positions, view.vertexCount, 3), ElementsAreArray(source.buffers[0].positions));
}

TEST_F(MeshReaderTest, TheCopyOutlivesTheMeshAndMoves)
{
    const TestMesh source = makeGrid(3, 3);
    Ogre::MeshPtr mesh = makeOgreMesh("mesh", source);
    MeshData first = read(*mesh);
    Ogre::MeshManager::getSingleton().remove(mesh);
    mesh.reset();
    const MeshData data = std::move(first);
    EXPECT_THAT(allOf(data.view().vertexBuffers[0].positions, 16, 3), ElementsAreArray(source.buffers[0].positions));
    EXPECT_EQ(data.view().subMeshes[0].index(0), source.subMeshes[0].indices[0]);
}

TEST_F(MeshReaderTest, BrokenVertexDataIsRefused)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", makeGrid(3, 3));
    vertices(mesh).vertexCount = 17;
    EXPECT_EQ(refusal(*mesh), ErrorCode::InvalidGeometry);
    vertices(mesh).vertexCount = 16;
    vertices(mesh).vertexStart = 1;
    EXPECT_EQ(refusal(*mesh), ErrorCode::InvalidGeometry);
    vertices(mesh).vertexStart = 0;
    vertices(mesh).vertexDeclaration->modifyElement(1, 3, 0, Ogre::VET_FLOAT3, Ogre::VES_NORMAL);
    EXPECT_EQ(refusal(*mesh), ErrorCode::InvalidGeometry) << "nothing bound";
    vertices(mesh).vertexDeclaration->modifyElement(1, 0, 24, Ogre::VET_FLOAT3, Ogre::VES_NORMAL);
    EXPECT_EQ(refusal(*mesh), ErrorCode::InvalidGeometry) << "beyond the vertex";
    vertices(mesh).vertexDeclaration->removeElement(Ogre::VES_NORMAL);
    EXPECT_TRUE(MeshReader::read(*mesh));
    vertices(mesh).vertexDeclaration->removeElement(Ogre::VES_POSITION);
    EXPECT_EQ(refusal(*mesh), ErrorCode::InvalidGeometry) << "no positions";
}

TEST_F(MeshReaderTest, MissingVertexDataIsRefusedWithItsSubMesh)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", makeGrid(3, 3));
    Ogre::SubMesh* second = mesh->createSubMesh();
    setIndices(*second, {0, 1, 2}, Ogre::RenderOperation::OT_TRIANGLE_LIST);
    const auto data = MeshReader::read(*mesh);
    ASSERT_FALSE(data);
    EXPECT_EQ(data.error().code, ErrorCode::InvalidGeometry);
    EXPECT_EQ(data.error().subMesh, 1);
}

TEST_F(MeshReaderTest, AMeshWithoutSubMeshesIsRefused)
{
    const Ogre::MeshPtr mesh = Ogre::MeshManager::getSingleton().createManual("empty", "General");
    EXPECT_EQ(refusal(*mesh), ErrorCode::Unsupported);
}

TEST_F(MeshReaderTest, TheFourHeaviestBonesAreKeptAndSumToOne)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", makeTetrahedron());
    Ogre::SubMesh& subMesh = *mesh->getSubMesh(0);
    const std::pair<unsigned short, float> weights[] = {{7, 0.1f}, {3, 0.4f}, {9, 0.05f},
                                                        {1, 0.2f}, {2, 0.3f}, {4, 0.02f}};
    for (const auto& [bone, weight] : weights)
        subMesh.addBoneAssignment({2, bone, weight});
    subMesh.addBoneAssignment({0, 5, 0.5f});
    const MeshData data = read(*mesh);
    const BoneInfluences* bones = data.view().vertexBuffers[0].bones;
    ASSERT_NE(bones, nullptr);
    EXPECT_THAT(bones[2].bone, ElementsAre(3, 2, 1, 7));
    EXPECT_THAT(bones[2].weight, ElementsAre(FloatEq(0.4f), FloatEq(0.3f), FloatEq(0.2f), FloatEq(0.1f)));
    EXPECT_THAT(bones[0].weight, ElementsAre(1.0f, 0.0f, 0.0f, 0.0f));
    EXPECT_THAT(bones[1].weight, ElementsAre(0.0f, 0.0f, 0.0f, 0.0f)) << "a vertex without bones";
}

TEST_F(MeshReaderTest, SharedBonesGoWithSharedVertices)
{
    const TestMesh tube = makeSkinnedTube(6, 4);
    const MeshData data = read(*makeOgreMesh("mesh", tube, {true, false}));
    const BoneInfluences* bones = data.view().vertexBuffers[0].bones;
    ASSERT_NE(bones, nullptr);
    for (std::uint32_t i = 0; i < tube.buffers[0].vertexCount(); ++i) {
        float expected = 0, found = 0;
        for (int j = 0; j < 4; ++j) {
            expected += tube.buffers[0].bones[i].bone[j] == 1 ? tube.buffers[0].bones[i].weight[j] : 0.0f;
            found += bones[i].bone[j] == 1 ? bones[i].weight[j] : 0.0f;
        }
        EXPECT_FLOAT_EQ(found, expected) << "vertex " << i;
    }
}

TEST_F(MeshReaderTest, BoneAssignmentsWithoutVertexAreNoted)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", makeTetrahedron());
    mesh->getSubMesh(0)->addBoneAssignment({99, 0, 1.0f});
    const MeshData data = read(*mesh);
    EXPECT_THAT(data.notes(), ElementsAre(HasSubstr("1 bone assignments name no vertex")));
}

TEST_F(MeshReaderTest, PosesMoveTheVerticesOfTheirTarget)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", joined(makeGrid(1, 1), makeTetrahedron()));
    mesh->createPose(2)->addVertex(3, Ogre::Vector3(1, 2, 3));
    mesh->createPose(2)->addVertex(0, Ogre::Vector3(-1, 0, 0));
    mesh->createPose(0)->addVertex(0, Ogre::Vector3(9, 9, 9));
    mesh->createPose(1);
    const MeshData data = read(*mesh);
    EXPECT_THAT(data.view().vertexBuffers[0].offsets, IsEmpty()) << "an empty pose moves nothing";
    const auto& offsets = data.view().vertexBuffers[1].offsets;
    ASSERT_EQ(offsets.size(), 2u);
    EXPECT_THAT(allOf(offsets[0], 4, 3), ElementsAre(0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 2, 3));
    EXPECT_THAT(allOf(offsets[1], 4, 3), ElementsAre(-1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0));
}

TEST_F(MeshReaderTest, PosesOfSharedVerticesHaveTargetZero)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", makeGrid(1, 1), {true, false});
    mesh->createPose(0)->addVertex(1, Ogre::Vector3(1, 2, 3));
    const MeshData data = read(*mesh);
    ASSERT_EQ(data.view().vertexBuffers[0].offsets.size(), 1u);
    EXPECT_THAT(allOf(data.view().vertexBuffers[0].offsets[0], 4, 3), ElementsAre(0, 0, 0, 1, 2, 3, 0, 0, 0, 0, 0, 0));
}

TEST_F(MeshReaderTest, APoseThatMovesNoVertexIsRefused)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", makeGrid(1, 1));
    mesh->createPose(1, "smile")->addVertex(4, Ogre::Vector3(1, 2, 3));
    const auto data = MeshReader::read(*mesh);
    ASSERT_FALSE(data);
    EXPECT_EQ(data.error().code, ErrorCode::IndexOutOfRange);
    EXPECT_EQ(data.error().item, 4);
}

/// Adds a morph frame; `vertex` is the number of floats of each.
void addMorphFrame(Ogre::VertexAnimationTrack& track, Ogre::Real time, const std::vector<float>& floats,
                   std::size_t vertex)
{
    auto buffer = Ogre::HardwareBufferManager::getSingleton().createVertexBuffer(
        vertex * sizeof(float), floats.size() / vertex, Ogre::HardwareBuffer::HBU_STATIC);
    buffer->writeData(0, floats.size() * sizeof(float), floats.data());
    track.createVertexMorphKeyFrame(time)->setVertexBuffer(buffer);
}

TEST_F(MeshReaderTest, MorphFramesAreOffsetsFromRest)
{
    const TestMesh source = makeTetrahedron();
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", source);
    auto* track = mesh->createAnimation("morph", 2)->createVertexTrack(1, Ogre::VAT_MORPH);
    std::vector<float> moved = source.buffers[0].positions;
    moved[4] += 0.5f;
    addMorphFrame(*track, 0, source.buffers[0].positions, 3);
    addMorphFrame(*track, 1, moved, 3);
    std::vector<float> withNormals;
    for (std::size_t vertex = 0; vertex < 4; ++vertex) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            withNormals.push_back(source.buffers[0].positions[3 * vertex + axis] + 1.0f);
        withNormals.insert(withNormals.end(), {0.0f, 0.0f, 1.0f});
    }
    addMorphFrame(*track, 2, withNormals, 6);

    const MeshData data = read(*mesh);
    const auto& offsets = data.view().vertexBuffers[0].offsets;
    ASSERT_EQ(offsets.size(), 2u) << "the frame at rest moves nothing";
    EXPECT_THAT(allOf(offsets[0], 4, 3), ElementsAre(0, 0, 0, 0, FloatEq(0.5f), 0, 0, 0, 0, 0, 0, 0));
    for (const float offset : allOf(offsets[1], 4, 3))
        EXPECT_NEAR(offset, 1.0f, 1e-6f);
}

TEST_F(MeshReaderTest, AMorphFrameThatIsTooShortIsRefused)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", makeTetrahedron());
    auto* track = mesh->createAnimation("morph", 1)->createVertexTrack(1, Ogre::VAT_MORPH);
    addMorphFrame(*track, 0, std::vector<float>(9, 0.0f), 3);
    EXPECT_EQ(refusal(*mesh), ErrorCode::InvalidGeometry);
}

TEST_F(MeshReaderTest, LevelsThatAreThereDoNotMatter)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", makeGrid(4, 4));
    mesh->_setLodInfo(2);
    mesh->_setSubMeshLodFaceList(0, 1, makeIndexData({0, 1, 2}));
    const MeshData data = read(*mesh);
    EXPECT_EQ(data.view().subMeshes[0].indexCount, 96u);
}

} // namespace
} // namespace lodsmith::test
