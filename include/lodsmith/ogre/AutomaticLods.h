#pragma once

#include <lodsmith/core/Export.h>
#include <lodsmith/core/Simplify.h>
#include <lodsmith/ogre/LodConfig.h>

#include <OgreMesh.h>

#include <optional>
#include <string>

namespace lodsmith {

/// What automatic levels are like. The defaults need no thought.
struct AutomaticLods {
    enum class Method {
        Balanced, ///< nowhere farther off than so many pixels, and as few triangles to draw as that allows
        Classic,  ///< the formula of 2012
    };
    static constexpr unsigned kMaxLevels = 8;
    static constexpr double kMinPixels = 0.1;
    static constexpr double kMaxPixels = 10.0;

    Method method = Method::Balanced;
    /// kMinPixels..kMaxPixels. Balanced: how far a level's surface may be from the mesh's when it appears, in pixels. Classic: 1
    /// is the formula as it was; at 0.5 each level appears at half the radius on screen, so that its error is half as many pixels.
    double pixels = 1.0;
    /// 1..kMaxLevels. Balanced: the most levels; nothing means kMaxLevels. Classic: how many; nothing means four. Fewer leave
    /// out the nearest ones, which save least; more go on towards the horizon.
    std::optional<unsigned> levels = {};
    /// What a collapse costs; nothing means Quadric for balanced and Curvature for classic levels.
    std::optional<Metric> metric = {};
};

/// The automatic configuration of a mesh. Its strategy is pixel_count.
///
/// Balanced: candidate levels at nine sizes, each half of the one before: 512 pixels to 2 pixels of bounding radius on screen, with a
/// LevelTarget::Kind::Deviation of so many pixels there, and LodConfig::mostLevels, so that those levels are stored that leave the
/// fewest triangles to draw. Why this way: docs/automatic-lod.md.
///
/// Classic: levels by LevelTarget::Kind::CollapseCost, which come from a row of sizes, i = 2, 3, 4...: pixels 3388608 / i^4. The
/// levels are the last of i = 2..max(5, levels + 1). What a collapse may cost, R being the mesh's bounding sphere radius:
///
/// - Metric::Curvature: R * i^5 / 100000 up to i = 5, R * i^2 / 800 beyond. The defaults are therefore levels at 211788, 41835,
///   13237 and 5422 pixels with costs of R/3125, R/411, R/97.7 and R/32. Beyond the fourth level the cost stays the same
///   number of pixels.
/// - Metric::Quadric: half a pixel when the level appears, R * i^2 / 2077.
///
/// pixel_count is the area on screen of a disc of the bounding radius that faces the camera at the entity's node: a level
/// appears when the disc has a radius of sqrt(value / pi). OGRE computes that as
/// R * scale / distance from the camera to the node, times half the viewport's height, times cot(vertical field of view / 2);
/// under an orthographic camera it is R * scale in pixels. R counts from the mesh's origin. This holds from OGRE 1.12.6 on,
/// and for cameras that have their viewport's aspect ratio. A deviation of d world units is d / R * sqrt(value / pi) pixels then,
/// whatever the resolution and the field of view.
///
/// The mesh's bounds must be set; settings out of range are misuse. Main thread only, as MeshReader.
LODSMITH_API LodConfig automaticLodConfig(const Ogre::MeshPtr& mesh, const AutomaticLods& automatic = {});

/// What is out of range, as a sentence; empty when nothing is.
LODSMITH_API std::string troubleWith(const AutomaticLods& automatic);

} // namespace lodsmith
