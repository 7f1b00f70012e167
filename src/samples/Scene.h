#pragma once

#include "Window.h"

#include <OgreEntity.h>
#include <OgreRenderTarget.h>
#include <OgreSceneManager.h>
#include <OgreSimpleSpline.h>

#include <vector>

namespace lodsmith::samples {

/// A valley full of trees, cottages, lanterns and drakes, the models of media/, up to the horizon, and a camera that goes round
/// in it.
class Scene {
public:
    Scene(Engine& engine, Ogre::RenderTarget& target, unsigned objects);

    Ogre::SceneManager& manager() { return *mManager; }

    /// Puts the camera at a place of its round, 0..1, and lets animated models go on by some seconds.
    void update(double share, double seconds);

private:
    void makeSkyAndGround();
    void place(unsigned objects);
    void makeCamera(Ogre::RenderTarget& target);

    Ogre::SceneManager* mManager = nullptr;
    Ogre::SceneNode* mCameraNode = nullptr;
    Ogre::SimpleSpline mPath;
    std::vector<Ogre::Entity*> mAnimated;
};

} // namespace lodsmith::samples
