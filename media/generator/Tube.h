#pragma once

#include "Shape.h"

namespace lodsmith::media {

/// One ring of a tube.
struct TubeRing {
    Ogre::Vector3 centre;
    float radius = 0.0f;
};

/// Sweeps a circle along rings, smooth all over, with one texture seam along its length; open at both ends.
/// @param sides      corners of the circle
/// @param uvRepeats  how often the texture goes round; along the tube it keeps its proportion
void addTube(Shape& shape, const std::vector<TubeRing>& rings, std::uint32_t sides, float uvRepeats);

/// One corner of a lathe's profile, from the axis at the bottom outwards and up.
struct ProfilePoint {
    float radius = 0.0f;
    float height = 0.0f;
    bool hard = true; ///< an edge with two normals and a texture seam; otherwise smooth
};

/// Turns a profile round the Y axis of `placement`; texture seams at angle 0 and along hard corners.
void addLathe(Shape& shape, const Placement& placement, const std::vector<ProfilePoint>& profile, std::uint32_t sides,
              float uvScale);

/// A closed ring in the XY plane of `placement`.
void addTorus(Shape& shape, const Placement& placement, float ringRadius, float wireRadius, std::uint32_t ringSides,
              std::uint32_t wireSides, float uvScale);

} // namespace lodsmith::media
