#pragma once

#include <OgreSkeleton.h>

namespace lodsmith::media {

/// The skeleton of drakeBones() as the resource drake.skeleton, with the animations "idle" (4 s) and "walk" (1.2 s), both
/// made to repeat. Every call makes the same; call it once.
Ogre::SkeletonPtr makeDrakeSkeleton();

} // namespace lodsmith::media
