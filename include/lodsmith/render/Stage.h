#pragma once

#include <lodsmith/core/Export.h>

#include <OgrePrerequisites.h>

namespace lodsmith {

/// A scene for one thing to look at: light that comes over the camera's shoulder, and a node for the thing. Ends with
/// the object, or with OGRE if that is earlier.
struct LODSMITH_API Stage {
    /// @param name which no other scene in OGRE has
    explicit Stage(const Ogre::String& name);
    ~Stage();
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;

    Ogre::SceneManager& scene;
    Ogre::SceneNode& cameraNode;
    Ogre::SceneNode& subject;
    Ogre::Camera& camera;
};

} // namespace lodsmith
