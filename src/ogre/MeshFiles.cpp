#include <lodsmith/ogre/MeshFiles.h>

#include "CheckedStream.h"
#include "FileLocations.h"
#include "MainThread.h"
#include "MeshHeader.h"
#include "OgreGuard.h"

#include <lodsmith/ogre/MeshReader.h>

#include <OgreMeshManager.h>
#include <OgreMeshSerializer.h>
#include <OgreResourceGroupManager.h>
#include <OgreString.h>

#include <algorithm>
#include <memory>
#include <string>
#include <system_error>

namespace fs = std::filesystem;

namespace lodsmith {

namespace {

/// A mesh that no manager knows: nobody listens to it, and it goes with the block that it is in.
class UnknownMesh final : public Ogre::Mesh {
public:
    explicit UnknownMesh(Ogre::Mesh& like) : Mesh(like.getCreator(), like.getName(), like.getHandle(), like.getGroup())
    {
    }
    // OGRE frees what loaded meshes hold, and this one never is.
    ~UnknownMesh() override { unloadImpl(); }
};

std::string readAll(Ogre::DataStream& stream)
{
    std::string bytes;
    char block[1 << 16];
    while (const std::size_t count = stream.read(block, sizeof block))
        bytes.append(block, count);
    return bytes;
}

/// Reads a file once as OGRE would, with a stream that throws where OGRE's own would have it take whatever lies in memory, and assert.
Result<Done> checkFile(Ogre::Mesh& mesh)
{
    const Ogre::DataStreamPtr file =
        Ogre::ResourceGroupManager::getSingleton().openResource(mesh.getName(), mesh.getGroup());
    const std::string bytes = readAll(*file);
    if (const Result<MeshHeader> header = parseMeshHeader(bytes); !header)
        return header.error();
    UnknownMesh trial(mesh);
    try {
        Ogre::MeshSerializer().importMesh(std::make_shared<CheckedStream>(mesh.getName(), bytes), &trial);
    } catch (const Ogre::Exception& exception) {
        return Error{ErrorCode::BadFile, exception.getDescription()};
    }
    // Cut between two parts, a file is read without a complaint, and its vertices are missing.
    if (const Result<MeshData> data = MeshReader::read(trial); !data)
        return data.error();
    return Done{};
}

Result<Done> checkAndLoad(const Ogre::MeshPtr& mesh)
{
    if (mesh->isLoaded())
        return Done{};
    if (!mesh->isManuallyLoaded())
        if (Result<Done> checked = checkFile(*mesh); !checked)
            return checked;
    mesh->load();
    return Done{};
}

Error fileError(const std::error_code& error, const fs::path& path)
{
    const bool isMissing = error == std::errc::no_such_file_or_directory || error == std::errc::not_a_directory;
    return Error{isMissing ? ErrorCode::NotFound : ErrorCode::Io, error.message(), path.string()};
}

/// The group of a directory, which knows the file.
void prepareGroup(const Ogre::String& directory, const Ogre::String& file)
{
    auto& groups = Ogre::ResourceGroupManager::getSingleton();
    if (!groups.resourceGroupExists(directory)) {
        groups.createResourceGroup(directory, false);
        try {
            groups.addResourceLocation(directory, "FileSystem", directory);
            groups.initialiseResourceGroup(directory);
        } catch (...) { // half of it would count as whole the next time
            groups.destroyResourceGroup(directory);
            throw;
        }
    } else if (!groups.resourceExists(directory, file))
        listAgain(directory, directory);
}

/// The mesh of a file by its canonical path, loaded or not, and whether OGRE did not know it before.
std::pair<Ogre::MeshPtr, bool> declareMesh(const fs::path& file)
{
    const Ogre::String group = file.parent_path().string();
    const Ogre::String name = file.filename().string();
    prepareGroup(group, name);
    const auto [mesh, isNew] = Ogre::MeshManager::getSingleton().createOrRetrieve(name, group);
    return {std::static_pointer_cast<Ogre::Mesh>(mesh), isNew};
}

Result<std::vector<fs::path>> meshFilesBelow(const fs::path& directory)
{
    std::vector<fs::path> files;
    std::error_code error;
    fs::recursive_directory_iterator entries(directory, fs::directory_options::skip_permission_denied, error);
    for (; !error && entries != fs::recursive_directory_iterator(); entries.increment(error)) {
        const fs::path& file = entries->path();
        std::error_code unreadable; // a link that leads nowhere
        if (file.filename().string().front() == '.')
            entries.disable_recursion_pending();
        else if (isMeshFileName(file.string()) && entries->is_regular_file(unreadable))
            files.push_back(file);
    }
    if (error)
        return fileError(error, directory);
    std::sort(files.begin(), files.end());
    return files;
}

} // namespace

bool isMeshFileName(const Ogre::String& name)
{
    return Ogre::StringUtil::endsWith(name, ".mesh");
}

Result<Ogre::MeshPtr> openMeshFile(const fs::path& path)
{
    assertMainThread();
    std::error_code error;
    const fs::path file = fs::canonical(path, error);
    if (error)
        return fileError(error, path);
    if (!fs::is_regular_file(file, error))
        return Error{ErrorCode::Io, "is no regular file", path.string()};
    return guarded(path.string(), [&]() -> Result<Ogre::MeshPtr> {
        const auto [mesh, isNew] = declareMesh(file);
        if (Result<Done> loaded = loadMesh(mesh); !loaded) {
            if (isNew)
                Ogre::MeshManager::getSingleton().remove(mesh);
            return loaded.error();
        }
        return mesh;
    });
}

Result<std::vector<Ogre::MeshPtr>> openMeshDirectory(const fs::path& path)
{
    assertMainThread();
    std::error_code error;
    const fs::path directory = fs::canonical(path, error);
    if (error)
        return fileError(error, path);
    if (!fs::is_directory(directory, error))
        return Error{ErrorCode::Io, "is no directory", path.string()};
    return guarded(path.string(), [&]() -> Result<std::vector<Ogre::MeshPtr>> {
        const Result<std::vector<fs::path>> files = meshFilesBelow(directory);
        if (!files)
            return files.error();
        std::vector<Ogre::MeshPtr> meshes;
        for (const fs::path& file : files.value())
            meshes.push_back(declareMesh(file).first);
        return meshes;
    });
}

Result<Done> loadMesh(const Ogre::MeshPtr& mesh)
{
    assertMainThread();
    return guarded(mesh->getName(), [&] { return checkAndLoad(mesh); });
}

Result<fs::path> meshPath(const Ogre::Mesh& mesh)
{
    assertMainThread();
    if (mesh.isManuallyLoaded())
        return Error{ErrorCode::Unsupported, "the mesh comes from no file", mesh.getName()};
    if (const Ogre::Archive* directory = directoryWith(mesh.getName(), mesh.getGroup()))
        return fs::path(directory->getName()) / mesh.getName();
    return Error{ErrorCode::NotFound, "the mesh's group knows no directory with its file", mesh.getName()};
}

} // namespace lodsmith
