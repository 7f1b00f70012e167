#pragma once

#include "Shape.h"

#include <OgreVector.h>

#include <string>
#include <vector>

namespace lodsmith::media {

/// Parts of the drake that have a chart of their own in the texture.
enum class Limb { Torso, Neck, Tail, FrontLeft, FrontRight, HindLeft, HindRight };
inline constexpr int kLimbs = 7;

/// A bone in the resting pose, and the flesh around it: a cone with round ends. Metres; the drake looks along +Z.
struct DrakeBone {
    std::string name;
    int parent = -1; ///< number in drakeBones(); -1 for the root, which has no flesh
    Ogre::Vector3 from;
    Ogre::Vector3 to;
    float fromRadius = 0.0f;
    float toRadius = 0.0f;
    Limb limb = Limb::Torso;
};

/// Parents come before their children.
const std::vector<DrakeBone>& drakeBones();

/// Number of the bone with this name.
int drakeBone(const std::string& name);

/// Distance to the skin, smooth, negative inside.
float drakeField(const Ogre::Vector3& position);

/// Which limb's flesh a point lies deepest in, or nearest to.
Limb nearestLimb(const Ogre::Vector3& position);

struct BoneShare {
    int bone = 0;
    float weight = 0.0f;
};

/// Up to four bones that move a point of the skin, weights summing to 1.
std::vector<BoneShare> boneShares(const Ogre::Vector3& position);

/// Where a point lies on a limb: x turns round it, 0..1 from the belly or the inner side; y metres along its bones.
Ogre::Vector2 limbCoordinates(Limb limb, const Ogre::Vector3& position);

} // namespace lodsmith::media
