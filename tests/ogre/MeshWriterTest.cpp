#include <support/OgreMeshBuilder.h>
#include <support/OgreSession.h>

#include <lodsmith/core/Assert.h>
#include <lodsmith/ogre/MeshReader.h>
#include <lodsmith/ogre/MeshWriter.h>

#include <OgreCamera.h>
#include <OgreEdgeListBuilder.h>
#include <OgreEntity.h>
#include <OgreHardwareBufferManager.h>
#include <OgreLodStrategy.h>
#include <OgreMeshManager.h>
#include <OgreMeshSerializer.h>
#include <OgreRoot.h>
#include <OgreSceneManager.h>
#include <OgreSceneNode.h>
#include <OgreStaticGeometry.h>
#include <OgreSubEntity.h>
#include <OgreSubMesh.h>

#include <gmock/gmock.h>

#include <set>
#include <stdexcept>

namespace lodsmith::test {
namespace {

using Ogre::RenderOperation;
using testing::ElementsAre;
using testing::IsEmpty;

LodConfig distances(const Ogre::MeshPtr& mesh, const std::vector<Ogre::Real>& values)
{
    LodConfig config;
    config.mesh = mesh;
    for (const Ogre::Real value : values)
        config.levels.push_back({value, {}, {}});
    return config;
}

const Ogre::IndexData& faces(const Ogre::MeshPtr& mesh, std::size_t subMesh, std::size_t level)
{
    return *mesh->getSubMesh(subMesh)->mLodFaceList[level - 1];
}

Ogre::RenderOperation drawn(const Ogre::MeshPtr& mesh, std::size_t subMesh, unsigned short level)
{
    Ogre::RenderOperation operation;
    mesh->getSubMesh(subMesh)->_getRenderOperation(operation, level);
    return operation;
}

class MeshWriterTest : public testing::Test {
protected:
    /// Reads the mesh, keeps `shares` of its triangles as levels and writes them.
    static void write(LodConfig config, const std::vector<double>& shares)
    {
        const auto data = MeshReader::read(*config.mesh);
        ASSERT_TRUE(data) << describe(data.error());
        const auto written = MeshWriter::write(config, data.value(), shortenedChain(data.value().view(), shares));
        ASSERT_TRUE(written) << describe(written.error());
        EXPECT_THAT(brokenLevels(*config.mesh), IsEmpty());
    }

    /// After a write with two levels of half and a quarter: the same from a file.
    void expectSameAfterReload(const Ogre::MeshPtr& mesh)
    {
        const Ogre::MeshPtr reloaded = mSession.saveAndReload(mesh);
        ASSERT_EQ(reloaded->getNumLodLevels(), mesh->getNumLodLevels());
        EXPECT_EQ(reloaded->getLodStrategy(), mesh->getLodStrategy());
        EXPECT_THAT(brokenLevels(*reloaded), IsEmpty());
        for (unsigned short level = 1; level < mesh->getNumLodLevels(); ++level) {
            EXPECT_EQ(reloaded->getLodLevel(level).userValue, mesh->getLodLevel(level).userValue);
            EXPECT_EQ(reloaded->getLodLevel(level).value, mesh->getLodLevel(level).value);
            EXPECT_EQ(reloaded->getLodLevel(level).manualName, mesh->getLodLevel(level).manualName);
            for (std::size_t i = 0; i < mesh->getNumSubMeshes() && !mesh->_isManualLodLevel(level); ++i)
                EXPECT_EQ(indicesOf(faces(reloaded, i, level)), indicesOf(faces(mesh, i, level)));
        }
    }

    OgreSession mSession;
};

TEST_F(MeshWriterTest, LevelsHoldTheChainsTriangles)
{
    const TestMesh source = makeGrid(8, 8);
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", source);
    write(distances(mesh, {10, 20}), {0.5, 0.25});
    ASSERT_EQ(mesh->getNumLodLevels(), 3);
    const auto& all = source.subMeshes[0].indices;
    EXPECT_EQ(indicesOf(faces(mesh, 0, 1)), std::vector<std::uint32_t>(all.begin(), all.begin() + 192));
    EXPECT_EQ(indicesOf(faces(mesh, 0, 2)), std::vector<std::uint32_t>(all.begin(), all.begin() + 96));
    EXPECT_EQ(indicesOf(*mesh->getSubMesh(0)->indexData), all) << "level 0 stays";
    expectSameAfterReload(mesh);
}

TEST_F(MeshWriterTest, UserValuesAreKeptAndTransformed)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", makeGrid(8, 8));
    write(distances(mesh, {10, 20}), {0.5, 0.25});
    EXPECT_EQ(mesh->getLodLevel(1).userValue, 10);
    EXPECT_EQ(mesh->getLodLevel(1).value, 100) << "OGRE compares squared distances";
    EXPECT_EQ(mesh->getLodLevel(2).value, 400);
    EXPECT_EQ(mesh->getLodLevel(1).edgeData, nullptr);
}

TEST_F(MeshWriterTest, PixelCountsStartFromTheStrategysBase)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", makeGrid(8, 8));
    LodConfig config = distances(mesh, {1000, 100});
    config.strategy = "pixel_count";
    write(config, {0.5, 0.25});
    EXPECT_EQ(mesh->getLodStrategy()->getName(), "pixel_count");
    EXPECT_EQ(mesh->getLodIndex(5000), 0);
    EXPECT_EQ(mesh->getLodIndex(500), 1);
    EXPECT_EQ(mesh->getLodIndex(50), 2);
    expectSameAfterReload(mesh);
}

TEST_F(MeshWriterTest, IndexWidthFollowsTheSourceNotTheVertexCount)
{
    for (const bool wide : {false, true}) {
        const Ogre::MeshPtr mesh = makeOgreMesh(wide ? "wide" : "narrow", makeGrid(8, 8), {false, wide});
        write(distances(mesh, {10}), {0.5});
        EXPECT_EQ(faces(mesh, 0, 1).indexBuffer->getIndexSize(), wide ? 4u : 2u);
        EXPECT_EQ(faces(mesh, 0, 1).indexBuffer->getNumIndexes(), 192u);
        expectSameAfterReload(mesh);
    }
}

TEST_F(MeshWriterTest, IndicesBeyondSixteenBitsSurvive)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", makeGrid(300, 300), {false, true});
    ASSERT_GT(mesh->getSubMesh(0)->vertexData->vertexCount, 65536u);
    auto data = MeshReader::read(*mesh);
    ASSERT_TRUE(data);
    LodChain chain = shortenedChain(data.value().view(), {0.0});
    chain.levels[0].indices[0] = {90000, 90001, 90302};
    ASSERT_TRUE(MeshWriter::write(distances(mesh, {10}), data.value(), chain));
    EXPECT_THAT(indicesOf(faces(mesh, 0, 1)), ElementsAre(90000, 90001, 90302));
}

TEST_F(MeshWriterTest, UsageAndShadowBufferFollowTheSource)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", makeGrid(8, 8));
    Ogre::IndexData& whole = *mesh->getSubMesh(0)->indexData;
    const auto indices = indicesOf(whole);
    for (const auto usage :
         {Ogre::HardwareBuffer::HBU_STATIC, Ogre::HardwareBuffer::HBU_DYNAMIC,
          Ogre::HardwareBuffer::HBU_DYNAMIC_WRITE_ONLY, Ogre::HardwareBuffer::HBU_STATIC_WRITE_ONLY}) {
        auto buffer = Ogre::HardwareBufferManager::getSingleton().createIndexBuffer(Ogre::HardwareIndexBuffer::IT_32BIT,
                                                                                    indices.size(), usage, true);
        buffer->writeData(0, buffer->getSizeInBytes(), indices.data());
        whole.indexBuffer = buffer;
        write(distances(mesh, {10}), {0.5});
        EXPECT_EQ(faces(mesh, 0, 1).indexBuffer->getUsage(), buffer->getUsage());
        EXPECT_EQ(faces(mesh, 0, 1).indexBuffer->hasShadowBuffer(), buffer->hasShadowBuffer());
    }
}

TEST_F(MeshWriterTest, ASubMeshReducedToNothingDrawsOnePoint)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", joined(makeGrid(8, 8), makeTetrahedron()));
    for (const bool share : {false, true}) {
        LodConfig config = distances(mesh, {10, 20});
        config.shareIndexBuffers = share;
        write(config, {0.25, 0.2});
        EXPECT_EQ(indicesOf(faces(mesh, 1, 1)).size(), 3u) << "one of four triangles";
        EXPECT_THAT(indicesOf(faces(mesh, 1, 2)), ElementsAre(0, 0, 0));
        expectSameAfterReload(mesh);
    }
    mesh->buildEdgeList();
    EXPECT_FALSE(mesh->getEdgeList(2)->triangles.empty());
}

TEST_F(MeshWriterTest, SkippedLevelsAreLeftOut)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", makeGrid(8, 8));
    const auto data = MeshReader::read(*mesh);
    ASSERT_TRUE(data);
    LodChain chain = shortenedChain(data.value().view(), {0.5, 0.5, 0.25});
    chain.levels[1].skipped = true;
    chain.levels[1].indices.clear();
    ASSERT_TRUE(MeshWriter::write(distances(mesh, {10, 20, 30}), data.value(), chain));
    EXPECT_THAT(brokenLevels(*mesh), IsEmpty());
    ASSERT_EQ(mesh->getNumLodLevels(), 3);
    EXPECT_EQ(mesh->getLodLevel(1).userValue, 10);
    EXPECT_EQ(mesh->getLodLevel(2).userValue, 30);
}

TEST_F(MeshWriterTest, LevelsThatAreThereAreReplaced)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", makeGrid(8, 8));
    LodConfig pixels = distances(mesh, {1000, 100, 10});
    pixels.strategy = "pixel_count";
    write(pixels, {0.5, 0.25, 0.125});
    const Ogre::MeshPtr reloaded = mSession.saveAndReload(mesh);
    write(distances(reloaded, {10}), {0.5});
    EXPECT_EQ(reloaded->getNumLodLevels(), 2);
    EXPECT_EQ(reloaded->getLodStrategy()->getName(), "distance_sphere");
    EXPECT_EQ(reloaded->getLodIndex(99), 0);
    EXPECT_EQ(reloaded->getLodIndex(101), 1);
    write(distances(reloaded, {}), {});
    EXPECT_EQ(reloaded->getNumLodLevels(), 1);
    expectSameAfterReload(reloaded);
}

TEST_F(MeshWriterTest, RemovedLevelsLeaveTheMeshWhole)
{
    const TestMesh source = makeGrid(8, 8);
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", source);
    write(distances(mesh, {10, 20}), {0.5, 0.25});
    mesh->buildEdgeList();
    MeshWriter::removeLevels(*mesh);
    EXPECT_EQ(mesh->getNumLodLevels(), 1);
    EXPECT_THAT(brokenLevels(*mesh), IsEmpty());
    EXPECT_EQ(indicesOf(*mesh->getSubMesh(0)->indexData), source.subMeshes[0].indices);
    EXPECT_EQ(mSession.saveAndReload(mesh)->getNumLodLevels(), 1);
}

TEST_F(MeshWriterTest, StripsAndFansBecomeListsAtEveryLevel)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", joined(makeGrid(2, 2), makeGrid(2, 2)));
    setIndices(*mesh->getSubMesh(0), {0, 1, 3, 4, 6, 7}, RenderOperation::OT_TRIANGLE_STRIP, true, 2);
    setIndices(*mesh->getSubMesh(1), {4, 0, 1, 2, 5}, RenderOperation::OT_TRIANGLE_FAN);
    write(distances(mesh, {10}), {0.5});
    for (const std::size_t subMesh : {0u, 1u})
        for (const unsigned short level : {0, 1})
            EXPECT_EQ(drawn(mesh, subMesh, level).operationType, RenderOperation::OT_TRIANGLE_LIST);
    EXPECT_THAT(indicesOf(*mesh->getSubMesh(0)->indexData), ElementsAre(0, 1, 3, 3, 1, 4, 3, 4, 6, 6, 4, 7));
    EXPECT_THAT(indicesOf(*mesh->getSubMesh(1)->indexData), ElementsAre(4, 0, 1, 4, 1, 2, 4, 2, 5));
    EXPECT_EQ(mesh->getSubMesh(0)->indexData->indexBuffer->getIndexSize(), 4u);
    EXPECT_THAT(indicesOf(faces(mesh, 0, 1)), ElementsAre(0, 1, 3, 3, 1, 4));
    expectSameAfterReload(mesh);
}

TEST_F(MeshWriterTest, AStripWithoutGeneratedLevelsStaysAStrip)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", makeGrid(2, 2));
    setIndices(*mesh->getSubMesh(0), {0, 1, 3, 4, 6, 7}, RenderOperation::OT_TRIANGLE_STRIP);
    const Ogre::MeshPtr other = makeOgreMesh("other", makeTetrahedron());
    LodConfig config = distances(mesh, {10});
    config.levels[0].manualMeshName = "other";
    write(config, {});
    EXPECT_EQ(mesh->getSubMesh(0)->operationType, RenderOperation::OT_TRIANGLE_STRIP);
    EXPECT_THAT(indicesOf(*mesh->getSubMesh(0)->indexData), ElementsAre(0, 1, 3, 4, 6, 7));
}

TEST_F(MeshWriterTest, LinesAndPointsDrawTheSameAtEveryLevel)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", joined(makeGrid(4, 4), joined(makeGrid(2, 2), makeGrid(2, 2))));
    setIndices(*mesh->getSubMesh(1), {0, 1, 4, 5}, RenderOperation::OT_LINE_LIST);
    setIndices(*mesh->getSubMesh(2), {0, 1, 4, 5, 7}, RenderOperation::OT_POINT_LIST, true);
    write(distances(mesh, {10, 20}), {0.5, 0.25});
    for (const std::size_t subMesh : {1u, 2u})
        for (const unsigned short level : {1, 2})
            EXPECT_EQ(indicesOf(*drawn(mesh, subMesh, level).indexData),
                      indicesOf(*mesh->getSubMesh(subMesh)->indexData));
    expectSameAfterReload(mesh);
}

TEST_F(MeshWriterTest, SubMeshesWithoutIndicesDrawTheirVerticesAtEveryLevel)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", joined(makeGrid(4, 4), makeGrid(1, 1)));
    setIndices(*mesh->getSubMesh(1), {}, RenderOperation::OT_POINT_LIST);
    write(distances(mesh, {10, 20}), {0.5, 0.25});
    for (const unsigned short level : {0, 1, 2}) {
        EXPECT_FALSE(drawn(mesh, 1, level).useIndexes);
        EXPECT_EQ(drawn(mesh, 1, level).vertexData->vertexCount, 4u);
    }
    expectSameAfterReload(mesh);
    const Ogre::MeshPtr reloaded = mSession.saveAndReload(mesh);
    EXPECT_FALSE(drawn(reloaded, 1, 2).useIndexes);
}

TEST_F(MeshWriterTest, AMeshOfLinesAloneGetsNoLevels)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", makeGrid(2, 2));
    setIndices(*mesh->getSubMesh(0), {0, 1, 4, 5}, RenderOperation::OT_LINE_LIST);
    const auto data = MeshReader::read(*mesh);
    ASSERT_TRUE(data);
    LodChain chain;
    chain.levels.resize(1);
    chain.levels[0].skipped = true;
    ASSERT_TRUE(MeshWriter::write(distances(mesh, {10}), data.value(), chain));
    EXPECT_EQ(mesh->getNumLodLevels(), 1);
}

TEST_F(MeshWriterTest, NeighboursShareABufferWhenAsked)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", joined(makeGrid(8, 8), makeGrid(4, 4)));
    write(distances(mesh, {10, 20, 30}), {0.5, 0.25, 0.125});
    std::vector<std::vector<std::uint32_t>> apart;
    for (const std::size_t level : {1u, 2u, 3u})
        apart.push_back(indicesOf(faces(mesh, 0, level)));
    EXPECT_NE(faces(mesh, 0, 1).indexBuffer, faces(mesh, 0, 2).indexBuffer);

    LodConfig config = distances(mesh, {10, 20, 30});
    config.shareIndexBuffers = true;
    write(config, {0.5, 0.25, 0.125});
    EXPECT_EQ(faces(mesh, 0, 1).indexBuffer, faces(mesh, 0, 2).indexBuffer);
    EXPECT_NE(faces(mesh, 0, 2).indexBuffer, faces(mesh, 0, 3).indexBuffer);
    EXPECT_NE(faces(mesh, 0, 1).indexBuffer, faces(mesh, 1, 1).indexBuffer);
    EXPECT_EQ(faces(mesh, 0, 2).indexStart, 192u);
    for (const std::size_t level : {1u, 2u, 3u})
        EXPECT_EQ(indicesOf(faces(mesh, 0, level)), apart[level - 1]);
    expectSameAfterReload(mesh);
    const Ogre::MeshPtr reloaded = mSession.saveAndReload(mesh);
    EXPECT_EQ(faces(reloaded, 0, 1).indexBuffer, faces(reloaded, 0, 2).indexBuffer);
}

TEST_F(MeshWriterTest, ManualAndGeneratedLevelsMix)
{
    const Ogre::MeshPtr other = mSession.saveAndReload(makeOgreMesh("other", makeTetrahedron()));
    const Ogre::MeshPtr mesh = mSession.saveAndReload(makeOgreMesh("mesh", makeGrid(8, 8)));
    LodConfig config = distances(mesh, {10, 20, 30, 40});
    config.levels[1].manualMeshName = config.levels[3].manualMeshName = other->getName();
    config.shareIndexBuffers = true;
    write(config, {0.5, 0.25});
    ASSERT_EQ(mesh->getNumLodLevels(), 5);
    for (const unsigned short level : {1, 2, 3, 4}) {
        EXPECT_EQ(mesh->_isManualLodLevel(level), level % 2 == 0);
        EXPECT_EQ(mesh->getLodLevel(level).userValue, 10 * level);
    }
    EXPECT_EQ(mesh->getLodLevel(2).manualMesh, other);
    EXPECT_EQ(indicesOf(faces(mesh, 0, 3)).size(), 96u);
    expectSameAfterReload(mesh);
    const Ogre::MeshPtr reloaded = mSession.saveAndReload(mesh);
    EXPECT_EQ(reloaded->getLodLevel(2).manualMesh, other);
    EXPECT_EQ(mesh->clone("clone")->getNumLodLevels(), 5);
}

TEST_F(MeshWriterTest, EdgeListsAreThereAgainAtEveryLevel)
{
    const TestMesh source = makeTwoMaterials(8, true);
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", source, {true, false});
    mesh->setAutoBuildEdgeLists(false);
    mesh->prepareForShadowVolume();
    mesh->buildEdgeList();
    write(distances(mesh, {10, 20}), {0.5, 0.25});
    EXPECT_FALSE(mesh->isEdgeListBuilt());
    for (const unsigned short level : {0, 1, 2}) {
        ASSERT_NE(mesh->getEdgeList(level), nullptr);
        EXPECT_EQ(mesh->getEdgeList(level)->triangles.size(), source.triangleCount() >> level);
    }
}

TEST_F(MeshWriterTest, WithoutEdgeListsNoneAreAskedFor)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", makeGrid(8, 8));
    mesh->setAutoBuildEdgeLists(false);
    write(distances(mesh, {10}), {0.5});
    EXPECT_EQ(mesh->getEdgeList(1), nullptr);
}

TEST_F(MeshWriterTest, OgreDrawsClonesAndBakesTheLevels)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", joined(makeGrid(8, 8), makeGrid(4, 4)));
    write(distances(mesh, {10, 20}), {0.5, 0.25});
    const Ogre::MeshPtr clone = mesh->clone("clone");
    EXPECT_THAT(brokenLevels(*clone), IsEmpty());
    EXPECT_EQ(indicesOf(faces(clone, 1, 2)), indicesOf(faces(mesh, 1, 2)));

    Ogre::SceneManager* scene = Ogre::Root::getSingleton().createSceneManager();
    Ogre::StaticGeometry* geometry = scene->createStaticGeometry("static");
    geometry->addEntity(scene->createEntity(mesh), Ogre::Vector3::ZERO);
    EXPECT_NO_THROW(geometry->build());
}

class EntityLevelTest : public MeshWriterTest {
protected:
    EntityLevelTest()
    {
        mScene = Ogre::Root::getSingleton().createSceneManager();
        mCamera = mScene->createCamera("camera");
        mCameraNode = mScene->getRootSceneNode()->createChildSceneNode();
        mCameraNode->attachObject(mCamera);
        mEntity = mScene->createEntity(mMesh);
        mScene->getRootSceneNode()->createChildSceneNode()->attachObject(mEntity);
    }

    /// Moves the camera away and returns the indices that the entity would draw.
    std::size_t drawnFrom(Ogre::Real distance)
    {
        mCameraNode->setPosition(0, 0, distance);
        mScene->getRootSceneNode()->_update(true, false);
        mEntity->_notifyCurrentCamera(mCamera);
        return drawnNow();
    }

    std::size_t drawnNow()
    {
        Ogre::RenderOperation operation;
        mEntity->getSubEntity(0)->getRenderOperation(operation);
        return operation.indexData->indexCount;
    }

    Ogre::MeshPtr mMesh = makeOgreMesh("mesh", makeGrid(8, 8));
    Ogre::SceneManager* mScene;
    Ogre::Camera* mCamera;
    Ogre::SceneNode* mCameraNode;
    Ogre::Entity* mEntity;
};

TEST_F(EntityLevelTest, LivingEntitiesSeeGeneratedLevels)
{
    EXPECT_EQ(drawnFrom(1000), 384u);
    write(distances(mMesh, {10, 100}), {0.5, 0.25});
    EXPECT_EQ(drawnFrom(5), 384u);
    EXPECT_EQ(drawnFrom(50), 192u);
    EXPECT_EQ(drawnFrom(1000), 96u);
}

TEST_F(EntityLevelTest, EntitiesAtALevelThatGoesFallBack)
{
    write(distances(mMesh, {10, 20, 30}), {0.5, 0.25, 0.125});
    EXPECT_EQ(drawnFrom(1000), 48u);
    write(distances(mMesh, {10}), {0.5});
    EXPECT_EQ(drawnNow(), 384u) << "the index that the entity still holds names no level";
    EXPECT_EQ(drawnFrom(1000), 192u);
    MeshWriter::removeLevels(*mMesh);
    EXPECT_EQ(drawnNow(), 384u);
    EXPECT_EQ(drawnFrom(1000), 384u);
}

TEST_F(EntityLevelTest, LaterEntitiesShowManualLevels)
{
    mScene->destroyEntity(mEntity);
    const Ogre::MeshPtr other = makeOgreMesh("other", makeTetrahedron());
    LodConfig config = distances(mMesh, {10, 20});
    config.levels[0].manualMeshName = "other";
    write(config, {0.25});
    mEntity = mScene->createEntity(mMesh);
    mScene->getRootSceneNode()->createChildSceneNode()->attachObject(mEntity);
    ASSERT_EQ(mEntity->getNumManualLodLevels(), 2u);
    EXPECT_EQ(mEntity->getManualLodLevel(0)->getMesh(), other);
    EXPECT_EQ(mEntity->getManualLodLevel(1), mEntity);
    EXPECT_EQ(drawnFrom(1000), 96u);
}

/// Writing must be refused, and leave the mesh as it was.
TEST_F(MeshWriterTest, AMeshThatHasChangedIsRefused)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", makeGrid(8, 8));
    const auto data = MeshReader::read(*mesh);
    ASSERT_TRUE(data);
    const LodChain chain = shortenedChain(data.value().view(), {0.5});
    const auto refused = [&] {
        const auto written = MeshWriter::write(distances(mesh, {10}), data.value(), chain);
        return !written && written.error().code == ErrorCode::InvalidGeometry && mesh->getNumLodLevels() == 1;
    };
    Ogre::SubMesh& subMesh = *mesh->getSubMesh(0);
    --subMesh.vertexData->vertexCount;
    EXPECT_TRUE(refused());
    ++subMesh.vertexData->vertexCount;
    setIndices(subMesh, {0, 1, 2}, RenderOperation::OT_TRIANGLE_LIST, true);
    EXPECT_TRUE(refused()) << "another index width";
    setIndices(subMesh, {0, 1, 2}, RenderOperation::OT_TRIANGLE_LIST, false);
    EXPECT_FALSE(refused());
    MeshWriter::removeLevels(*mesh);
    mesh->createSubMesh();
    EXPECT_TRUE(refused());
    mesh->unload();
    EXPECT_TRUE(refused());
}

void throwMessage(const char*, const char* message, const char*, int)
{
    throw std::runtime_error(message);
}

TEST_F(MeshWriterTest, AChainOfAnotherMeshIsMisuse)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", makeGrid(8, 8));
    const auto data = MeshReader::read(*mesh);
    ASSERT_TRUE(data);
    const AssertHandler before = setAssertHandler(&throwMessage);
    LodChain chain = shortenedChain(data.value().view(), {0.5});
    EXPECT_THROW((void)MeshWriter::write(distances(mesh, {10, 20}), data.value(), chain), std::runtime_error);
    chain.levels[0].indices[0].back() = 81;
    EXPECT_THROW((void)MeshWriter::write(distances(mesh, {10}), data.value(), chain), std::runtime_error);
    chain.levels[0].indices[0].pop_back();
    EXPECT_THROW((void)MeshWriter::write(distances(mesh, {10}), data.value(), chain), std::runtime_error);
    chain.levels[0].indices.clear();
    EXPECT_THROW((void)MeshWriter::write(distances(mesh, {10}), data.value(), chain), std::runtime_error);
    setAssertHandler(before);
    EXPECT_EQ(mesh->getNumLodLevels(), 1);
}

TEST_F(MeshWriterTest, OlderFileFormatsKeepTheLevels)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", joined(makeGrid(8, 8), makeGrid(4, 4)));
    write(distances(mesh, {10, 20}), {0.5, 0.25});
    for (const auto version : {Ogre::MESH_VERSION_1_10, Ogre::MESH_VERSION_1_8}) {
        const std::string name = "version" + std::to_string(version) + ".mesh";
        Ogre::MeshSerializer().exportMesh(mesh.get(), (mSession.directory() / name).string(), version);
        const Ogre::MeshPtr reloaded = mSession.loadSaved(name);
        ASSERT_EQ(reloaded->getNumLodLevels(), 3) << name;
        for (const std::size_t subMesh : {0u, 1u})
            for (const std::size_t level : {1u, 2u})
                EXPECT_EQ(indicesOf(faces(reloaded, subMesh, level)), indicesOf(faces(mesh, subMesh, level))) << name;
    }
}

} // namespace
} // namespace lodsmith::test
