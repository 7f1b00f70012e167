#include "FileLocations.h"

#include <algorithm>

namespace lodsmith {

namespace {

const Ogre::ResourceGroupManager::LocationList& locationsOf(const Ogre::String& group)
{
    static const Ogre::ResourceGroupManager::LocationList none;
    auto& groups = Ogre::ResourceGroupManager::getSingleton();
    return groups.resourceGroupExists(group) ? groups.getResourceLocationList(group) : none;
}

} // namespace

const Ogre::Archive* directoryWith(const Ogre::String& name, const Ogre::String& group)
{
    const auto& locations = locationsOf(group);
    const auto found = std::find_if(locations.rbegin(), locations.rend(), [&](const auto& location) {
        return location.archive->getType() == "FileSystem" && location.archive->exists(name);
    });
    return found == locations.rend() ? nullptr : found->archive;
}

void listAgain(const Ogre::String& directory, const Ogre::String& group)
{
    const auto& locations = locationsOf(group);
    const auto found = std::find_if(locations.begin(), locations.end(),
                                    [&](const auto& location) { return location.archive->getName() == directory; });
    if (found == locations.end())
        return;
    const bool isRecursive = found->recursive;
    const bool isReadOnly = found->archive->isReadOnly();
    const Ogre::String name = directory;
    auto& groups = Ogre::ResourceGroupManager::getSingleton();
    groups.removeResourceLocation(name, group);
    groups.addResourceLocation(name, "FileSystem", group, isRecursive, isReadOnly);
}

} // namespace lodsmith
