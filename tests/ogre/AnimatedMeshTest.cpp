#include <support/OgreMeshBuilder.h>
#include <support/OgreSession.h>
#include <support/SurfaceDistance.h>

#include <lodsmith/ogre/ProgressiveMeshGenerator.h>

#include <OgreAnimation.h>
#include <OgreAnimationTrack.h>
#include <OgreBone.h>
#include <OgreEdgeListBuilder.h>
#include <OgreHardwareBufferManager.h>
#include <OgreKeyFrame.h>
#include <OgrePose.h>
#include <OgreSkeleton.h>
#include <OgreSkeletonManager.h>
#include <OgreSubMesh.h>

#include <gmock/gmock.h>

#include <algorithm>

namespace lodsmith::test {
namespace {

using testing::IsEmpty;
using Positions = std::vector<Ogre::Vector3>;

/// All levels share the vertex buffers, hence whatever moves the vertices has to suit every level's triangles.
class AnimatedMeshTest : public testing::Test {
protected:
    static void generate(const Ogre::MeshPtr& mesh)
    {
        LodConfig config;
        config.mesh = mesh;
        for (const double removed : {0.5, 0.75})
            config.levels.push_back(
                {static_cast<Ogre::Real>(100 * removed), {LevelTarget::Kind::Proportional, removed}, {}});
        const auto report = ProgressiveMeshGenerator().generateLodLevels(config);
        ASSERT_TRUE(report) << describe(report.error());
        ASSERT_EQ(mesh->getNumLodLevels(), 3);
        ASSERT_THAT(brokenLevels(*mesh), IsEmpty());
    }

    static Positions positionsOf(const Ogre::VertexData& vertices)
    {
        const auto* element = vertices.vertexDeclaration->findElementBySemantic(Ogre::VES_POSITION);
        const auto& buffer = vertices.vertexBufferBinding->getBuffer(element->getSource());
        const Ogre::HardwareBufferLockGuard lock(buffer, Ogre::HardwareBuffer::HBL_READ_ONLY);
        Positions positions;
        for (std::size_t i = 0; i < vertices.vertexCount; ++i) {
            float* position;
            element->baseVertexPointerToElement(static_cast<unsigned char*>(lock.pData) + i * buffer->getVertexSize(),
                                                &position);
            positions.emplace_back(position);
        }
        return positions;
    }

    static std::vector<std::uint32_t> trianglesOf(const Ogre::MeshPtr& mesh, unsigned short level)
    {
        Ogre::RenderOperation operation;
        mesh->getSubMesh(0)->_getRenderOperation(operation, level);
        return indicesOf(*operation.indexData);
    }

    static std::vector<Triangle> surface(const Positions& positions, const std::vector<std::uint32_t>& indices)
    {
        const auto point = [&](std::uint32_t index) {
            return Point{positions[index].x, positions[index].y, positions[index].z};
        };
        std::vector<Triangle> triangles;
        for (std::size_t i = 0; i < indices.size(); i += 3)
            triangles.push_back({point(indices[i]), point(indices[i + 1]), point(indices[i + 2])});
        return triangles;
    }

    /// A copy of the mesh's own vertices that software animation may write to.
    static std::unique_ptr<Ogre::VertexData> scratch(const Ogre::MeshPtr& mesh)
    {
        return std::unique_ptr<Ogre::VertexData>(mesh->getSubMesh(0)->vertexData->clone());
    }

    OgreSession mSession;
};

TEST_F(AnimatedMeshTest, SkinnedLevelsBendLikeTheOriginal)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", makeSkinnedTube(24, 24));
    const Ogre::SkeletonPtr skeleton = Ogre::SkeletonManager::getSingleton().create("skeleton", "General", true);
    skeleton->load();
    skeleton->createBone("lower", 0);
    skeleton->createBone("upper", 1);
    Ogre::SkeletonPtr attached = skeleton;
    mesh->_notifySkeleton(attached);
    generate(mesh);

    mesh->_updateCompiledBoneAssignments();
    const Ogre::Affine3 still = Ogre::Affine3::IDENTITY;
    const Ogre::Affine3 bent(Ogre::Vector3::ZERO, Ogre::Quaternion(Ogre::Degree(40), Ogre::Vector3::UNIT_X));
    const Ogre::Affine3* bones[] = {&still, &bent};
    const auto target = scratch(mesh);
    Ogre::Mesh::softwareVertexBlend(mesh->getSubMesh(0)->vertexData, target.get(), bones, 2, false);
    const Positions rest = positionsOf(*mesh->getSubMesh(0)->vertexData), moved = positionsOf(*target);
    ASSERT_NE(rest, moved);

    const auto whole = surface(moved, trianglesOf(mesh, 0));
    for (const unsigned short level : {1, 2}) {
        const auto triangles = surface(moved, trianglesOf(mesh, level));
        // The tube's radius is 0.5: what is left must follow the bend to a fifth of it.
        EXPECT_LT(sampledDistance(whole, triangles, 500, 1), 0.1) << "level " << level;
        EXPECT_LT(sampledDistance(triangles, whole, 500, 1), 0.1) << "level " << level;
    }
}

TEST_F(AnimatedMeshTest, PosedLipsOpenAtEveryLevel)
{
    const TestMesh lips = makeClosedLips(12);
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", lips);
    ASSERT_EQ(mesh->getPoseList().size(), 1u);
    const Ogre::Pose& pose = *mesh->getPoseList()[0];
    generate(mesh);
    const auto target = scratch(mesh);
    Ogre::Mesh::softwareVertexPoseBlend(1, pose.getVertexOffsets(), pose.getNormals(), target.get());
    const Positions rest = positionsOf(*mesh->getSubMesh(0)->vertexData), moved = positionsOf(*target);
    for (const unsigned short level : {0, 1, 2}) {
        const auto triangles = trianglesOf(mesh, level);
        bool up = false, down = false;
        for (std::size_t i = 0; i < triangles.size(); i += 3) {
            bool rises = false, falls = false;
            for (std::size_t corner = i; corner < i + 3; ++corner) {
                rises |= moved[triangles[corner]].y > rest[triangles[corner]].y + 1e-3f;
                falls |= moved[triangles[corner]].y < rest[triangles[corner]].y - 1e-3f;
            }
            EXPECT_FALSE(rises && falls) << "level " << level << ": a triangle spans the mouth";
            up |= rises;
            down |= falls;
        }
        EXPECT_TRUE(up && down) << "level " << level;
    }
}

TEST_F(AnimatedMeshTest, MorphedLevelsFollowTheFrames)
{
    const TestMesh source = makeUvSphere(24, 16);
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", source);
    // Morphing needs positions in a buffer of their own.
    auto* apart = mesh->getSubMesh(0)->vertexData->vertexDeclaration->clone();
    apart->modifyElement(0, 0, 0, Ogre::VET_FLOAT3, Ogre::VES_POSITION);
    apart->modifyElement(1, 1, 0, Ogre::VET_FLOAT3, Ogre::VES_NORMAL);
    apart->modifyElement(2, 1, 12, Ogre::VET_FLOAT2, Ogre::VES_TEXTURE_COORDINATES);
    mesh->getSubMesh(0)->vertexData->reorganiseBuffers(apart);
    auto* track = mesh->createAnimation("morph", 1)->createVertexTrack(1, Ogre::VAT_MORPH);
    const std::vector<float>& rest = source.buffers[0].positions;
    std::vector<float> stretched = source.buffers[0].positions;
    for (std::size_t i = 2; i < stretched.size(); i += 3)
        stretched[i] *= 2.0f;
    for (const Ogre::Real time : {0, 1}) {
        const std::vector<float>& frame = time > 0 ? stretched : rest;
        auto buffer = Ogre::HardwareBufferManager::getSingleton().createVertexBuffer(12, frame.size() / 3,
                                                                                     Ogre::HardwareBuffer::HBU_STATIC);
        buffer->writeData(0, buffer->getSizeInBytes(), frame.data());
        track->createVertexMorphKeyFrame(time)->setVertexBuffer(buffer);
    }
    generate(mesh);
    const auto target = scratch(mesh);
    Ogre::Mesh::softwareVertexMorph(1, track->getVertexMorphKeyFrame(0)->getVertexBuffer(),
                                    track->getVertexMorphKeyFrame(1)->getVertexBuffer(), target.get());
    const Positions moved = positionsOf(*target);
    const auto whole = surface(moved, trianglesOf(mesh, 0));
    for (const unsigned short level : {1, 2})
        EXPECT_LT(sampledDistance(whole, surface(moved, trianglesOf(mesh, level)), 500, 1), 0.25) << "level " << level;
}

TEST_F(AnimatedMeshTest, ShadowVolumesWorkAtEveryLevel)
{
    const TestMesh source = makeUvSphere(24, 16);
    const Ogre::MeshPtr plain = makeOgreMesh("plain", source), mesh = makeOgreMesh("prepared", source);
    mesh->prepareForShadowVolume();
    mesh->buildEdgeList();
    generate(plain);
    generate(mesh);
    EXPECT_TRUE(mesh->isPreparedForShadowVolumes());
    for (const unsigned short level : {0, 1, 2}) {
        EXPECT_EQ(trianglesOf(mesh, level), trianglesOf(plain, level));
        const Ogre::EdgeData* edges = mesh->getEdgeList(level);
        ASSERT_NE(edges, nullptr);
        EXPECT_LE(edges->triangles.size(), trianglesOf(mesh, level).size() / 3);
        EXPECT_GT(edges->triangles.size(), 0u);
        EXPECT_TRUE(edges->isClosed) << "level " << level;
    }
    EXPECT_EQ(mSession.saveAndReload(mesh)->getNumLodLevels(), 3);
}

TEST_F(AnimatedMeshTest, MeshesPreparedLaterWorkToo)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", makeUvSphere(24, 16));
    generate(mesh);
    const auto before = trianglesOf(mesh, 2);
    mesh->prepareForShadowVolume();
    mesh->buildEdgeList();
    EXPECT_EQ(trianglesOf(mesh, 2), before);
    EXPECT_TRUE(mesh->getEdgeList(2)->isClosed);
    generate(mesh);
    EXPECT_EQ(trianglesOf(mesh, 2), before) << "generating anew changes nothing";
}

} // namespace
} // namespace lodsmith::test
