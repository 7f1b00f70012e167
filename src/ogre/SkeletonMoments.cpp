#include "SkeletonMoments.h"

#include <OgreAnimation.h>
#include <OgreAnimationTrack.h>
#include <OgreBone.h>
#include <OgreKeyFrame.h>
#include <OgreSkeletonInstance.h>

#include <algorithm>
#include <cmath>

namespace lodsmith {

namespace {

/// Key frames and what is halfway, sorted.
std::vector<float> timesOf(const Ogre::Animation& animation)
{
    std::vector<float> keys;
    for (const auto& [handle, track] : animation._getNodeTrackList())
        for (unsigned short i = 0; i < track->getNumKeyFrames(); ++i)
            keys.push_back(static_cast<float>(track->getKeyFrame(i)->getTime()));
    keys.erase(std::remove_if(keys.begin(), keys.end(), [](float time) { return !std::isfinite(time); }), keys.end());
    std::sort(keys.begin(), keys.end());
    keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
    std::vector<float> times;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        if (i != 0)
            times.push_back(0.5f * (keys[i - 1] + keys[i]));
        times.push_back(keys[i]);
    }
    return times;
}

void addMoments(const Ogre::Skeleton& skeleton, std::vector<PoseMoment>& moments)
{
    for (unsigned short i = 0; i < skeleton.getNumAnimations(); ++i) {
        const Ogre::Animation& animation = *skeleton.getAnimation(i);
        for (const float time : timesOf(animation))
            moments.push_back({PoseMoment::Kind::Skeleton, animation.getName(), time});
    }
}

/// Whether the skeleton has every bone that an animation moves: one of another skeleton, linked to this one, may move more.
bool fits(const Ogre::Animation& animation, const Ogre::Skeleton& skeleton)
{
    const auto& bones = skeleton.getBones();
    const auto& tracks = animation._getNodeTrackList();
    return std::all_of(tracks.begin(), tracks.end(),
                       [&](const auto& track) { return track.first < bones.size() && bones[track.first]; });
}

bool isFinite(const Ogre::Affine3& transform)
{
    for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t column = 0; column < 4; ++column)
            if (!std::isfinite(transform[row][column]))
                return false;
    return true;
}

} // namespace

SkeletonMoments::SkeletonMoments(const Ogre::SkeletonPtr& skeleton)
    : mBones(std::make_unique<Ogre::SkeletonInstance>(skeleton))
{
    mBones->load();
}

SkeletonMoments::~SkeletonMoments() = default;

std::vector<PoseMoment> SkeletonMoments::all(std::size_t most) const
{
    std::vector<PoseMoment> moments;
    addMoments(*mBones, moments);
    for (const Ogre::LinkedSkeletonAnimationSource& linked : mBones->getLinkedSkeletonAnimationSources())
        if (linked.pSkeleton)
            addMoments(*linked.pSkeleton, moments);
    if (moments.size() <= most)
        return moments;
    std::vector<PoseMoment> spread;
    for (std::size_t i = 0; i < most; ++i)
        spread.push_back(moments[i * (moments.size() - 1) / (most - 1)]);
    return spread;
}

bool SkeletonMoments::at(const PoseMoment& moment, Bones& bones)
{
    const Ogre::LinkedSkeletonAnimationSource* linked = nullptr;
    Ogre::Animation* animation = mBones->_getAnimationImpl(moment.name, &linked);
    if (!animation || !fits(*animation, *mBones))
        return false;
    mBones->reset(true);
    animation->apply(mBones.get(), moment.seconds, 1, linked ? linked->scale : Ogre::Real(1));
    bones.transforms.resize(mBones->getNumBones());
    mBones->_getBoneMatrices(bones.transforms.data());
    bones.turns.clear();
    for (const Ogre::Bone* bone : mBones->getBones()) {
        Ogre::Quaternion turn = bone->_getDerivedOrientation() * bone->_getBindingPoseInverseOrientation();
        turn.normalise();
        bones.turns.push_back(turn);
        if (turn.isNaN())
            return false;
    }
    return std::all_of(bones.transforms.begin(), bones.transforms.end(), isFinite);
}

} // namespace lodsmith
