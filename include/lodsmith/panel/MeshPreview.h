#pragma once

#include <lodsmith/core/Export.h>
#include <lodsmith/core/Result.h>

#include <OgreMesh.h>
#include <OgreTexture.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace lodsmith {

class LevelAnalyser;

/// How the preview paints a mesh.
enum class ViewMode {
    Shaded,    ///< with its own materials; grey where one is missing or cannot be used
    Flat,      ///< grey, each triangle in one shade
    Wireframe, ///< lines over a surface that hides those behind it
    Checker,   ///< squares by the first texture coordinates; grey without them
    Deviation, ///< level 0 at rest, each vertex coloured by its distance to the level's surface
};

/// How the preview shows two levels at once.
enum class CompareMode {
    Off,
    SideBySide, ///< one half each, the same view
    Wipe,       ///< one view, the first level left of an edge and the second right of it
};

/// A mesh in a picture of its own, to be looked at from all sides, at any level, in several modes. It draws into a texture, and
/// only in update(), when something has changed: the view, a setting, the mesh or its levels, or while an animation plays.
///
/// The mesh may be changed in any way while it is shown: levels of any kind come and go, it may be unloaded, loaded again or
/// removed. The picture is empty without a mesh, and while it is not loaded.
///
/// It has a scene of its own, with an entity that counts as alive for LodPolicy::reinitialiseEntities. Needs a render system with
/// fixed functions (RenderSystem_GL) and a window, for it makes materials without shaders; isPossible() tells. Made after
/// these, and destroyed before them. Main thread only.
class LODSMITH_API MeshPreview {
public:
    /// Whether OGRE can draw one: errors say what is missing (Unsupported).
    static Result<Done> isPossible();

    /// @param analyser measures for ViewMode::Deviation; lives longer than this object
    explicit MeshPreview(LevelAnalyser& analyser);
    ~MeshPreview();
    MeshPreview(const MeshPreview&) = delete;
    MeshPreview& operator=(const MeshPreview&) = delete;

    /// Shows a mesh, which is loaded if need be. Another mesh than before is seen from the front, somewhat from above, at
    /// rest; settings stay. Errors: NotFound for null or when it cannot be loaded; then what was shown stays.
    Result<Done> show(const Ogre::MeshPtr& mesh);
    void clear();
    /// Null when there is none, also when it was removed, from the next update() on.
    const Ogre::MeshPtr& mesh() const;

    /// Forces OGRE's level, from 0 on, the last one when there are not as many; none: the camera decides.
    void setLevel(std::optional<unsigned> level);
    std::optional<unsigned> level() const;
    /// Two levels at once. Off: setLevel() holds again.
    /// @param share where the edge of Wipe is, 0..1 of the width; draw a line there in the window that shows the picture
    void compare(CompareMode mode, unsigned first, unsigned second, float share = 0.5f);
    CompareMode compareMode() const;

    void setMode(ViewMode mode);
    ViewMode mode() const;
    /// What the mode cannot show of this mesh, as a sentence; empty for nothing.
    std::string note() const;

    /// The level in the last picture; the first one's when two are compared.
    unsigned shownLevel() const;
    /// Triangles of the last picture, of both sides when two are compared. ViewMode::Deviation draws level 0.
    std::size_t triangles() const;

    /// World units at the red end of ViewMode::Deviation, blue being none: of the vertices that are off the level 5% are farther
    /// off. Of two levels the greater. None while it is being measured and in other modes. May be 0.
    std::optional<double> deviationScale() const;
    /// Why nothing could be measured; empty when there is no error.
    std::string deviationError() const;

    /// Pixels of a drag over the picture: the mesh follows it.
    void orbit(float dx, float dy);
    void pan(float dx, float dy);
    /// Steps of a wheel; positive comes nearer.
    void zoom(float steps);
    void resetCamera();
    /// World units from the camera to the point it looks at.
    float distance() const;
    /// Moves the camera along its line of sight to where one of OGRE's strategies has a value for this mesh: exactly so far
    /// that a level of that value appears. Values are as users give them (world units, pixels, share of the picture); pixels
    /// are those of the picture, in SideBySide of a half. With no level forced the level is seen at once.
    /// Errors: NotFound without a mesh or for an unknown strategy, InvalidSetting when the value is no number above 0 or is
    /// reached nowhere between the mesh's middle and a million radii.
    Result<Done> viewAt(const std::string& strategy, double value);

    /// Pixels of the picture, limited to 1..4096.
    void resize(unsigned width, unsigned height);
    unsigned width() const;
    unsigned height() const;
    /// The picture is the top left part of it. It is another one after some calls of resize().
    const Ogre::TexturePtr& texture() const;

    /// Names of the skeleton's and the vertices' animations, in order.
    std::vector<std::string> animations() const;
    /// Plays an animation over and over, from its start; the empty string: the mesh at rest. Errors: NotFound.
    Result<Done> play(const std::string& animation);
    /// What plays; empty for nothing.
    const std::string& animation() const;
    /// 1 is the animation's own; 0 stands still, negative goes backwards. Not a number counts as 1.
    void setSpeed(float speed);

    /// Whether an animation plays.
    bool isMoving() const;

    /// Makes the next update() draw, when something has changed that this object cannot know of, as a material.
    void redraw();
    /// Follows the mesh and its levels, moves the animation on, and draws when something has changed. Once a frame.
    /// Returns whether it has drawn. Errors: what OGRE refused (Unsupported); it is tried again after the next change.
    /// @param seconds since the last call
    Result<bool> update(float seconds);

private:
    struct Parts;
    std::unique_ptr<Parts> mParts;
};

} // namespace lodsmith
