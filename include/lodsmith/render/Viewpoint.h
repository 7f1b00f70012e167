#pragma once

#include <lodsmith/core/Export.h>
#include <lodsmith/core/Result.h>

#include <OgreMesh.h>
#include <OgreVector.h>

#include <array>
#include <cstddef>

namespace lodsmith {

/// The screen that a picture is a part of.
struct Screen {
    unsigned width = 1920; ///< pixels, 1 and up
    unsigned height = 1080;
    double fieldOfView = 0.78539816339744831; ///< radians from bottom to top, between 0 and pi; 45 degrees
};

/// Pixels on screen of a length that faces the camera, in world units, in the middle of the screen.
/// @param distance world units from the camera, above 0
LODSMITH_API double pixelsOf(double length, double distance, const Screen& screen);

/// From where a mesh is looked at, in its own coordinates. What is up is y, and -z when seen straight from above.
struct Viewpoint {
    Ogre::Vector3 target = Ogre::Vector3::ZERO;      ///< what is in the middle of the screen
    Ogre::Vector3 direction = Ogre::Vector3::UNIT_Z; ///< from the target to the camera; of length 1
    double distance = 1.0;                           ///< from the target to the camera; above 0
    Screen screen;
};

constexpr std::size_t kViewDirections = 8;

/// The directions in which levels are judged, the same for every mesh, each of length 1: six round about, of which
/// three look down 5 and three 30 degrees, one 75 degrees from above, one 30 degrees from below.
LODSMITH_API const std::array<Ogre::Vector3, kViewDirections>& viewDirections();

/// Where OGRE switches to a level when the camera goes away from the mesh's origin: world units between the two, with
/// the mesh at its own size; infinite for a level that is nowhere reached, as with a value of 0 pixels. As
/// switchDistance() in lodsmith/ogre/SwitchDistance.h, except that distance_box looks in a direction: where the bounds are
/// that far from the camera there. Errors: those of the other one, InvalidSetting (no such level, or level 0), Unsupported (the
/// level is there at any distance).
/// @param direction from the origin to the camera, of length 1
LODSMITH_API Result<double> switchDistance(const Ogre::Mesh& mesh, unsigned level, const Ogre::Vector3& direction,
                                           const Screen& screen = {});

} // namespace lodsmith
