#include "OgreSession.h"

#include <OgreDefaultHardwareBufferManager.h>
#include <OgreLogManager.h>
#include <OgreMaterialManager.h>
#include <OgreMeshLodGenerator.h>
#include <OgreRoot.h>

namespace lodsmith::benchmarks {

OgreSession::OgreSession() : mLogManager(std::make_unique<Ogre::LogManager>())
{
    mLogManager->createLog("", true, false, true);
    mRoot = std::make_unique<Ogre::Root>("", "", "");
    mBufferManager = std::make_unique<Ogre::DefaultHardwareBufferManager>();
    Ogre::MaterialManager::getSingleton().initialise();
    mMeshLodGenerator = std::make_unique<Ogre::MeshLodGenerator>();
}

OgreSession::~OgreSession() = default;

} // namespace lodsmith::benchmarks
