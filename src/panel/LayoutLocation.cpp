#include "LayoutLocation.h"

#include <CEGUI/DefaultResourceProvider.h>
#include <CEGUI/RendererModules/Ogre/ResourceProvider.h>
#include <CEGUI/System.h>
#include <CEGUI/WindowManager.h>

#include <OgreResourceGroupManager.h>

#include <exception>

namespace lodsmith {

namespace {

const char* const kGroup = "Lodsmith layouts";

CEGUI::DefaultResourceProvider* plainFiles()
{
    return dynamic_cast<CEGUI::DefaultResourceProvider*>(CEGUI::System::getSingleton().getResourceProvider());
}

} // namespace

Result<Done> LayoutLocation::check()
{
    auto* provider = CEGUI::System::getSingleton().getResourceProvider();
    if (plainFiles() || dynamic_cast<CEGUI::OgreResourceProvider*>(provider))
        return Done{};
    return Error{ErrorCode::Unsupported, "CEGUI's resource provider is neither OGRE's nor the default one"};
}

LayoutLocation::LayoutLocation(const std::filesystem::path& directory)
    : mBefore(CEGUI::WindowManager::getDefaultResourceGroup())
{
    if (auto* files = plainFiles()) {
        files->setResourceGroupDirectory(kGroup, directory.string());
    } else {
        auto& groups = Ogre::ResourceGroupManager::getSingleton();
        groups.createResourceGroup(kGroup, false);
        groups.addResourceLocation(directory.string(), "FileSystem", kGroup);
    }
    CEGUI::WindowManager::setDefaultResourceGroup(kGroup);
}

LayoutLocation::~LayoutLocation()
{
    try {
        CEGUI::WindowManager::setDefaultResourceGroup(mBefore);
        if (auto* files = plainFiles())
            files->clearResourceGroupDirectory(kGroup);
        else
            Ogre::ResourceGroupManager::getSingleton().destroyResourceGroup(kGroup);
    } catch (const std::exception&) {
        return; // no memory for a name: there is none for a message either
    }
}

} // namespace lodsmith
