#include "RenderSession.h"

#include <OgreCamera.h>
#include <OgreEntity.h>
#include <OgreException.h>
#include <OgreLogManager.h>
#include <OgreMeshManager.h>
#include <OgrePixelFormat.h>
#include <OgreRenderWindow.h>
#include <OgreResourceGroupManager.h>
#include <OgreRoot.h>
#include <OgreSceneManager.h>
#include <OgreSceneNode.h>
#include <OgreViewport.h>

#include <algorithm>
#include <stdexcept>

namespace lodsmith::test {

std::vector<bool> Picture::silhouette() const
{
    std::vector<bool> covered(rgb.size() / 3);
    for (std::size_t i = 0; i < covered.size(); ++i)
        covered[i] = rgb[3 * i] || rgb[3 * i + 1] || rgb[3 * i + 2];
    return covered;
}

std::size_t Picture::pixelsCovered() const
{
    const std::vector<bool> covered = silhouette();
    return static_cast<std::size_t>(std::count(covered.begin(), covered.end(), true));
}

RenderSession::RenderSession(std::uint32_t width, std::uint32_t height) : mLogs(std::make_unique<Ogre::LogManager>())
{
    try {
        startOgre();
        openWindow(width, height);
        // The programs that OGRE throws shadow volumes with.
        auto& resources = Ogre::ResourceGroupManager::getSingleton();
        resources.addResourceLocation(LODSMITH_OGRE_MEDIA_DIR "/ShadowVolume", "FileSystem", Ogre::RGN_INTERNAL);
        resources.initialiseAllResourceGroups();
        addLocation(directory().string(), mGroup);
    } catch (const Ogre::Exception& exception) {
        // Its type may be in a plugin, which is about to be unloaded.
        throw std::runtime_error(exception.what());
    }
}

RenderSession::~RenderSession() = default;

void RenderSession::startOgre()
{
    mLogs->createLog("", true, false, true);
    mRoot = std::make_unique<Ogre::Root>("", "", "");
    mRoot->loadPlugin(LODSMITH_OGRE_PLUGIN_DIR "/RenderSystem_GL");
    mRoot->loadPlugin(LODSMITH_OGRE_PLUGIN_DIR "/Codec_STBI");
    Ogre::RenderSystem* system = mRoot->getRenderSystemByName("OpenGL Rendering Subsystem");
    mRoot->setRenderSystem(system);
    mRoot->initialise(false);
}

void RenderSession::openWindow(std::uint32_t width, std::uint32_t height)
{
    mWindow = mRoot->createRenderWindow("Lodsmith tests", width, height, false);
    mScene = mRoot->createSceneManager();
    mScene->setAmbientLight(Ogre::ColourValue::White);
    mCamera = mScene->createCamera("camera");
    mCamera->setNearClipDistance(0.1f);
    mCamera->setFarClipDistance(0); // none
    mCamera->setAutoAspectRatio(true);
    mCameraNode = mScene->getRootSceneNode()->createChildSceneNode();
    mCameraNode->attachObject(mCamera);
    mViewport = mWindow->addViewport(mCamera);
}

void RenderSession::addLocation(const std::string& folder, const std::string& group)
{
    auto& resources = Ogre::ResourceGroupManager::getSingleton();
    resources.createResourceGroup(group);
    resources.addResourceLocation(folder, "FileSystem", group);
    resources.initialiseResourceGroup(group);
}

Ogre::Entity& RenderSession::show(const Ogre::MeshPtr& mesh, const Ogre::Vector3& position)
{
    Ogre::Entity* entity = mScene->createEntity(mesh);
    mScene->getRootSceneNode()->createChildSceneNode(position)->attachObject(entity);
    return *entity;
}

Ogre::RenderTarget::FrameStats RenderSession::frame()
{
    mRoot->renderOneFrame();
    return mWindow->getStatistics();
}

Picture RenderSession::picture()
{
    frame();
    const Ogre::Rect shown = mViewport->getActualDimensions();
    Picture picture{static_cast<std::uint32_t>(shown.width()), static_cast<std::uint32_t>(shown.height()), {}};
    picture.rgb.resize(std::size_t(3) * picture.width * picture.height);
    const Ogre::Box all(0, 0, picture.width, picture.height), part(shown.left, shown.top, shown.right, shown.bottom);
    mWindow->copyContentsToMemory(part, Ogre::PixelBox(all, Ogre::PF_BYTE_RGB, picture.rgb.data()));
    return picture;
}

Ogre::MeshPtr RenderSession::load(const std::filesystem::path& file)
{
    const std::string group = file.parent_path().string();
    if (!Ogre::ResourceGroupManager::getSingleton().resourceGroupExists(group))
        addLocation(group, group);
    return Ogre::MeshManager::getSingleton().load(file.filename().string(), group);
}

} // namespace lodsmith::test
