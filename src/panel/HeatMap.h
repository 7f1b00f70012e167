#pragma once

#include <lodsmith/core/MeshView.h>

#include <OgreColourValue.h>
#include <OgreMaterial.h>

#include <vector>

namespace Ogre {
class ManualObject;
class SceneManager;
class SceneNode;
} // namespace Ogre

namespace lodsmith {

/// The colour of a share of the scale, 0..1: blue, green, yellow, red. What is beyond counts as 0 or 1.
Ogre::ColourValue heatColour(float share);

/// A mesh in a scene with a colour for each vertex. The scene lives longer than it does.
class HeatMap {
public:
    /// @param material one that shows the vertices' colours
    HeatMap(Ogre::SceneNode& node, const Ogre::MaterialPtr& material);
    ~HeatMap();
    HeatMap(const HeatMap&) = delete;
    HeatMap& operator=(const HeatMap&) = delete;

    /// Makes it anew.
    /// @param values for each vertex buffer one number a vertex, 0..scale
    void paint(const MeshView& mesh, const std::vector<std::vector<float>>& values, double scale);
    void setVisible(bool visible);

private:
    Ogre::SceneManager& mScene;
    Ogre::MaterialPtr mMaterial;
    Ogre::ManualObject* mObject;
};

} // namespace lodsmith
