#pragma once

#include "ContentHash.h"

#include <lodsmith/core/Result.h>

#include <OgreLog.h>
#include <OgreMesh.h>
#include <OgreMeshSerializer.h>
#include <OgreResource.h>
#include <OgreResourceGroupManager.h>

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace Ogre {
class DefaultHardwareBufferManager;
class LogManager;
class Root;
} // namespace Ogre

namespace lodsmith::cli {

/// OGRE without a window, a render system, plugins, configuration or log, for as long as the object lives. One at a
/// time.
///
/// Nothing OGRE says reaches the standard streams. A mesh finds the skeleton and the hand-made levels that it names
/// beside its own file, and nowhere else. Materials need no scripts: a name that a mesh mentions gets an empty
/// material, since OGRE forgets the name otherwise and would not save it again.
class OgreSession : private Ogre::ResourceLoadingListener,
                    private Ogre::MeshSerializerListener,
                    private Ogre::ManualResourceLoader {
public:
    OgreSession();
    ~OgreSession() override;
    OgreSession(const OgreSession&) = delete;
    OgreSession& operator=(const OgreSession&) = delete;

    /// Loads a mesh from a file; what it names is looked for in the file's directory. The mesh's name is the path.
    /// Errors: NotFound, Io, BadFile, OutOfMemory; file is the path.
    Result<Ogre::MeshPtr> load(const std::filesystem::path& path);

    /// Loads a hand-made level for `owner` under the name by which that will find it. Errors: as load().
    Result<Ogre::MeshPtr> loadLevelOf(const Ogre::Mesh& owner, const std::filesystem::path& path,
                                      const std::string& name);

    /// What has been read so far, and what was looked for and not there.
    const FileHashes& filesRead() const { return mFilesRead; }

    /// A new, empty mesh.
    Ogre::MeshPtr create(const Ogre::String& name);

    /// Makes an empty material of this name for a mesh, unless there is one.
    static void provideMaterial(const Ogre::Mesh& mesh, const Ogre::String& name);

    /// Whether a name from inside a file stays in the directory of that file: relative, and without "..".
    static bool staysInside(const std::string& name);

private:
    Result<std::string> readNoted(const std::filesystem::path& path);
    Result<Ogre::MeshPtr> loadAs(const std::filesystem::path& path, const std::string& name, const std::string& group);
    void loadResource(Ogre::Resource* mesh) override;
    Ogre::DataStreamPtr resourceLoading(const Ogre::String& name, const Ogre::String& group, Ogre::Resource*) override;
    void processMaterialName(Ogre::Mesh* mesh, Ogre::String* name) override;
    void processSkeletonName(Ogre::Mesh*, Ogre::String*) override {}
    void processMeshCompleted(Ogre::Mesh*) override {}

    std::unique_ptr<Ogre::LogManager> mLogManager;
    std::unique_ptr<Ogre::Root> mRoot;
    std::unique_ptr<Ogre::DefaultHardwareBufferManager> mBufferManager;
    std::map<std::string, std::filesystem::path> mDirectoryOfGroup;
    FileHashes mFilesRead;
    std::string mBytes; // content of the mesh file that is being loaded
};

} // namespace lodsmith::cli
