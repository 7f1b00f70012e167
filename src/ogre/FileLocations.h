#pragma once

#include <lodsmith/core/Result.h>

#include <OgreArchive.h>
#include <OgreResourceGroupManager.h>

#include <filesystem>

namespace lodsmith {

/// The directory among a group's locations that has a file of this name on disk; of several the one that OGRE reads from.
/// Null when there is none.
const Ogre::Archive* directoryWith(const Ogre::String& name, const Ogre::String& group);

/// Lets a group know of the files that have come to one of its directories: OGRE lists them once, when it is added.
void listAgain(const Ogre::String& directory, const Ogre::String& group);

} // namespace lodsmith
