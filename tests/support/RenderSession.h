#pragma once

#include "TestDirectory.h"
#include "VirtualDisplay.h"

#include <OgreMesh.h>
#include <OgreRenderTarget.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace lodsmith::test {

/// What a frame shows: 8 bits each of red, green and blue, rows from the top.
struct Picture {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::vector<std::uint8_t> rgb;

    /// One number a pixel: whether it is anything but black.
    std::vector<bool> silhouette() const;
    std::size_t pixelsCovered() const;
};

/// OGRE with the OpenGL render system and a window that nobody sees, for as long as this object lives;
/// one at a time. There is a scene, black but for what the test puts into it, with ambient light, and a camera at the origin that
/// looks along -Z. Mesh pointers have to be gone before it is.
class RenderSession {
public:
    RenderSession(std::uint32_t width, std::uint32_t height);
    ~RenderSession();
    RenderSession(const RenderSession&) = delete;
    RenderSession& operator=(const RenderSession&) = delete;

    Ogre::SceneManager& scene() { return *mScene; }
    Ogre::Camera& camera() { return *mCamera; }
    Ogre::SceneNode& cameraNode() { return *mCameraNode; }
    Ogre::Viewport& viewport() { return *mViewport; }

    /// Shows a mesh, under a node of its own.
    Ogre::Entity& show(const Ogre::MeshPtr& mesh, const Ogre::Vector3& position = Ogre::Vector3::ZERO);

    /// Draws a frame, as a program does it.
    Ogre::RenderTarget::FrameStats frame();
    /// Draws a frame and reads back what the viewport shows.
    Picture picture();

    /// An empty directory that is the resource location of group() and vanishes with the session.
    const std::filesystem::path& directory() const { return mDirectory.path(); }
    const std::string& group() const { return mGroup; }
    /// Loads a mesh file from anywhere, with its directory as resource location.
    Ogre::MeshPtr load(const std::filesystem::path& file);

private:
    void startOgre();
    void openWindow(std::uint32_t width, std::uint32_t height);
    void addLocation(const std::string& folder, const std::string& group);

    VirtualDisplay mDisplay;
    TestDirectory mDirectory;
    std::string mGroup = "Lodsmith tests";
    std::unique_ptr<Ogre::LogManager> mLogs;
    std::unique_ptr<Ogre::Root> mRoot;
    Ogre::RenderWindow* mWindow = nullptr;
    Ogre::Viewport* mViewport = nullptr;
    Ogre::SceneManager* mScene = nullptr;
    Ogre::Camera* mCamera = nullptr;
    Ogre::SceneNode* mCameraNode = nullptr;
};

} // namespace lodsmith::test
