#pragma once

#include <lodsmith/core/Export.h>

#include <OgreAxisAlignedBox.h>
#include <OgreMath.h>
#include <OgreVector.h>

namespace Ogre {
class Camera;
class SceneNode;
} // namespace Ogre

namespace lodsmith {

/// Moves a camera around a thing, so that it always looks at a target point. The camera has a node of its own at the root of its
/// scene, and both live longer than this object.
class LODSMITH_API OrbitCamera {
public:
    /// How far the camera may go away, in radii of the thing.
    static constexpr float kMaxRadii = 1e6f;

    OrbitCamera(Ogre::Camera& camera, Ogre::SceneNode& node);

    /// What it goes around, and back to where all of it is seen, somewhat from above.
    /// @param radius of a sphere around the origin that it is in too
    void frame(const Ogre::AxisAlignedBox& bounds, float radius);

    /// Pixels of a drag: the thing turns with it.
    void orbit(float dx, float dy);
    /// Pixels of a drag: the thing moves with it.
    void pan(float dx, float dy, float viewportHeight);
    /// Steps of a wheel: positive comes nearer.
    void zoom(float steps);

    /// World units from the target.
    float distance() const { return mDistance; }
    /// Limited to minDistance()..maxDistance().
    void setDistance(float distance);
    float minDistance() const { return 1e-3f * mRadius; }
    float maxDistance() const { return kMaxRadii * mRadius; }

private:
    void place();
    Ogre::Quaternion orientation() const;
    float distanceToSee(const Ogre::AxisAlignedBox& box, float radius) const;

    Ogre::Camera& mCamera;
    Ogre::SceneNode& mNode;
    Ogre::Vector3 mCentre = Ogre::Vector3::ZERO; ///< of the thing
    Ogre::Vector3 mTarget = Ogre::Vector3::ZERO;
    float mRadius = 1;
    float mDistance = 3;
    Ogre::Radian mYaw{0};
    Ogre::Radian mPitch{0};
};

} // namespace lodsmith
