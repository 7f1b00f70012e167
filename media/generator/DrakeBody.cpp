#include "DrakeBody.h"

#include <OgreMath.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace lodsmith::media {

namespace {

using Ogre::Vector2;
using Ogre::Vector3;

constexpr float kBlend = 0.032f; ///< metres over which neighbouring cones flow into each other

void addSpine(std::vector<DrakeBone>& bones)
{
    bones.push_back({"root", -1, Vector3::ZERO, Vector3::ZERO, 0, 0, Limb::Torso});
    bones.push_back({"pelvis", 0, {0, 0.77f, -0.48f}, {0, 0.79f, -0.15f}, 0.205f, 0.215f, Limb::Torso});
    bones.push_back({"spine", 1, {0, 0.79f, -0.15f}, {0, 0.82f, 0.20f}, 0.215f, 0.25f, Limb::Torso});
    bones.push_back({"chest", 2, {0, 0.82f, 0.20f}, {0, 0.87f, 0.46f}, 0.25f, 0.19f, Limb::Torso});
    bones.push_back({"neck1", 3, {0, 0.90f, 0.48f}, {0, 1.12f, 0.76f}, 0.175f, 0.115f, Limb::Neck});
    bones.push_back({"neck2", 4, {0, 1.12f, 0.76f}, {0, 1.36f, 0.95f}, 0.115f, 0.105f, Limb::Neck});
    bones.push_back({"head", 5, {0, 1.40f, 1.0f}, {0, 1.35f, 1.44f}, 0.118f, 0.058f, Limb::Neck});
    bones.push_back({"jaw", 6, {0, 1.31f, 1.04f}, {0, 1.24f, 1.38f}, 0.07f, 0.038f, Limb::Neck});
    bones.push_back({"tail1", 1, {0, 0.75f, -0.52f}, {0, 0.67f, -0.95f}, 0.17f, 0.125f, Limb::Tail});
    bones.push_back({"tail2", 8, {0, 0.67f, -0.95f}, {0, 0.55f, -1.35f}, 0.125f, 0.09f, Limb::Tail});
    bones.push_back({"tail3", 9, {0, 0.55f, -1.35f}, {0, 0.49f, -1.75f}, 0.09f, 0.06f, Limb::Tail});
    bones.push_back({"tail4", 10, {0, 0.49f, -1.75f}, {0, 0.54f, -2.2f}, 0.06f, 0.028f, Limb::Tail});
}

/// @param side  1 for left (+X), -1 for right
void addLegs(std::vector<DrakeBone>& bones, float side, const std::string& suffix)
{
    const Limb front = side > 0 ? Limb::FrontLeft : Limb::FrontRight,
               hind = side > 0 ? Limb::HindLeft : Limb::HindRight;
    const auto at = [side](float x, float y, float z) { return Vector3(side * x, y, z); };
    const int first = int(bones.size());
    bones.push_back(
        {"front_upper" + suffix, 3, at(0.19f, 0.80f, 0.38f), at(0.33f, 0.47f, 0.26f), 0.125f, 0.08f, front});
    bones.push_back(
        {"front_lower" + suffix, first, at(0.33f, 0.47f, 0.26f), at(0.36f, 0.13f, 0.40f), 0.08f, 0.056f, front});
    bones.push_back(
        {"front_foot" + suffix, first + 1, at(0.36f, 0.085f, 0.40f), at(0.385f, 0.05f, 0.57f), 0.072f, 0.056f, front});
    bones.push_back(
        {"hind_upper" + suffix, 1, at(0.16f, 0.74f, -0.46f), at(0.33f, 0.48f, -0.30f), 0.175f, 0.105f, hind});
    bones.push_back(
        {"hind_lower" + suffix, first + 3, at(0.33f, 0.48f, -0.30f), at(0.35f, 0.17f, -0.58f), 0.105f, 0.058f, hind});
    bones.push_back(
        {"hind_foot" + suffix, first + 4, at(0.35f, 0.09f, -0.56f), at(0.375f, 0.05f, -0.38f), 0.072f, 0.058f, hind});
}

/// Place of the closest point of a bone's axis: 0 at its start, 1 at its end, beyond both outside of it.
float placeAlong(const DrakeBone& bone, const Vector3& position)
{
    const Vector3 axis = bone.to - bone.from;
    return (position - bone.from).dotProduct(axis) / axis.squaredLength();
}

struct Nearness {
    float distance = 0.0f; ///< to the axis
    float radius = 0.0f;   ///< of the flesh there
};

Nearness nearness(const DrakeBone& bone, const Vector3& position)
{
    const float t = Ogre::Math::Clamp(placeAlong(bone, position), 0.0f, 1.0f);
    return {position.distance(bone.from + (bone.to - bone.from) * t),
            bone.fromRadius + (bone.toRadius - bone.fromRadius) * t};
}

/// Flesh that no bone carries of its own: brows and the ridge of the muzzle.
std::vector<DrakeBone> makeFeatures()
{
    std::vector<DrakeBone> features;
    for (const float side : {-1.0f, 1.0f})
        features.push_back(
            {"brow", 6, {side * 0.078f, 1.478f, 1.0f}, {side * 0.066f, 1.432f, 1.19f}, 0.03f, 0.026f, Limb::Neck});
    features.push_back({"muzzle", 6, {0, 1.40f, 1.12f}, {0, 1.385f, 1.45f}, 0.06f, 0.036f, Limb::Neck});
    return features;
}

Vector3 seamDirection(Limb limb)
{
    switch (limb) {
    case Limb::FrontLeft:
    case Limb::HindLeft: return Vector3::NEGATIVE_UNIT_X;
    case Limb::FrontRight:
    case Limb::HindRight: return Vector3::UNIT_X;
    default: return Vector3::NEGATIVE_UNIT_Y;
    }
}

} // namespace

const std::vector<DrakeBone>& drakeBones()
{
    static const std::vector<DrakeBone> bones = [] {
        std::vector<DrakeBone> all;
        addSpine(all);
        addLegs(all, 1.0f, ".L");
        addLegs(all, -1.0f, ".R");
        return all;
    }();
    return bones;
}

int drakeBone(const std::string& name)
{
    const auto& bones = drakeBones();
    const auto found =
        std::find_if(bones.begin(), bones.end(), [&](const DrakeBone& bone) { return bone.name == name; });
    if (found == bones.end())
        throw std::runtime_error("the drake has no bone " + name);
    return int(found - bones.begin());
}

float drakeField(const Vector3& position)
{
    static const std::vector<DrakeBone> features = makeFeatures();
    double sum = 0.0;
    const auto add = [&](const DrakeBone& bone) {
        const Nearness near = nearness(bone, position);
        sum += std::exp(-double(near.distance - near.radius) / kBlend);
    };
    for (const DrakeBone& bone : drakeBones())
        if (bone.parent >= 0)
            add(bone);
    for (const DrakeBone& feature : features)
        add(feature);
    return float(-kBlend * std::log(sum));
}

Limb nearestLimb(const Vector3& position)
{
    const DrakeBone* best = nullptr;
    float least = 0.0f;
    for (const DrakeBone& bone : drakeBones()) {
        const Nearness near = nearness(bone, position);
        if (bone.parent >= 0 && (!best || near.distance - near.radius < least)) {
            best = &bone;
            least = near.distance - near.radius;
        }
    }
    return best->limb;
}

std::vector<BoneShare> boneShares(const Vector3& position)
{
    constexpr float kSharpness = 5.5f, kLeastShare = 0.03f;
    std::vector<BoneShare> shares;
    for (std::size_t i = 0; i < drakeBones().size(); ++i) {
        const DrakeBone& bone = drakeBones()[i];
        if (bone.parent < 0)
            continue;
        const Nearness near = nearness(bone, position);
        shares.push_back({int(i), std::exp(-kSharpness * near.distance / near.radius)});
    }
    std::sort(shares.begin(), shares.end(), [](const auto& a, const auto& b) { return a.weight > b.weight; });
    shares.resize(4);
    const float strongest = shares.front().weight;
    while (shares.back().weight < kLeastShare * strongest)
        shares.pop_back();
    float sum = 0.0f;
    for (const BoneShare& share : shares)
        sum += share.weight;
    for (BoneShare& share : shares)
        share.weight /= sum;
    return shares;
}

Vector2 limbCoordinates(Limb limb, const Vector3& position)
{
    const DrakeBone* closest = nullptr;
    float start = 0.0f, closestStart = 0.0f, least = 0.0f;
    for (const DrakeBone& bone : drakeBones()) {
        if (bone.limb != limb || bone.parent < 0 || bone.name == "jaw")
            continue;
        const Nearness near = nearness(bone, position);
        if (!closest || near.distance < least) {
            closest = &bone;
            closestStart = start;
            least = near.distance;
        }
        start += bone.from.distance(bone.to);
    }
    const Vector3 axis = closest->to - closest->from, tangent = axis.normalisedCopy();
    const float along = placeAlong(*closest, position);
    const Vector3 seam = seamDirection(limb);
    const Vector3 across = (seam - tangent * seam.dotProduct(tangent)).normalisedCopy();
    const Vector3 aside = position - closest->from - axis * along;
    const float angle = std::atan2(aside.dotProduct(tangent.crossProduct(across)), aside.dotProduct(across));
    const float turn = angle / Ogre::Math::TWO_PI;
    return Vector2(turn < 0.0f ? turn + 1.0f : turn, closestStart + along * axis.length());
}

} // namespace lodsmith::media
