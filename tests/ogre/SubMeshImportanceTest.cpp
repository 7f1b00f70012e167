#include <support/OgreMeshBuilder.h>
#include <support/OgreSession.h>

#include <lodsmith/core/Assert.h>
#include <lodsmith/ogre/MeshReader.h>
#include <lodsmith/ogre/ProgressiveMeshGenerator.h>

#include <OgreSubMesh.h>

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

namespace lodsmith::test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

class SubMeshImportanceTest : public testing::Test {
protected:
    static MeshData read(const Ogre::MeshPtr& mesh, const std::vector<float>& importance)
    {
        auto data = MeshReader::read(*mesh, importance);
        EXPECT_TRUE(data) << describe(data.error());
        return std::move(data).value();
    }

    static LodConfig halved(const Ogre::MeshPtr& mesh, const std::vector<float>& importance)
    {
        LodConfig config;
        config.mesh = mesh;
        config.levels.push_back({10, {LevelTarget::Kind::Proportional, 0.5}, {}});
        config.subMeshImportance = importance;
        return config;
    }

    /// Triangles that level 1 leaves of each submesh.
    static std::vector<std::size_t> halve(const Ogre::MeshPtr& mesh, const std::vector<float>& importance)
    {
        const auto report = ProgressiveMeshGenerator().generateLodLevels(halved(mesh, importance));
        EXPECT_TRUE(report) << describe(report.error());
        EXPECT_THAT(brokenLevels(*mesh), IsEmpty());
        std::vector<std::size_t> triangles;
        for (const Ogre::SubMesh* subMesh : mesh->getSubMeshes())
            triangles.push_back(subMesh->mLodFaceList[0]->indexCount / 3);
        return triangles;
    }

    OgreSession mSession;
};

std::set<std::uint32_t> verticesOf(const SubMeshView& subMesh)
{
    std::set<std::uint32_t> vertices;
    for (std::uint32_t i = 0; i < subMesh.indexCount; ++i)
        vertices.insert(subMesh.index(i));
    return vertices;
}

TEST_F(SubMeshImportanceTest, InSharedVerticesTheGreatestCounts)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", makeTwoMaterials(6, true), {true, false});
    for (const std::vector<float>& importance : {std::vector<float>{0.25f, 0.5f}, {0.5f, 0.25f}, {0.0f, 0.75f}}) {
        const MeshData data = read(mesh, importance);
        ASSERT_EQ(data.view().vertexBuffers.size(), 1u);
        const FloatStream& stream = data.view().vertexBuffers[0].importance;
        ASSERT_TRUE(stream);
        const std::set<std::uint32_t> parts[2] = {verticesOf(data.view().subMeshes[0]),
                                                  verticesOf(data.view().subMeshes[1])};
        std::size_t onBoth = 0;
        for (std::uint32_t vertex = 0; vertex < data.view().vertexBuffers[0].vertexCount; ++vertex) {
            const float first = parts[0].count(vertex) > 0 ? importance[0] : 0.0f;
            const float second = parts[1].count(vertex) > 0 ? importance[1] : 0.0f;
            onBoth += parts[0].count(vertex) * parts[1].count(vertex);
            float given = -1.0f;
            stream.read(vertex, 1, &given);
            EXPECT_EQ(given, std::max(first, second)) << "vertex " << vertex;
        }
        EXPECT_EQ(onBoth, 7u);
    }
}

TEST_F(SubMeshImportanceTest, OnlyBuffersOfImportantSubMeshesHaveIt)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", makeTwoMaterials(6, false));
    const MeshData data = read(mesh, {0.0f, 0.5f});
    ASSERT_EQ(data.view().vertexBuffers.size(), 2u);
    EXPECT_FALSE(data.view().vertexBuffers[0].importance);
    EXPECT_TRUE(data.view().vertexBuffers[1].importance);
    for (const std::vector<float>& none : {std::vector<float>{}, {0.0f}, {0.0f, 0.0f}}) {
        const MeshData plain = read(mesh, none);
        for (const VertexBufferView& buffer : plain.view().vertexBuffers)
            EXPECT_FALSE(buffer.importance);
    }
}

TEST_F(SubMeshImportanceTest, NumbersAreThoseOfTheMeshAlsoBesideSubMeshesLeftAlone)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", joined(makeGrid(2, 2), makeGrid(3, 3)));
    setIndices(*mesh->getSubMesh(0), {0, 1, 4, 5}, Ogre::RenderOperation::OT_LINE_LIST);
    const MeshData data = read(mesh, {0.5f, 0.75f});
    ASSERT_EQ(data.view().vertexBuffers.size(), 1u);
    float first = 0.0f;
    data.view().vertexBuffers[0].importance.read(0, 1, &first);
    EXPECT_EQ(first, 0.75f);
}

TEST_F(SubMeshImportanceTest, OneLocksASubMeshAndLeavesTheRestToTheOthers)
{
    for (const bool shared : {true, false}) {
        const Ogre::MeshPtr mesh = makeOgreMesh(shared ? "shared" : "own", makeTwoMaterials(12, true), {shared, false});
        const std::size_t whole = mesh->getSubMesh(1)->indexData->indexCount / 3;
        const std::vector<std::size_t> triangles = halve(mesh, {0.0f, 1.0f});
        EXPECT_EQ(triangles[1], whole);
        EXPECT_LT(triangles[0], whole / 2) << "the target is the mesh's";
    }
}

TEST_F(SubMeshImportanceTest, TheMoreImportantOfTwoLikeSubMeshesKeepsMore)
{
    const TestMesh source = joined(makeTerrain(16), translated(makeTerrain(16), 3.0, 0.0, 0.0));
    const std::vector<std::size_t> alike = halve(makeOgreMesh("alike", source), {});
    const std::vector<std::size_t> first = halve(makeOgreMesh("first", source), {0.9f});
    const std::vector<std::size_t> second = halve(makeOgreMesh("second", source), {0.0f, 0.9f});
    EXPECT_GT(first[0], alike[0]);
    EXPECT_LT(first[1], alike[1]);
    EXPECT_GT(second[1], alike[1]);
    EXPECT_LT(second[0], alike[0]);
}

TEST_F(SubMeshImportanceTest, WrongImportancesAreRefused)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", makeTwoMaterials(6, true), {true, false});
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const float wrong : {-0.1f, 1.5f, nan}) {
        const auto report = ProgressiveMeshGenerator().generateLodLevels(halved(mesh, {0.0f, wrong}));
        ASSERT_FALSE(report);
        EXPECT_EQ(report.error().code, ErrorCode::InvalidSetting);
        EXPECT_THAT(report.error().message, HasSubstr("submesh 1: the importance"));
    }
    const auto tooMany = ProgressiveMeshGenerator().generateLodLevels(halved(mesh, {0.0f, 0.0f, 0.5f}));
    ASSERT_FALSE(tooMany);
    EXPECT_EQ(tooMany.error().code, ErrorCode::InvalidSetting);
    EXPECT_EQ(mesh->getNumLodLevels(), 1);

    const AssertHandler before =
        setAssertHandler([](const char*, const char* message, const char*, int) { throw std::logic_error(message); });
    EXPECT_THROW((void)MeshReader::read(*mesh, {nan}), std::logic_error);
    setAssertHandler(before);
}

} // namespace
} // namespace lodsmith::test
