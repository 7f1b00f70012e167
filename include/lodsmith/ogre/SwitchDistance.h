#pragma once

#include <lodsmith/core/Export.h>
#include <lodsmith/core/Result.h>

#include <OgreMesh.h>

namespace lodsmith {

/// What a mesh is looked at with: a perspective camera whose aspect ratio is its viewport's.
struct View {
    double width = 1920.0;                   ///< of the viewport, pixels, > 0
    double height = 1080.0;                  ///< pixels, > 0
    double fieldOfView = 0.7853981633974483; ///< radians, vertical, between 0 and pi
};

/// The distance in world units between the camera and the node of an entity of this mesh, at scale 1, from which on
/// OGRE draws a level of a value, by the mesh's strategy and bounds:
///
/// - distance_sphere counts to where a tangent touches the bounding sphere: sqrt(value^2 + radius^2);
/// - distance_box counts to the box, whose surface is as far from its centre, on the mean of the three axes, as half
///   its mean extent;
/// - pixel_count and screen_ratio_pixel_count look for the distance at which the bounding sphere's disc has that area
///   on screen (automaticLodConfig() has the formula).
///
/// A pixel count of 0 is never fallen below: infinite.
/// Errors: Unsupported (a strategy of the program's own), InvalidSetting (a value below 0 or not finite); file is the
/// mesh's name. Misuse: a view out of range. Main thread only, as MeshReader.
LODSMITH_API Result<double> switchDistance(const Ogre::Mesh& mesh, double value, const View& view);

/// The number of pixels of a viewport that the disc of a mesh's bounding radius covers at a distance in world units, >
/// 0.
LODSMITH_API double pixelsAt(const Ogre::Mesh& mesh, double distance, const View& view);

} // namespace lodsmith
