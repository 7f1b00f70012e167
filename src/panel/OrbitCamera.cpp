#include "OrbitCamera.h"

#include <OgreCamera.h>
#include <OgreSceneNode.h>

#include <algorithm>
#include <cmath>

namespace lodsmith {

namespace {

constexpr float kRadiansPerPixel = 0.01f;
constexpr float kMaxPitch = 1.55f; // just short of looking straight down
constexpr float kZoomStep = 0.85f;
constexpr float kMaxPixels = 1e4f; // of one drag
constexpr float kMaxWheelSteps = 100;
constexpr float kRoomAround = 1.05f;

float limited(float number, float limit)
{
    return std::isfinite(number) ? std::clamp(number, -limit, limit) : 0.0f;
}

} // namespace

OrbitCamera::OrbitCamera(Ogre::Camera& camera, Ogre::SceneNode& node) : mCamera(camera), mNode(node)
{
    place();
}

void OrbitCamera::frame(const Ogre::AxisAlignedBox& bounds, float radius)
{
    const bool hasSize = bounds.isFinite() && bounds.getHalfSize().length() > 0;
    mCentre = bounds.isFinite() ? bounds.getCenter() : Ogre::Vector3::ZERO;
    mRadius = hasSize ? bounds.getHalfSize().length() : 1.0f;
    mTarget = mCentre;
    mYaw = Ogre::Radian(0.6f);
    mPitch = Ogre::Radian(0.3f);
    setDistance(kRoomAround * (hasSize ? distanceToSee(bounds, radius) : 3.0f));
}

/// From which all corners of a box around the target are inside the picture, or the sphere if that is nearer.
float OrbitCamera::distanceToSee(const Ogre::AxisAlignedBox& box, float radius) const
{
    const float up = std::tan(mCamera.getFOVy().valueRadians() / 2), aside = up * mCamera.getAspectRatio();
    const Ogre::Quaternion toView = orientation().Inverse();
    float toBox = 0;
    for (const Ogre::Vector3& corner : box.getAllCorners()) {
        const Ogre::Vector3 seen = toView * (corner - box.getCenter());
        toBox = std::max(toBox, seen.z + std::max(std::abs(seen.x) / aside, std::abs(seen.y) / up));
    }
    const float around = radius + box.getCenter().length();
    const float toSphere = around / std::sin(std::atan(std::min(up, aside)));
    return around > 0 ? std::min(toBox, toSphere) : toBox;
}

Ogre::Quaternion OrbitCamera::orientation() const
{
    return Ogre::Quaternion(mYaw, Ogre::Vector3::UNIT_Y) * Ogre::Quaternion(-mPitch, Ogre::Vector3::UNIT_X);
}

void OrbitCamera::orbit(float dx, float dy)
{
    const float yaw = mYaw.valueRadians() - limited(dx, kMaxPixels) * kRadiansPerPixel;
    const float pitch = mPitch.valueRadians() + limited(dy, kMaxPixels) * kRadiansPerPixel;
    mYaw = Ogre::Radian(std::remainder(yaw, Ogre::Math::TWO_PI));
    mPitch = Ogre::Radian(std::clamp(pitch, -kMaxPitch, kMaxPitch));
    place();
}

void OrbitCamera::pan(float dx, float dy, float viewportHeight)
{
    const float unitsPerPixel =
        2 * mDistance * std::tan(mCamera.getFOVy().valueRadians() / 2) / std::max(viewportHeight, 1.0f);
    const Ogre::Vector3 way(-limited(dx, kMaxPixels) * unitsPerPixel, limited(dy, kMaxPixels) * unitsPerPixel, 0);
    const Ogre::Vector3 target = mTarget + mNode.getOrientation() * way;
    if ((target - mCentre).length() <= maxDistance())
        mTarget = target;
    place();
}

void OrbitCamera::zoom(float steps)
{
    setDistance(mDistance * std::pow(kZoomStep, limited(steps, kMaxWheelSteps)));
}

void OrbitCamera::setDistance(float distance)
{
    mDistance = std::clamp(distance, minDistance(), maxDistance());
    place();
}

void OrbitCamera::place()
{
    const Ogre::Quaternion turned = orientation();
    mNode.setOrientation(turned);
    mNode.setPosition(mTarget + turned * Ogre::Vector3(0, 0, mDistance));
    // Between the planes there is room for animations that reach beyond the bounds at rest.
    const float toCentre = (mNode.getPosition() - mCentre).length(), reach = 3 * mRadius;
    mCamera.setNearClipDistance(std::max({toCentre - reach, 0.005f * mDistance, 1e-5f * mRadius}));
    mCamera.setFarClipDistance(toCentre + reach);
}

} // namespace lodsmith
