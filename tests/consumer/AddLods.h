#pragma once

#include <OgreMesh.h>

/// Gives a loaded mesh two levels of detail. This is the example of the README; a test keeps the two alike.
bool addLods(const Ogre::MeshPtr& mesh);
