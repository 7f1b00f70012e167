#pragma once

#include <lodsmith/render/Viewpoint.h>

#include <OgreQuaternion.h>

#include <vector>

namespace lodsmith {

/// Room that pictures keep around what they show, pixels.
constexpr int kMargin = 8;

/// The part of a screen that shows something.
struct ScreenPart {
    int left = 0; ///< pixels from the middle of the screen, to the right
    int right = 1;
    int bottom = 0; ///< upwards
    int top = 1;
    double near = 1.0; ///< world units from the camera: what is there is between the two, which are above 0
    double far = 2.0;

    unsigned width() const { return static_cast<unsigned>(right - left); }
    unsigned height() const { return static_cast<unsigned>(top - bottom); }
};

/// How a camera in a direction from its target is turned to look at it.
Ogre::Quaternion orientationOf(const Ogre::Vector3& direction);

/// Where points are on the screen, with kMargin around; all of it when one is beside the camera or behind, and at least
/// a pixel.
ScreenPart screenPartOf(const std::vector<Ogre::Vector3>& points, const Viewpoint& viewpoint);

/// From where points fill a square screen up to kMargin of each side, seen towards the middle of their bounding box.
/// @param size pixels, above 2 * kMargin
Viewpoint viewpointFor(const std::vector<Ogre::Vector3>& points, const Ogre::Vector3& direction, unsigned size);

} // namespace lodsmith
