#pragma once

#include "TestDirectory.h"

#include <OgreMesh.h>

#include <filesystem>
#include <memory>
#include <string>

namespace Ogre {
class DefaultHardwareBufferManager;
class LogManager;
class Root;
} // namespace Ogre

namespace lodsmith::test {

/// OGRE without window, render system and log, for as long as this object lives; one at a time. Mesh pointers have to be
/// gone before it is.
class OgreSession {
public:
    /// @param pluginsFile a plugins.cfg whose plugins are loaded; empty for none
    explicit OgreSession(const std::string& pluginsFile = "");
    ~OgreSession();
    OgreSession(const OgreSession&) = delete;
    OgreSession& operator=(const OgreSession&) = delete;

    /// An empty directory that is the resource location of group() and vanishes with the session.
    const std::filesystem::path& directory() const { return mDirectory.path(); }
    const std::string& group() const { return mGroup; }

    /// Writes a mesh to directory() and loads it again as another resource.
    Ogre::MeshPtr saveAndReload(const Ogre::MeshPtr& mesh);
    /// Loads a mesh that has been written to directory().
    Ogre::MeshPtr loadSaved(const std::string& name);
    /// Loads a mesh file from anywhere, with its directory as resource location.
    Ogre::MeshPtr load(const std::filesystem::path& file);

private:
    TestDirectory mDirectory;
    std::string mGroup = "Lodsmith tests";
    std::unique_ptr<Ogre::LogManager> mLogs;
    std::unique_ptr<Ogre::Root> mRoot;
    std::unique_ptr<Ogre::DefaultHardwareBufferManager> mBuffers;
    int mSaved = 0;
};

} // namespace lodsmith::test
