#include <support/OgreMeshBuilder.h>
#include <support/OgreSession.h>

#include <lodsmith/ogre/LevelReader.h>
#include <lodsmith/ogre/ProgressiveMeshGenerator.h>

#include <OgreMeshManager.h>
#include <OgreSubMesh.h>

#include <gmock/gmock.h>

#include <fstream>
#include <utility>

namespace lodsmith::test {
namespace {

using Ogre::RenderOperation;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

using LevelZero = std::shared_ptr<const MeshData>;

std::vector<std::uint32_t> indicesOf(const SubMeshView& subMesh)
{
    std::vector<std::uint32_t> indices;
    for (std::uint32_t i = 0; i < subMesh.indexCount; ++i)
        indices.push_back(subMesh.index(i));
    return indices;
}

LevelZero levelZeroOf(const Ogre::MeshPtr& mesh)
{
    return LevelReader::readLevelZero(*mesh).value();
}

LevelData read(const Ogre::MeshPtr& mesh, unsigned level)
{
    return LevelReader::read(*mesh, levelZeroOf(mesh), level).value();
}

Error errorOf(const Ogre::MeshPtr& mesh, unsigned level)
{
    return LevelReader::read(*mesh, levelZeroOf(mesh), level).error();
}

/// Replaces a level of a submesh by hand; null for none at all.
void setLevel(const Ogre::MeshPtr& mesh, unsigned short subMesh, unsigned short level, Ogre::IndexData* data)
{
    Ogre::IndexData*& place = mesh->getSubMesh(subMesh)->mLodFaceList[level - 1u];
    OGRE_DELETE std::exchange(place, data);
}

class LevelReaderTest : public testing::Test {
protected:
    static Ogre::MeshPtr withLevels(const std::string& name, const TestMesh& source,
                                    const OgreMeshOptions& options = {})
    {
        const Ogre::MeshPtr mesh = makeOgreMesh(name, source, options);
        EXPECT_TRUE(ProgressiveMeshGenerator().generateLodLevels(proportional(mesh, {0.5, 0.8})));
        return mesh;
    }

    OgreSession mSession;
};

TEST_F(LevelReaderTest, LevelZeroIsWhatWasRead)
{
    const Ogre::MeshPtr mesh = withLevels("mesh", makeUvSphere(12, 8));
    const LevelZero levelZero = levelZeroOf(mesh);
    const LevelData level = LevelReader::read(*mesh, levelZero, 0).value();
    EXPECT_EQ(level.view().subMeshes[0].indices, levelZero->view().subMeshes[0].indices) << "not copied again";
    EXPECT_EQ(level.view().vertexBuffers[0].positions.data, levelZero->view().vertexBuffers[0].positions.data);
}

TEST_F(LevelReaderTest, GeneratedLevelsAreTheMeshsVerticesWithTheirOwnTriangles)
{
    for (const bool wide : {false, true})
        for (const bool shareBuffers : {false, true}) {
            const Ogre::MeshPtr mesh = makeOgreMesh("mesh", makeTwoMaterials(8, true), {true, wide});
            LodConfig config = proportional(mesh, {0.5, 0.8});
            config.shareIndexBuffers = shareBuffers;
            ASSERT_TRUE(ProgressiveMeshGenerator().generateLodLevels(config));
            const LevelZero levelZero = levelZeroOf(mesh);
            for (const unsigned number : {1u, 2u}) {
                const LevelData level = LevelReader::read(*mesh, levelZero, number).value();
                ASSERT_EQ(level.view().vertexBuffers.size(), 1u);
                EXPECT_EQ(level.view().vertexBuffers[0].positions.data,
                          levelZero->view().vertexBuffers[0].positions.data);
                ASSERT_EQ(level.view().subMeshes.size(), 2u);
                for (const unsigned subMesh : {0u, 1u}) {
                    EXPECT_EQ(indicesOf(level.view().subMeshes[subMesh]),
                              test::indicesOf(*mesh->getSubMesh(subMesh)->mLodFaceList[number - 1]));
                    EXPECT_EQ(level.view().subMeshes[subMesh].indexBytes, wide ? 4 : 2);
                }
            }
            Ogre::MeshManager::getSingleton().remove(mesh);
        }
}

TEST_F(LevelReaderTest, ALevelStandsOnItsOwn)
{
    Ogre::MeshPtr mesh = withLevels("mesh", makeUvSphere(12, 8));
    const std::vector<std::uint32_t> expected = test::indicesOf(*mesh->getSubMesh(0)->mLodFaceList[0]);
    const LevelData level = read(mesh, 1);
    Ogre::MeshManager::getSingleton().remove(mesh);
    mesh.reset();
    EXPECT_EQ(indicesOf(level.view().subMeshes[0]), expected);
    float position[3];
    level.view().vertexBuffers[0].positions.read(expected[0], 3, position);
}

TEST_F(LevelReaderTest, WhatStandsForAnEmptyListIsLeftOut)
{
    const Ogre::MeshPtr mesh = withLevels("mesh", makeTwoMaterials(6, false));
    setLevel(mesh, 1, 1, makeIndexData({4, 4, 4}));
    setLevel(mesh, 1, 2, makeIndexData({}));
    EXPECT_THAT(indicesOf(read(mesh, 1).view().subMeshes[1]), IsEmpty());
    EXPECT_THAT(indicesOf(read(mesh, 2).view().subMeshes[1]), IsEmpty());
    EXPECT_GT(read(mesh, 2).view().subMeshes[0].indexCount, 0u);
}

TEST_F(LevelReaderTest, SubMeshesThatAreLeftAloneAreLeftOut)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", makeTwoMaterials(6, false));
    setIndices(*mesh->getSubMesh(0), {0, 1}, RenderOperation::OT_LINE_LIST);
    ASSERT_TRUE(ProgressiveMeshGenerator().generateLodLevels(proportional(mesh, {0.5})));
    const LevelData level = read(mesh, 1);
    ASSERT_EQ(level.view().subMeshes.size(), 1u);
    EXPECT_EQ(indicesOf(level.view().subMeshes[0]), test::indicesOf(*mesh->getSubMesh(1)->mLodFaceList[0]));
}

TEST_F(LevelReaderTest, StripsAreReadAsTheyAreDrawn)
{
    const Ogre::MeshPtr mesh = withLevels("mesh", makeGrid(2, 2));
    setIndices(*mesh->getSubMesh(0), {0, 1, 3, 4, 6, 7}, RenderOperation::OT_TRIANGLE_STRIP);
    setLevel(mesh, 0, 1, makeIndexData({0, 2, 6, 8}));
    EXPECT_THAT(indicesOf(read(mesh, 1).view().subMeshes[0]), ElementsAre(0, 2, 6, 6, 2, 8));
}

TEST_F(LevelReaderTest, BrokenLevels)
{
    const Ogre::MeshPtr mesh = withLevels("mesh", makeTwoMaterials(6, false));
    const Error none = errorOf(mesh, 3);
    EXPECT_EQ(none.code, ErrorCode::InvalidSetting);
    EXPECT_EQ(none.message, "there is no level 3, the mesh has 3 with level 0");
    EXPECT_EQ(errorOf(mesh, 65537).code, ErrorCode::InvalidSetting) << "beyond what OGRE counts with";

    setLevel(mesh, 1, 2, makeIndexData({0, 1, 900}));
    const Error beyond = errorOf(mesh, 2);
    EXPECT_EQ(beyond.code, ErrorCode::IndexOutOfRange);
    EXPECT_EQ(beyond.file, "mesh");
    EXPECT_EQ(beyond.subMesh, 1);
    EXPECT_EQ(beyond.item, 2);
    EXPECT_THAT(beyond.message, HasSubstr("level 2: index 900"));

    mesh->getSubMesh(1)->mLodFaceList[1]->indexCount = 6;
    EXPECT_EQ(errorOf(mesh, 2).code, ErrorCode::IndexOutOfRange);

    setLevel(mesh, 1, 2, nullptr);
    EXPECT_EQ(errorOf(mesh, 2).message, "level 2 is missing");
    setLevel(mesh, 1, 2, makeIndexData({0, 1, 2}));
}

TEST_F(LevelReaderTest, AMeshThatHasOtherSubMeshesThanItHad)
{
    const Ogre::MeshPtr mesh = withLevels("mesh", makeTwoMaterials(6, false));
    const LevelZero before = levelZeroOf(mesh);
    mesh->destroySubMesh(1);
    EXPECT_EQ(LevelReader::read(*mesh, before, 1).error().code, ErrorCode::InvalidGeometry);
}

class HandMadeLevelReaderTest : public LevelReaderTest {
protected:
    Ogre::MeshPtr withHandMadeLevel(const std::string& name)
    {
        const Ogre::MeshPtr mesh = mSession.saveAndReload(makeOgreMesh("source", makeGrid(6, 6)));
        setHandMadeLevel(*mesh, name);
        return mesh;
    }
};

TEST_F(HandMadeLevelReaderTest, IsTheOtherMesh)
{
    const Ogre::MeshPtr other = mSession.saveAndReload(makeOgreMesh("other", makeCube()));
    const Ogre::MeshPtr mesh = withHandMadeLevel(other->getName());
    other->unload();
    const LevelData level = read(mesh, 1);
    EXPECT_EQ(level.view().vertexBuffers[0].vertexCount, 24u);
    EXPECT_EQ(indicesOf(level.view().subMeshes[0]), makeCube().subMeshes[0].indices);
}

TEST_F(HandMadeLevelReaderTest, ThatIsNotThere)
{
    const Error error = errorOf(withHandMadeLevel("nowhere.mesh"), 1);
    EXPECT_EQ(error.code, ErrorCode::NotFound);
    EXPECT_THAT(error.message, HasSubstr("nowhere.mesh"));
}

TEST_F(HandMadeLevelReaderTest, ThatIsNoMesh)
{
    std::ofstream(mSession.directory() / "text.mesh") << "hello, this is no mesh at all";
    const Ogre::MeshPtr mesh = withHandMadeLevel("text.mesh");
    const Error error = errorOf(mesh, 1);
    EXPECT_TRUE(error.code == ErrorCode::NotFound || error.code == ErrorCode::Unsupported) << describe(error);
}

} // namespace
} // namespace lodsmith::test
