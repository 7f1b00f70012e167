#include "OgreSession.h"

#include <OgreDefaultHardwareBufferManager.h>
#include <OgreLogManager.h>
#include <OgreMaterialManager.h>
#include <OgreMeshManager.h>
#include <OgreMeshSerializer.h>
#include <OgreResourceGroupManager.h>
#include <OgreRoot.h>

namespace lodsmith::test {

OgreSession::OgreSession(const std::string& pluginsFile) : mLogs(std::make_unique<Ogre::LogManager>())
{
    mLogs->createLog("", true, false, true);
    mRoot = std::make_unique<Ogre::Root>(pluginsFile, "", "");
    mBuffers = std::make_unique<Ogre::DefaultHardwareBufferManager>();
    Ogre::MaterialManager::getSingleton().initialise();
    auto& resources = Ogre::ResourceGroupManager::getSingleton();
    resources.createResourceGroup(mGroup);
    resources.addResourceLocation(directory().string(), "FileSystem", mGroup);
    resources.initialiseResourceGroup(mGroup);
}

OgreSession::~OgreSession()
{
    mRoot.reset();
    mBuffers.reset();
}

Ogre::MeshPtr OgreSession::saveAndReload(const Ogre::MeshPtr& mesh)
{
    const std::string name = "saved" + std::to_string(mSaved++) + ".mesh";
    Ogre::MeshSerializer().exportMesh(mesh.get(), (directory() / name).string());
    return loadSaved(name);
}

Ogre::MeshPtr OgreSession::loadSaved(const std::string& name)
{
    // OGRE lists a location once, when it is added.
    auto& resources = Ogre::ResourceGroupManager::getSingleton();
    resources.removeResourceLocation(directory().string(), mGroup);
    resources.addResourceLocation(directory().string(), "FileSystem", mGroup);
    return Ogre::MeshManager::getSingleton().load(name, mGroup);
}

Ogre::MeshPtr OgreSession::load(const std::filesystem::path& file)
{
    auto& resources = Ogre::ResourceGroupManager::getSingleton();
    const std::string group = file.parent_path().string();
    if (!resources.resourceGroupExists(group)) {
        resources.createResourceGroup(group);
        resources.addResourceLocation(group, "FileSystem", group);
        resources.initialiseResourceGroup(group);
    }
    return Ogre::MeshManager::getSingleton().load(file.filename().string(), group);
}

} // namespace lodsmith::test
