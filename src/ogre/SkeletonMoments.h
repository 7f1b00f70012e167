#pragma once

#include <lodsmith/ogre/MeshReader.h>

#include <OgreSkeleton.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace lodsmith {

/// Moves a skeleton without anybody noticing: a copy of its bones under its own animations and those of skeletons that it is
/// linked to. Main thread only.
class SkeletonMoments {
public:
    /// The skeleton has to be loaded, and its bones numbered without a gap.
    explicit SkeletonMoments(const Ogre::SkeletonPtr& skeleton);
    ~SkeletonMoments();
    SkeletonMoments(const SkeletonMoments&) = delete;
    SkeletonMoments& operator=(const SkeletonMoments&) = delete;

    /// Every key frame of every animation and the moments halfway between them, in order of animation and time; of more than
    /// `most`, as many as that, evenly spread.
    std::vector<PoseMoment> all(std::size_t most) const;

    /// What takes each bone's vertices from rest to a moment, and how the bone is turned by then.
    struct Bones {
        std::vector<Ogre::Affine3> transforms;
        std::vector<Ogre::Quaternion> turns; ///< of length 1
    };

    /// False when there is no such animation, or a number is not finite.
    bool at(const PoseMoment& moment, Bones& bones);

private:
    std::unique_ptr<Ogre::Skeleton> mBones;
};

} // namespace lodsmith
