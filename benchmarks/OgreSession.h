#pragma once

#include <memory>

namespace Ogre {
class DefaultHardwareBufferManager;
class LogManager;
class MeshLodGenerator;
class Root;
} // namespace Ogre

namespace lodsmith::benchmarks {

/// OGRE without a window, a render system or a log file, and its own LOD generator beside it. One at a time, main thread.
class OgreSession {
public:
    OgreSession();
    ~OgreSession();
    OgreSession(const OgreSession&) = delete;
    OgreSession& operator=(const OgreSession&) = delete;

private:
    // Order matters: Root has to go before the managers that it does not own.
    std::unique_ptr<Ogre::LogManager> mLogManager;
    std::unique_ptr<Ogre::DefaultHardwareBufferManager> mBufferManager;
    std::unique_ptr<Ogre::Root> mRoot;
    std::unique_ptr<Ogre::MeshLodGenerator> mMeshLodGenerator;
};

} // namespace lodsmith::benchmarks
