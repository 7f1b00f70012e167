#include "DrakeSkeleton.h"

#include "DrakeBody.h"

#include <OgreAnimation.h>
#include <OgreAnimationTrack.h>
#include <OgreBone.h>
#include <OgreKeyFrame.h>
#include <OgreMath.h>
#include <OgreResourceGroupManager.h>
#include <OgreSkeletonManager.h>

#include <cmath>

namespace lodsmith::media {

namespace {

using Ogre::Vector3;

constexpr int kFrames = 12; ///< of each animation, the last like the first

/// A bone that swings to and fro once or several times in an animation.
struct Swing {
    const char* bone;
    Vector3 axis;
    float degrees = 0.0f;
    float phase = 0.0f; ///< 0..1 of the animation
    float rest = 0.0f;  ///< degrees about which it swings
    int times = 1;
};

const Vector3 kPitch = Vector3::UNIT_X, kYaw = Vector3::UNIT_Y, kRoll = Vector3::UNIT_Z;

const Swing kIdle[] = {
    {"chest", kPitch, 1.2f, 0.0f, 0.0f, 2},
    {"neck1", kPitch, 2.5f, 0.1f, 0.0f, 2},
    {"neck2", kYaw, 9.0f, 0.0f},
    {"head", kYaw, 12.0f, 0.06f},
    {"head", kRoll, 4.0f, 0.3f},
    {"jaw", kPitch, 4.0f, 0.2f, 4.0f, 2},
    {"tail1", kYaw, 5.0f, 0.0f},
    {"tail2", kYaw, 8.0f, 0.85f},
    {"tail3", kYaw, 11.0f, 0.7f},
    {"tail4", kYaw, 15.0f, 0.55f},
};

const Swing kWalk[] = {
    {"pelvis", kYaw, 4.0f, 0.25f},
    {"spine", kYaw, 5.0f, 0.75f},
    {"chest", kYaw, 4.0f, 0.75f},
    {"neck1", kYaw, 5.0f, 0.25f},
    {"neck2", kPitch, 3.0f, 0.0f, 0.0f, 2},
    {"head", kPitch, 3.0f, 0.5f, 0.0f, 2},
    {"tail1", kYaw, 7.0f, 0.25f},
    {"tail2", kYaw, 9.0f, 0.1f},
    {"tail3", kYaw, 11.0f, 0.95f},
    {"tail4", kYaw, 13.0f, 0.8f},
    {"front_upper.L", kPitch, 24.0f, 0.0f},
    {"front_lower.L", kPitch, 18.0f, 0.25f, -6.0f},
    {"front_foot.L", kPitch, 20.0f, 0.6f},
    {"hind_upper.R", kPitch, 22.0f, 0.05f},
    {"hind_lower.R", kPitch, 18.0f, 0.8f, 4.0f},
    {"hind_foot.R", kPitch, 22.0f, 0.6f},
    {"front_upper.R", kPitch, 24.0f, 0.5f},
    {"front_lower.R", kPitch, 18.0f, 0.75f, -6.0f},
    {"front_foot.R", kPitch, 20.0f, 0.1f},
    {"hind_upper.L", kPitch, 22.0f, 0.55f},
    {"hind_lower.L", kPitch, 18.0f, 0.3f, 4.0f},
    {"hind_foot.L", kPitch, 22.0f, 0.1f},
};

void addBones(Ogre::Skeleton& skeleton)
{
    const auto& bones = drakeBones();
    for (std::size_t i = 0; i < bones.size(); ++i) {
        Ogre::Bone* bone = skeleton.createBone(bones[i].name, static_cast<unsigned short>(i));
        if (bones[i].parent < 0) {
            bone->setPosition(bones[i].from);
            continue;
        }
        bone->setPosition(bones[i].from - bones[std::size_t(bones[i].parent)].from);
        skeleton.getBone(static_cast<unsigned short>(bones[i].parent))->addChild(bone);
    }
    skeleton.setBindingPose();
}

Ogre::Quaternion swung(const Swing& swing, float time)
{
    const float wave = std::sin(Ogre::Math::TWO_PI * (float(swing.times) * time + swing.phase));
    return Ogre::Quaternion(Ogre::Degree(swing.rest + swing.degrees * wave), swing.axis);
}

void addSwing(Ogre::Skeleton& skeleton, Ogre::Animation& animation, const Swing& swing)
{
    const auto handle = static_cast<unsigned short>(drakeBone(swing.bone));
    const bool known = animation.hasNodeTrack(handle);
    Ogre::NodeAnimationTrack* track =
        known ? animation.getNodeTrack(handle) : animation.createNodeTrack(handle, skeleton.getBone(handle));
    for (int frame = 0; frame <= kFrames; ++frame) {
        const float time = float(frame) / kFrames;
        Ogre::TransformKeyFrame* key = known ? track->getNodeKeyFrame(static_cast<unsigned short>(frame))
                                             : track->createNodeKeyFrame(time * animation.getLength());
        key->setRotation(key->getRotation() * swung(swing, time));
    }
}

/// The body rises and sinks twice a step.
void addBob(Ogre::Skeleton& skeleton, Ogre::Animation& animation, float height)
{
    Ogre::NodeAnimationTrack* track = animation.createNodeTrack(0, skeleton.getBone(0));
    for (int frame = 0; frame <= kFrames; ++frame) {
        const float time = float(frame) / kFrames;
        track->createNodeKeyFrame(time * animation.getLength())
            ->setTranslate(Vector3(0, height * std::sin(2.0f * Ogre::Math::TWO_PI * time), 0));
    }
}

} // namespace

Ogre::SkeletonPtr makeDrakeSkeleton()
{
    Ogre::SkeletonPtr skeleton =
        Ogre::SkeletonManager::getSingleton().create("drake.skeleton", Ogre::RGN_DEFAULT, true);
    addBones(*skeleton);
    Ogre::Animation* idle = skeleton->createAnimation("idle", 4.0f);
    for (const Swing& swing : kIdle)
        addSwing(*skeleton, *idle, swing);
    Ogre::Animation* walk = skeleton->createAnimation("walk", 1.2f);
    for (const Swing& swing : kWalk)
        addSwing(*skeleton, *walk, swing);
    addBob(*skeleton, *walk, 0.015f);
    return skeleton;
}

} // namespace lodsmith::media
