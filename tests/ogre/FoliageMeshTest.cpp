#include <support/OgreMeshBuilder.h>
#include <support/OgreSession.h>

#include <lodsmith/analysis/Coverage.h>
#include <lodsmith/ogre/FoliageMesh.h>
#include <lodsmith/ogre/ProgressiveMeshGenerator.h>

#include <OgreEntity.h>
#include <OgreMeshManager.h>
#include <OgreRoot.h>
#include <OgreSceneManager.h>
#include <OgreSubMesh.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>

namespace lodsmith::test {
namespace {

using testing::IsEmpty;

/// A mesh with foliage, and one level of it.
struct Treated {
    MeshData data;
    FoliageLevel level;
};

class FoliageMeshTest : public testing::Test {
protected:
    /// Without the materials beside it, which want a render system.
    Ogre::MeshPtr load(const std::filesystem::path& file)
    {
        std::filesystem::copy_file(file, mSession.directory() / file.filename(),
                                   std::filesystem::copy_options::overwrite_existing);
        return mSession.loadSaved(file.filename().string());
    }

    static Treated treat(const Ogre::MeshPtr& mesh, double share)
    {
        Result<MeshData> data = MeshReader::read(*mesh);
        EXPECT_TRUE(data) << describe(data.error());
        std::size_t triangles = 0;
        for (const SubMeshView& subMesh : data.value().view().subMeshes)
            triangles += subMesh.indexCount / 3;
        Result<FoliageLevels> levels =
            foliageLevels(data.value().view(), {static_cast<std::uint32_t>(share * double(triangles))});
        EXPECT_TRUE(levels) << describe(levels.error());
        EXPECT_GT(levels.value().leaves, 0u);
        EXPECT_TRUE(levels.value().levels.at(0).made);
        return {std::move(data).value(), std::move(levels.value().levels.at(0))};
    }

    static Ogre::MeshPtr make(const Ogre::MeshPtr& mesh, const Treated& treated)
    {
        auto made = makeFoliageMesh(*mesh, treated.data, treated.level, "level");
        EXPECT_TRUE(made) << describe(made.error());
        return made.value();
    }

    static std::vector<float> floats(const FloatStream& stream, std::uint32_t vertex, int count)
    {
        std::vector<float> values(stream ? static_cast<std::size_t>(count) : 0);
        if (stream)
            stream.read(vertex, count, values.data());
        return values;
    }

    /// Corner by corner, what a mesh read from OGRE has against what a view says.
    static void expectSame(const MeshView& read, const MeshView& expected, bool bones = true)
    {
        ASSERT_EQ(read.subMeshes.size(), expected.subMeshes.size());
        for (std::size_t s = 0; s < read.subMeshes.size(); ++s) {
            const SubMeshView &is = read.subMeshes[s], &should = expected.subMeshes[s];
            const VertexBufferView &isIn = read.vertexBuffers[is.vertexBuffer],
                                   &shouldIn = expected.vertexBuffers[should.vertexBuffer];
            ASSERT_EQ(is.indexCount, should.indexCount);
            ASSERT_EQ(isIn.offsets.size(), shouldIn.offsets.size());
            for (std::size_t i = 0; i < is.indexCount; ++i) {
                const std::uint32_t a = is.index(i), b = should.index(i);
                ASSERT_EQ(floats(isIn.positions, a, 3), floats(shouldIn.positions, b, 3));
                ASSERT_EQ(floats(isIn.normals, a, 3), floats(shouldIn.normals, b, 3));
                for (std::size_t set = 0; set < shouldIn.uvSets.size(); ++set)
                    ASSERT_EQ(floats(isIn.uvSets[set].stream, a, 2), floats(shouldIn.uvSets[set].stream, b, 2));
                for (std::size_t pose = 0; pose < shouldIn.offsets.size(); ++pose)
                    for (std::size_t axis = 0; axis < 3; ++axis)
                        ASSERT_NEAR(floats(isIn.offsets[pose], a, 3)[axis], floats(shouldIn.offsets[pose], b, 3)[axis],
                                    1e-6);
                ASSERT_TRUE(isIn.bones || !shouldIn.bones || !bones);
                if (shouldIn.bones && bones)
                    for (int k = 0; k < 4; ++k) {
                        ASSERT_EQ(isIn.bones[a].bone[k], shouldIn.bones[b].bone[k]);
                        ASSERT_EQ(isIn.bones[a].weight[k], shouldIn.bones[b].weight[k]);
                    }
            }
        }
    }

    static void expectLevel(const Ogre::MeshPtr& mesh, const Treated& treated, bool bones = true)
    {
        const auto read = MeshReader::read(*mesh);
        ASSERT_TRUE(read) << describe(read.error());
        expectSame(read.value().view(), treated.level.view(treated.data.view()), bones);
        for (const VertexBufferView& buffer : read.value().view().vertexBuffers)
            EXPECT_LT(buffer.vertexCount, treated.data.view().vertexBuffers[0].vertexCount);
    }

    OgreSession mSession;
};

/// Leaves that a pose bends and bones move.
TestMesh makeMovingLeaves()
{
    TestMesh mesh = makeLeafCards(150);
    TestBuffer& buffer = mesh.buffers[0];
    buffer.bones.resize(buffer.vertexCount());
    std::vector<float> offsets;
    for (std::uint32_t i = 0; i < buffer.vertexCount(); ++i) {
        buffer.bones[i] = {{static_cast<std::uint16_t>(i / 4 % 7), 9, 0, 0}, {0.75f, 0.25f, 0.0f, 0.0f}};
        for (const double value : {0.01 * (i % 4), 0.02, i % 8 < 4 ? 0.0 : 0.05})
            offsets.push_back(static_cast<float>(value));
    }
    buffer.offsets = {offsets};
    return mesh;
}

TEST_F(FoliageMeshTest, IsTheLevelOfTheTree)
{
    const Ogre::MeshPtr tree = load(LODSMITH_MEDIA_DIR "/tree/tree.mesh");
    const auto before = MeshReader::read(*tree);
    const Treated treated = treat(tree, 0.135);
    const Ogre::MeshPtr level = make(tree, treated);
    expectLevel(level, treated);
    expectSame(MeshReader::read(*tree).value().view(), before.value().view());
    EXPECT_EQ(level->getNumLodLevels(), 1);
    EXPECT_EQ(level->getGroup(), tree->getGroup());
    for (std::size_t i = 0; i < tree->getNumSubMeshes(); ++i)
        EXPECT_EQ(level->getSubMesh(i)->getMaterialName(), tree->getSubMesh(i)->getMaterialName());
    EXPECT_TRUE(level->getBounds().contains(tree->getBounds()));
    expectLevel(mSession.saveAndReload(level), treated);
}

TEST_F(FoliageMeshTest, CoversTheTreeAtItsSecondLevel)
{
    // What three quarters of the vertices less leave of the index-only level: 608 of 4496 triangles.
    const Ogre::MeshPtr tree = load(LODSMITH_MEDIA_DIR "/tree/tree.mesh");
    const Treated treated = treat(tree, 608.5 / 4496.0);
    const MeshView& original = treated.data.view();
    const auto meter = CoverageMeter::of(original);
    const auto chain = simplify(original, {{LevelTarget::Kind::Proportional, 0.75}});
    ASSERT_EQ(chain.value().levels[0].triangles, 608u) << "the level to compare with";
    const auto kept = meter.value().measure(treated.level.view(original));
    ASSERT_TRUE(kept);
    EXPECT_LE(treated.level.triangles, 608u);
    EXPECT_GE(kept.value().kept, 0.95);
    EXPECT_LE(kept.value().gained, 0.1);
}

TEST_F(FoliageMeshTest, CoversOtherTreesToo)
{
    const std::string media = LODSMITH_EXTRA_MEDIA;
    if (media.empty())
        GTEST_SKIP() << "LODSMITH_EXTRA_MEDIA is not set";
    for (const char* name : {"oc_coniferous4", "oc_deciduous3"}) {
        SCOPED_TRACE(name);
        const Ogre::MeshPtr tree = load(std::filesystem::path(media) / name / "Graphics.mesh");
        const auto data = MeshReader::read(*tree);
        const MeshView& original = data.value().view();
        const auto chain = simplify(original, {{LevelTarget::Kind::Proportional, 0.75}});
        const auto levels = foliageLevels(original, {chain.value().levels[0].triangles});
        ASSERT_TRUE(levels && levels.value().leaves > 0);
        const auto kept = CoverageMeter::of(original).value().measure(levels.value().levels[0].view(original));
        EXPECT_GE(kept.value().kept, 0.95);
        Ogre::MeshManager::getSingleton().remove(tree);
    }
}

TEST_F(FoliageMeshTest, BringsBonesAndPosesAlong)
{
    for (const bool shared : {false, true}) {
        SCOPED_TRACE(shared ? "shared vertices" : "own vertices");
        const Ogre::MeshPtr mesh = makeOgreMesh(shared ? "shared" : "own", makeMovingLeaves(), {shared, !shared});
        const Treated treated = treat(mesh, 0.2);
        ASSERT_GT(treated.level.largestScale, 1.0);
        const Ogre::MeshPtr level = make(mesh, treated);
        expectLevel(level, treated);
        // Without a skeleton OGRE writes no bone assignments of shared vertices.
        expectLevel(mSession.saveAndReload(level), treated, !shared);
        Ogre::MeshManager::getSingleton().remove(level);
    }
}

TEST_F(FoliageMeshTest, DoesNotTakeTheNameOfAnother)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", makeLeafCards(50));
    const Treated treated = treat(mesh, 0.3);
    const auto made = makeFoliageMesh(*mesh, treated.data, treated.level, "mesh");
    ASSERT_FALSE(made);
    EXPECT_EQ(made.error().code, ErrorCode::InvalidSetting);
}

TEST_F(FoliageMeshTest, TakesThePlaceOfAGeneratedLevel)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", makeLeafCards(100));
    ASSERT_TRUE(ProgressiveMeshGenerator().generateLodLevels(proportional(mesh, {0.3, 0.6, 0.8})));
    ASSERT_EQ(mesh->getNumLodLevels(), 4);
    const Treated treated = treat(mesh, 0.3);
    const Ogre::MeshPtr level = make(mesh, treated);
    EXPECT_EQ(level->getNumLodLevels(), 1) << "none of the original's";
    const auto replaced = replaceLevel(*mesh, 2, level);
    ASSERT_TRUE(replaced) << describe(replaced.error());
    EXPECT_TRUE(mesh->hasManualLodLevel());
    EXPECT_EQ(mesh->getLodLevel(2).manualName, "level");
    EXPECT_EQ(mesh->getLodLevel(2).userValue, 20.0f);
    EXPECT_TRUE(mesh->getLodLevel(1).manualName.empty());
    EXPECT_TRUE(mesh->getLodLevel(3).manualName.empty());
    EXPECT_THAT(brokenLevels(*mesh), IsEmpty());
    for (const unsigned wrong : {0u, 4u})
        EXPECT_EQ(replaceLevel(*mesh, wrong, level).error().code, ErrorCode::InvalidSetting);
    EXPECT_EQ(replaceLevel(*mesh, 1, mesh).error().code, ErrorCode::InvalidSetting);
}

TEST_F(FoliageMeshTest, LeavesMeshesWithLivingEntitiesAlone)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", makeLeafCards(100));
    ASSERT_TRUE(ProgressiveMeshGenerator().generateLodLevels(proportional(mesh, {0.6})));
    const Ogre::MeshPtr level = make(mesh, treat(mesh, 0.3));
    Ogre::SceneManager* scene = Ogre::Root::getSingleton().createSceneManager();
    scene->createEntity(mesh);
    EXPECT_EQ(replaceLevel(*mesh, 1, level).error().code, ErrorCode::Unsupported);
    EXPECT_FALSE(mesh->hasManualLodLevel());
    Ogre::Root::getSingleton().destroySceneManager(scene);
    EXPECT_TRUE(replaceLevel(*mesh, 1, level));
}

} // namespace
} // namespace lodsmith::test
