#pragma once

#include <lodsmith/ogre/LodManager.h>

namespace lodsmith::samples {

/// Made after Ogre::Root and destroyed before it: every mesh that is loaded meanwhile gets levels.
struct LibraryLods {
    lodsmith::LodDefinitionManager definitions;       // finds the .loddef files
    lodsmith::QueuedProgressiveMeshGenerator queue;   // makes levels in the background
    lodsmith::LodManager manager{definitions, queue}; // says what each mesh gets
};

} // namespace lodsmith::samples
