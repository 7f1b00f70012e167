#pragma once

#include <OgrePrerequisites.h>

#include <filesystem>

namespace lodsmith {

/// The second name that a hand-made level is looked for by: the path relative to the definition.
inline Ogre::String besideDefinition(const Ogre::String& definitionName, const Ogre::String& meshName)
{
    return (std::filesystem::path(definitionName).parent_path() / meshName).lexically_normal().generic_string();
}

} // namespace lodsmith
