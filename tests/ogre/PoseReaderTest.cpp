#include <support/OgreMeshBuilder.h>
#include <support/OgreSession.h>

#include <lodsmith/analysis/Deviation.h>
#include <lodsmith/ogre/LevelReader.h>
#include <lodsmith/ogre/ProgressiveMeshGenerator.h>

#include <OgreAnimation.h>
#include <OgreAnimationTrack.h>
#include <OgreBone.h>
#include <OgreKeyFrame.h>
#include <OgrePose.h>
#include <OgreResourceGroupManager.h>
#include <OgreSkeleton.h>
#include <OgreSkeletonInstance.h>
#include <OgreSkeletonManager.h>
#include <OgreSkeletonSerializer.h>
#include <OgreSubMesh.h>

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

namespace lodsmith::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// A key frame of the upper bone.
struct Key {
    float seconds;
    float degrees;
    Ogre::Vector3 scale = Ogre::Vector3::UNIT_SCALE;
    Ogre::Vector3 shift = Ogre::Vector3::ZERO;
};

void addAnimation(Ogre::Skeleton& skeleton, const std::string& name, const std::vector<Key>& keys)
{
    Ogre::Animation* animation = skeleton.createAnimation(name, keys.empty() ? 0 : keys.back().seconds);
    Ogre::NodeAnimationTrack* track = animation->createNodeTrack(1, skeleton.getBone(1));
    for (const Key& key : keys) {
        Ogre::TransformKeyFrame* frame = track->createNodeKeyFrame(key.seconds);
        frame->setRotation(Ogre::Quaternion(Ogre::Degree(key.degrees), Ogre::Vector3::UNIT_X));
        frame->setScale(key.scale);
        frame->setTranslate(key.shift);
    }
}

class PoseReaderTest : public testing::Test {
protected:
    /// Two bones, the upper one jointed to the lower in the middle of makeSkinnedTube().
    Ogre::SkeletonPtr makeSkeleton(const std::string& name = "skeleton")
    {
        const Ogre::SkeletonPtr skeleton = Ogre::SkeletonManager::getSingleton().create(name, "General", true);
        skeleton->load();
        skeleton->createBone("lower", 0)->createChild(1, Ogre::Vector3(0, 0, 1));
        skeleton->setBindingPose();
        return skeleton;
    }

    Ogre::MeshPtr makeTube(Ogre::SkeletonPtr skeleton, const std::string& name = "tube",
                           const TestMesh& source = makeSkinnedTube(16, 16))
    {
        const Ogre::MeshPtr mesh = makeOgreMesh(name, source);
        mesh->_notifySkeleton(skeleton);
        return mesh;
    }

    /// A skeleton that is linked to "other.skeleton", as OGRE has it from files: it follows links from these alone.
    Ogre::SkeletonPtr writeAndLoad(const Ogre::SkeletonPtr& skeleton, const Ogre::SkeletonPtr& other)
    {
        Ogre::SkeletonSerializer serializer;
        serializer.exportSkeleton(other.get(), (mSession.directory() / "other.skeleton").string());
        serializer.exportSkeleton(skeleton.get(), (mSession.directory() / "linked.skeleton").string());
        auto& resources = Ogre::ResourceGroupManager::getSingleton(); // lists a location once, when it is added
        resources.removeResourceLocation(mSession.directory().string(), mSession.group());
        resources.addResourceLocation(mSession.directory().string(), "FileSystem", mSession.group());
        auto& skeletons = Ogre::SkeletonManager::getSingleton();
        skeletons.load("linked.skeleton", mSession.group());
        return skeletons.getByName("linked.skeleton", mSession.group());
    }

    static MeshData read(const Ogre::MeshPtr& mesh, const std::vector<PoseMoment>* poses = nullptr)
    {
        Result<MeshData> data = MeshReader::read(*mesh, {}, poses);
        EXPECT_TRUE(data) << describe(data.error());
        return std::move(data).value();
    }

    static std::vector<float> secondsOf(const MeshData& data)
    {
        std::vector<float> seconds;
        for (const PoseMoment& moment : data.poses())
            seconds.push_back(moment.seconds);
        return seconds;
    }

    /// What OGRE makes of a mesh's own vertices at a moment, when it skins in software.
    static std::vector<Ogre::Vector3> skinnedByOgre(const Ogre::MeshPtr& mesh, const PoseMoment& moment)
    {
        mesh->_updateCompiledBoneAssignments();
        Ogre::SkeletonInstance skeleton(mesh->getSkeleton());
        skeleton.load();
        skeleton.getAnimation(moment.name)->apply(&skeleton, moment.seconds);
        std::vector<Ogre::Affine3> matrices(skeleton.getNumBones());
        skeleton._getBoneMatrices(matrices.data());
        const Ogre::SubMesh& subMesh = *mesh->getSubMesh(0);
        std::vector<const Ogre::Affine3*> blended;
        for (const unsigned short bone : subMesh.blendIndexToBoneIndexMap)
            blended.push_back(&matrices[bone]);
        const std::unique_ptr<Ogre::VertexData> target(subMesh.vertexData->clone());
        Ogre::Mesh::softwareVertexBlend(subMesh.vertexData, target.get(), blended.data(), blended.size(), false);
        const auto* element = target->vertexDeclaration->findElementBySemantic(Ogre::VES_POSITION);
        const auto& buffer = target->vertexBufferBinding->getBuffer(element->getSource());
        const Ogre::HardwareBufferLockGuard lock(buffer, Ogre::HardwareBuffer::HBL_READ_ONLY);
        std::vector<Ogre::Vector3> positions;
        for (std::size_t i = 0; i < target->vertexCount; ++i) {
            float* position;
            element->baseVertexPointerToElement(static_cast<unsigned char*>(lock.pData) + i * buffer->getVertexSize(),
                                                &position);
            positions.emplace_back(position);
        }
        return positions;
    }

    static void expectAsOgre(const Ogre::MeshPtr& mesh)
    {
        const MeshData data = read(mesh);
        ASSERT_FALSE(data.poses().empty());
        const VertexBufferView& buffer = data.view().vertexBuffers[0];
        for (std::size_t pose = 0; pose < data.poses().size(); ++pose) {
            const std::vector<Ogre::Vector3> expected = skinnedByOgre(mesh, data.poses()[pose]);
            for (std::uint32_t vertex = 0; vertex < buffer.vertexCount; ++vertex) {
                float position[3];
                buffer.poses[pose].read(vertex, 3, position);
                ASSERT_LT(expected[vertex].distance(Ogre::Vector3(position)), 1e-5f) << "vertex " << vertex;
            }
        }
    }

    static inline const std::vector<PoseMoment> kAtRest;
    OgreSession mSession;
};

TEST_F(PoseReaderTest, VerticesAreWhereOgreSkinsThemTo)
{
    const Ogre::SkeletonPtr skeleton = makeSkeleton();
    addAnimation(*skeleton, "bend", {{0, 0}, {1, 100, {1, 1, 1.5f}, {0.1f, 0, 0}}, {2, -70}});
    expectAsOgre(makeTube(skeleton));
}

TEST_F(PoseReaderTest, AVertexWithoutBoneGoesWhereOgreTakesIt)
{
    TestMesh source = makeSkinnedTube(16, 16);
    source.buffers[0].bones[20].weight[0] = source.buffers[0].bones[20].weight[1] = 0.0f;
    const Ogre::SkeletonPtr skeleton = makeSkeleton();
    addAnimation(*skeleton, "bend", {{0, 0}, {1, 100}});
    skeleton->getAnimation("bend")
        ->createNodeTrack(0, skeleton->getBone(0))
        ->createNodeKeyFrame(0)
        ->setTranslate(Ogre::Vector3(0, 3, 0));
    expectAsOgre(makeTube(skeleton, "tube", source));
}

TEST_F(PoseReaderTest, ExtremesAreChosenBothWays)
{
    const Ogre::SkeletonPtr skeleton = makeSkeleton();
    addAnimation(*skeleton, "nod", {{0, 0}, {1, 90}, {2, 10}, {3, -80}, {4, 0}});
    const std::vector<float> seconds = secondsOf(read(makeTube(skeleton)));
    ASSERT_GE(seconds.size(), 2u);
    EXPECT_LE(seconds.size(), 4u);
    EXPECT_EQ(seconds[0], 1.0f);
    EXPECT_EQ(seconds[1], 3.0f);
}

TEST_F(PoseReaderTest, MomentsBetweenKeyFramesAreLookedAt)
{
    const Ogre::SkeletonPtr skeleton = makeSkeleton();
    addAnimation(*skeleton, "turn", {{0, 0}, {2, 0}});
    // The upper half goes from one side to the other: halfway it is where the lower one is, and far from both ends.
    Ogre::NodeAnimationTrack* track = skeleton->getAnimation("turn")->getNodeTrack(1);
    for (const unsigned short key : {0, 1})
        track->getNodeKeyFrame(key)->setRotation(
            Ogre::Quaternion(Ogre::Degree(key == 0 ? 0 : 179), Ogre::Vector3::UNIT_Z));
    const std::vector<float> seconds = secondsOf(read(makeTube(skeleton)));
    EXPECT_THAT(seconds, ElementsAre(2.0f, 1.0f)) << "a wrung tube, and one half as much";
}

TEST_F(PoseReaderTest, WhatBendsNothingIsNoPose)
{
    const Ogre::SkeletonPtr skeleton = makeSkeleton();
    addAnimation(*skeleton, "still", {{0, 0}, {1, 0}});
    Ogre::NodeAnimationTrack* walk = skeleton->createAnimation("walk", 1)->createNodeTrack(0, skeleton->getBone(0));
    walk->createNodeKeyFrame(0);
    walk->createNodeKeyFrame(1)->setTranslate(Ogre::Vector3(50, 0, 0));
    walk->getNodeKeyFrame(1)->setRotation(Ogre::Quaternion(Ogre::Degree(120), Ogre::Vector3::UNIT_Y));
    const MeshData data = read(makeTube(skeleton));
    EXPECT_THAT(data.poses(), IsEmpty());
    EXPECT_THAT(data.view().vertexBuffers[0].poses, IsEmpty());
}

TEST_F(PoseReaderTest, PartsThatFollowABoneEachNeedNone)
{
    TestMesh source = makeSkinnedTube(16, 16);
    for (BoneInfluences& influences : source.buffers[0].bones)
        influences.weight[influences.weight[1] < 0.5f ? 1 : 0] = 0.0f;
    const Ogre::SkeletonPtr skeleton = makeSkeleton();
    addAnimation(*skeleton, "bend", {{0, 0}, {1, 100}});
    EXPECT_THAT(read(makeTube(skeleton, "tube", source)).poses(), IsEmpty());
}

TEST_F(PoseReaderTest, OddAnimationsDoNoHarm)
{
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const std::vector<std::vector<Key>> animations = {
        {},
        {{0, 60}},
        {{0, 0}, {1, 0, {0, 0, 0}}},
        {{0, 0}, {1, 0, {-1, -1, -1}}},
        {{0, 0}, {1, nan}, {2, 50}},
        {{0, 0}, {1, 0, {nan, 1, 1}}},
        {{0, 0}, {1, 30, Ogre::Vector3::UNIT_SCALE, {1e30f, 0, 0}}},
        {{0, 0}, {1, 30, {1e25f, 1e25f, 1e25f}}},
    };
    for (std::size_t i = 0; i < animations.size(); ++i) {
        SCOPED_TRACE(i);
        const Ogre::SkeletonPtr skeleton = makeSkeleton("skeleton" + std::to_string(i));
        addAnimation(*skeleton, "odd", animations[i]);
        const Ogre::MeshPtr mesh = makeTube(skeleton, "tube" + std::to_string(i));
        const MeshData data = read(mesh);
        const auto report = ProgressiveMeshGenerator().generateLodLevels(proportional(mesh, {0.5}));
        ASSERT_TRUE(report) << describe(report.error());
        EXPECT_EQ(mesh->getNumLodLevels(), 2);
        if (i == 1) {
            EXPECT_THAT(secondsOf(data), ElementsAre(0.0f)) << "of no length, but it bends";
        }
        if (i == 4) {
            EXPECT_THAT(secondsOf(data), ElementsAre(2.0f)) << "the rest of it is sound";
        }
    }
}

TEST_F(PoseReaderTest, BonesDrawnToAPointHinderNothing)
{
    const Ogre::SkeletonPtr skeleton = makeSkeleton();
    addAnimation(*skeleton, "bend", {{0, 0}, {1, 90}});
    Ogre::NodeAnimationTrack* track = skeleton->createAnimation("vanish", 1)->createNodeTrack(0, skeleton->getBone(0));
    track->createNodeKeyFrame(0)->setScale(Ogre::Vector3::ZERO);
    const Ogre::MeshPtr mesh = makeTube(skeleton);
    const auto report = ProgressiveMeshGenerator().generateLodLevels(proportional(mesh, {0.8}));
    ASSERT_TRUE(report) << describe(report.error());
    EXPECT_EQ(report.value().levels[0].stop, StopReason::TargetReached);
}

TEST_F(PoseReaderTest, ThousandsOfKeyFramesGiveAFewPoses)
{
    const Ogre::SkeletonPtr skeleton = makeSkeleton();
    std::vector<Key> keys;
    for (int i = 0; i <= 5000; ++i)
        keys.push_back({static_cast<float>(i), 90.0f * std::sin(static_cast<float>(i) / 700.0f)});
    addAnimation(*skeleton, "long", keys);
    const MeshData data = read(makeTube(skeleton));
    EXPECT_GE(data.poses().size(), 2u);
    EXPECT_LE(data.poses().size(), 4u);
    EXPECT_GT(std::abs(90.0f * std::sin(data.poses()[0].seconds / 700.0f)), 85.0f);
}

TEST_F(PoseReaderTest, LinkedSkeletonsAnimateToo)
{
    const Ogre::SkeletonPtr other = makeSkeleton("other"), skeleton = makeSkeleton();
    addAnimation(*other, "bend", {{0, 0}, {1, 90}});
    skeleton->addLinkedSkeletonAnimationSource("other.skeleton");
    const MeshData data = read(makeTube(writeAndLoad(skeleton, other)));
    ASSERT_FALSE(data.poses().empty());
    EXPECT_EQ(data.poses()[0].name, "bend");
    EXPECT_EQ(data.poses()[0].seconds, 1.0f);
}

TEST_F(PoseReaderTest, LinkedAnimationsOfBonesThatAreNotThereDoNotCount)
{
    const Ogre::SkeletonPtr other = makeSkeleton("other"), skeleton = makeSkeleton();
    other->getBone(1)->addChild(other->createBone("uppermost", 2));
    other->setBindingPose();
    addAnimation(*other, "bend", {{0, 0}, {1, 90}});
    other->getAnimation("bend")->createNodeTrack(2, other->getBone(2))->createNodeKeyFrame(0);
    skeleton->addLinkedSkeletonAnimationSource("other.skeleton");
    const Ogre::SkeletonPtr linked = writeAndLoad(skeleton, other);
    EXPECT_THAT(read(makeTube(linked)).poses(), IsEmpty());
}

TEST_F(PoseReaderTest, WeightsThatAreNoNumbersAreIgnored)
{
    const Ogre::SkeletonPtr skeleton = makeSkeleton();
    addAnimation(*skeleton, "bend", {{0, 0}, {1, 90}});
    const Ogre::MeshPtr mesh = makeTube(skeleton);
    const std::size_t before = read(mesh).poses().size();
    for (const float weight : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()})
        mesh->getSubMesh(0)->addBoneAssignment({0, 60000, weight});
    const MeshData data = read(mesh);
    EXPECT_EQ(data.poses().size(), before);
    EXPECT_THAT(data.notes(), ElementsAre(HasSubstr("2 bone assignments have a weight that is no number")));
    for (int i = 0; i < 4; ++i)
        EXPECT_LT(data.view().vertexBuffers[0].bones[0].bone[i], 2);
}

TEST_F(PoseReaderTest, TheSkeletonOfOthersStaysAsItIs)
{
    const Ogre::SkeletonPtr skeleton = makeSkeleton();
    addAnimation(*skeleton, "bend", {{0, 0}, {1, 90}});
    const Ogre::Quaternion before = skeleton->getBone(1)->getOrientation();
    read(makeTube(skeleton));
    EXPECT_EQ(skeleton->getBone(1)->getOrientation(), before);
}

TEST_F(PoseReaderTest, WithoutASkeletonRestIsAll)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("tube", makeSkinnedTube(16, 16));
    EXPECT_THAT(read(mesh).poses(), IsEmpty());
    EXPECT_THAT(read(mesh).notes(), IsEmpty());
    mesh->setSkeletonName("nowhere.skeleton");
    EXPECT_THAT(read(mesh).poses(), IsEmpty());
    EXPECT_THAT(read(mesh).notes(), ElementsAre(HasSubstr("skeleton 'nowhere.skeleton' is missing or damaged")));
}

TEST_F(PoseReaderTest, BonesThatAreMissingAreNoted)
{
    TestMesh source = makeSkinnedTube(16, 16);
    source.buffers[0].bones[3].bone[0] = 7;
    const Ogre::SkeletonPtr skeleton = makeSkeleton();
    addAnimation(*skeleton, "bend", {{0, 0}, {1, 90}});
    const MeshData data = read(makeTube(skeleton, "tube", source));
    EXPECT_THAT(data.poses(), IsEmpty());
    EXPECT_THAT(data.notes(), ElementsAre(HasSubstr("bones that the skeleton does not have")));
}

TEST_F(PoseReaderTest, PosesOfTheMeshCount)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("two", joined(makeGrid(4, 4), makeTetrahedron()));
    Ogre::Pose* pose = mesh->createPose(1, "bump");
    pose->addVertex(7, Ogre::Vector3(0, 0, 0.5f));
    mesh->createPose(2)->addVertex(0, Ogre::Vector3(1, 0, 0));
    mesh->createPose(1, "breath")->addVertex(7, Ogre::Vector3(0, 0, 1e-5f));
    const MeshData data = read(mesh);
    ASSERT_THAT(data.poses(), SizeIs(2));
    EXPECT_EQ(data.poses()[0].name, "#2");
    EXPECT_EQ(data.poses()[1].name, "bump");
    const auto& buffers = data.view().vertexBuffers;
    EXPECT_FALSE(buffers[0].poses[0]);
    EXPECT_FALSE(buffers[1].poses[1]);
    float rest[3], posed[3];
    buffers[0].positions.read(7, 3, rest);
    buffers[0].poses[1].read(7, 3, posed);
    EXPECT_THAT(posed, ElementsAre(rest[0], rest[1], rest[2] + 0.5f));
}

TEST_F(PoseReaderTest, HandMadeLevelsAreReadInTheSamePoses)
{
    const Ogre::SkeletonPtr skeleton = makeSkeleton();
    addAnimation(*skeleton, "nod", {{0, 0}, {1, 90}, {3, -80}});
    const Ogre::MeshPtr mesh = makeTube(skeleton), coarse = makeTube(skeleton, "coarse", makeSkinnedTube(8, 2));
    setHandMadeLevel(*mesh, "coarse");
    const auto levelZero = LevelReader::readLevelZero(*mesh).value();
    ASSERT_GE(levelZero->poses().size(), 2u);
    const LevelData level = LevelReader::read(*mesh, levelZero, 1).value();
    ASSERT_EQ(poseCount(level.view()), levelZero->poses().size());
    const Deviation deviation = measureDeviation(levelZero->view(), level.view(), {5000, 1}).value();
    EXPECT_EQ(deviation.poses, levelZero->poses().size());
    // Two stacks cannot follow the bend.
    EXPECT_GT(deviation.surface.maximum,
              2.0
                  * measureDeviation(read(mesh, &kAtRest).view(), read(coarse, &kAtRest).view(), {5000, 1})
                        .value()
                        .surface.maximum);
}

TEST_F(PoseReaderTest, MomentsThatAMeshDoesNotHaveLeaveItAtRest)
{
    const Ogre::SkeletonPtr skeleton = makeSkeleton();
    addAnimation(*skeleton, "bend", {{0, 0}, {1, 90}});
    const Ogre::MeshPtr mesh = makeTube(skeleton);
    const std::vector<PoseMoment> moments = {{PoseMoment::Kind::Skeleton, "bend", 1.0f},
                                             {PoseMoment::Kind::Skeleton, "jump", 1.0f}};
    const MeshData data = read(mesh, &moments);
    EXPECT_THAT(data.poses(), IsEmpty());
    EXPECT_THAT(data.view().vertexBuffers[0].poses, IsEmpty());
}

} // namespace
} // namespace lodsmith::test
