#include <support/OgreMeshBuilder.h>
#include <support/OgreSession.h>

#include <lodsmith/ogre/MeshReader.h>
#include <lodsmith/ogre/ProgressiveMeshGenerator.h>

#include <OgreLodStrategy.h>
#include <OgreMeshManager.h>
#include <OgreSubMesh.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace lodsmith::test {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

std::size_t trianglesOf(const Ogre::Mesh& mesh, std::size_t level)
{
    std::size_t count = 0;
    for (std::size_t i = 0; i < mesh.getNumSubMeshes(); ++i)
        count += mesh.getSubMesh(i)->mLodFaceList[level - 1]->indexCount / 3;
    return count;
}

class ProgressiveMeshGeneratorTest : public testing::Test {
protected:
    static LodReport generate(const LodConfig& config)
    {
        auto report = ProgressiveMeshGenerator().generateLodLevels(config);
        EXPECT_TRUE(report) << (report ? "" : describe(report.error()));
        EXPECT_THAT(brokenLevels(*config.mesh), IsEmpty());
        return report ? std::move(report).value() : LodReport{};
    }

    OgreSession mSession;
};

TEST_F(ProgressiveMeshGeneratorTest, EveryLevelReachesItsTarget)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", makeUvSphere(40, 30));
    const LodReport report = generate(proportional(mesh, {0.5, 0.75, 0.875, 0.9375}));
    ASSERT_EQ(mesh->getNumLodLevels(), 5);
    ASSERT_EQ(report.levels.size(), 4u);
    EXPECT_EQ(report.bufferVertices, mesh->getSubMesh(0)->vertexData->vertexCount);
    EXPECT_LT(report.vertices, report.bufferVertices) << "the seam is welded";
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(report.levels[i].stop, StopReason::TargetReached);
        EXPECT_NEAR(report.levels[i].vertices, report.vertices / std::pow(2.0, i + 1), 1.0);
        EXPECT_EQ(report.levels[i].triangles, trianglesOf(*mesh, i + 1));
        EXPECT_EQ(report.levels[i].value, 10 * (i + 1));
        EXPECT_GT(report.levels[i].deviation, 0.0);
    }
}

TEST_F(ProgressiveMeshGeneratorTest, TheSameMeshGivesTheSameLevelsHoweverItIsStored)
{
    const TestMesh source = makeTwoMaterials(12, true);
    std::vector<std::vector<std::uint32_t>> first;
    for (const OgreMeshOptions options : {OgreMeshOptions{true, false}, OgreMeshOptions{true, true}}) {
        const Ogre::MeshPtr mesh = makeOgreMesh(options.wideIndices ? "wide" : "narrow", source, options);
        generate(proportional(mesh, {0.5}));
        std::vector<std::vector<std::uint32_t>> lists;
        for (const std::size_t subMesh : {0u, 1u})
            lists.push_back(indicesOf(*mesh->getSubMesh(subMesh)->mLodFaceList[0]));
        if (first.empty())
            first = lists;
        EXPECT_EQ(lists, first);
    }
}

TEST_F(ProgressiveMeshGeneratorTest, AStripGivesTheLevelsOfItsTriangles)
{
    const TestMesh source = makeGrid(12, 1);
    const Ogre::MeshPtr list = makeOgreMesh("list", source);
    const Ogre::MeshPtr strip = makeOgreMesh("strip", source);
    // Lower and upper row of vertices by turns, as the strip of this grid.
    std::vector<std::uint32_t> indices, triangles;
    for (std::uint32_t i = 0; i <= 12; ++i)
        indices.insert(indices.end(), {i + 13, i});
    for (std::uint32_t i = 0; i < 12; ++i)
        triangles.insert(triangles.end(), {i + 13, i, i + 14, i + 14, i, i + 1});
    setIndices(*strip->getSubMesh(0), indices, Ogre::RenderOperation::OT_TRIANGLE_STRIP);
    setIndices(*list->getSubMesh(0), triangles, Ogre::RenderOperation::OT_TRIANGLE_LIST);
    generate(proportional(list, {0.5}));
    const LodReport report = generate(proportional(strip, {0.5}));
    EXPECT_EQ(indicesOf(*strip->getSubMesh(0)->mLodFaceList[0]), indicesOf(*list->getSubMesh(0)->mLodFaceList[0]));
    EXPECT_THAT(report.notes, Contains(HasSubstr("level 0 became a triangle list")));
}

TEST_F(ProgressiveMeshGeneratorTest, LeftAloneSubMeshesAreReported)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", joined(makeGrid(2, 2), makeGrid(12, 12)));
    setIndices(*mesh->getSubMesh(0), {0, 1, 4, 5}, Ogre::RenderOperation::OT_LINE_LIST);
    const LodReport report = generate(proportional(mesh, {0.5}));
    EXPECT_THAT(report.notes, Contains("submesh 0: a line list, left as it is"));
    EXPECT_EQ(report.vertices, 169u) << "only what is simplified counts";
    EXPECT_EQ(mesh->getSubMesh(0)->mLodFaceList[0]->indexCount, 4u);
}

TEST_F(ProgressiveMeshGeneratorTest, OnlyLeftAloneSubMeshesMakeNoLevels)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", makeGrid(2, 2));
    setIndices(*mesh->getSubMesh(0), {0, 1, 4, 5}, Ogre::RenderOperation::OT_LINE_LIST);
    const LodReport report = generate(proportional(mesh, {0.5}));
    EXPECT_EQ(mesh->getNumLodLevels(), 1);
    ASSERT_EQ(report.levels.size(), 1u);
    EXPECT_TRUE(report.levels[0].skipped);
}

TEST_F(ProgressiveMeshGeneratorTest, ConstantTargetsBeyondTheMeshLeaveAWholeMesh)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", makeUvSphere(12, 8));
    LodConfig config = proportional(mesh, {0.5});
    config.levels[0].target = {LevelTarget::Kind::Constant, 1e9};
    generate(config);
    EXPECT_EQ(mesh->getNumLodLevels(), 2);
}

TEST_F(ProgressiveMeshGeneratorTest, ALevelWithoutChangeIsSkipped)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", makeUvSphere(20, 12));
    const LodReport report = generate(proportional(mesh, {0.5, 0.5, 0.75}));
    EXPECT_TRUE(report.levels[1].skipped);
    ASSERT_EQ(mesh->getNumLodLevels(), 3);
    EXPECT_EQ(mesh->getLodLevel(2).userValue, 30);
}

TEST_F(ProgressiveMeshGeneratorTest, ManualLevelsTakeNoPartInTheReduction)
{
    const Ogre::MeshPtr other = makeOgreMesh("other", makeTetrahedron());
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", makeUvSphere(20, 12));
    LodConfig config = proportional(mesh, {0.5, 0.99, 0.75});
    config.levels[1].manualMeshName = "other";
    const LodReport report = generate(config);
    ASSERT_EQ(mesh->getNumLodLevels(), 4);
    EXPECT_TRUE(report.levels[1].manual);
    EXPECT_NEAR(report.levels[2].vertices, report.vertices * 0.25, 1.0);
    EXPECT_EQ(trianglesOf(*mesh, 3), report.levels[2].triangles);
}

TEST_F(ProgressiveMeshGeneratorTest, WrongTargetsLeaveTheMeshAlone)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", makeUvSphere(20, 12));
    generate(proportional(mesh, {0.5}));
    const auto report = ProgressiveMeshGenerator().generateLodLevels(proportional(mesh, {0.5, 1.5}));
    ASSERT_FALSE(report);
    EXPECT_EQ(report.error().code, ErrorCode::InvalidSetting);
    EXPECT_EQ(report.error().file, "mesh");
    EXPECT_EQ(mesh->getNumLodLevels(), 2);
}

TEST_F(ProgressiveMeshGeneratorTest, BadGeometryNamesTheMeshsOwnSubMesh)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", joined(makeGrid(2, 2), makeGrid(3, 3)));
    setIndices(*mesh->getSubMesh(0), {0, 1}, Ogre::RenderOperation::OT_LINE_LIST);
    const auto& buffer = mesh->getSubMesh(1)->vertexData->vertexBufferBinding->getBuffer(0);
    const float bad = NAN;
    buffer->writeData(5 * buffer->getVertexSize(), sizeof bad, &bad);
    const auto report = ProgressiveMeshGenerator().generateLodLevels(proportional(mesh, {0.5}));
    ASSERT_FALSE(report);
    EXPECT_EQ(report.error().code, ErrorCode::InvalidGeometry);
    EXPECT_EQ(report.error().subMesh, 1);
    EXPECT_EQ(report.error().item, 5);
}

TEST_F(ProgressiveMeshGeneratorTest, ACancelledRunLeavesTheMeshAlone)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", makeUvSphere(20, 12));
    Progress progress;
    progress.cancel();
    const auto report = ProgressiveMeshGenerator().generateLodLevels(proportional(mesh, {0.5}), &progress);
    ASSERT_FALSE(report);
    EXPECT_EQ(report.error().code, ErrorCode::Cancelled);
    EXPECT_EQ(mesh->getNumLodLevels(), 1);
}

TEST_F(ProgressiveMeshGeneratorTest, RepeatedRunsGiveTheSameLevels)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", makeUvSphere(20, 12));
    generate(proportional(mesh, {0.5, 0.75}));
    const auto first = indicesOf(*mesh->getSubMesh(0)->mLodFaceList[1]);
    generate(proportional(mesh, {0.5, 0.75}));
    EXPECT_EQ(indicesOf(*mesh->getSubMesh(0)->mLodFaceList[1]), first);
}

TEST_F(ProgressiveMeshGeneratorTest, VertexCacheOrderKeepsEveryTriangle)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", makeUvSphere(20, 12));
    generate(proportional(mesh, {0.5}));
    const auto data = MeshReader::read(*mesh);
    ASSERT_TRUE(data);
    const auto chain = simplify(data.value().view(), {{LevelTarget::Kind::Proportional, 0.5}});
    ASSERT_TRUE(chain);
    const auto triangles = [](const std::vector<std::uint32_t>& indices) {
        std::multiset<std::array<std::uint32_t, 3>> set;
        for (std::size_t i = 0; i < indices.size(); i += 3) {
            std::array<std::uint32_t, 3> turned = {indices[i], indices[i + 1], indices[i + 2]};
            std::rotate(turned.begin(), std::min_element(turned.begin(), turned.end()), turned.end());
            set.insert(turned);
        }
        return set;
    };
    EXPECT_EQ(triangles(indicesOf(*mesh->getSubMesh(0)->mLodFaceList[0])),
              triangles(chain.value().levels[0].indices[0]));
}

TEST_F(ProgressiveMeshGeneratorTest, TheAutomaticConfigurationNeedsNoSettings)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", makeTerrain(40));
    const auto report = ProgressiveMeshGenerator().generateAutoconfiguredLodLevels(mesh);
    ASSERT_TRUE(report) << describe(report.error());
    EXPECT_THAT(brokenLevels(*mesh), IsEmpty());
    EXPECT_EQ(mesh->getLodStrategy()->getName(), "pixel_count");
    EXPECT_GT(mesh->getNumLodLevels(), 1);
    EXPECT_LT(report.value().levels.back().vertices, report.value().vertices);
}

TEST_F(ProgressiveMeshGeneratorTest, WithoutBoundsThereIsNoAutomaticConfiguration)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", makeTerrain(8));
    for (const Ogre::Real radius : {Ogre::Real(0), Ogre::Real(NAN), Ogre::Real(INFINITY)}) {
        mesh->_setBoundingSphereRadius(radius);
        const auto report = ProgressiveMeshGenerator().generateAutoconfiguredLodLevels(mesh);
        ASSERT_FALSE(report);
        EXPECT_EQ(report.error().code, ErrorCode::InvalidGeometry);
    }
}

} // namespace
} // namespace lodsmith::test
