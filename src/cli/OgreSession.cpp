#include "OgreSession.h"

#include "../files/AtomicFile.h"
#include "../ogre/CheckedStream.h"
#include "../ogre/MeshHeader.h"

#include <OgreDefaultHardwareBufferManager.h>
#include <OgreLogManager.h>
#include <OgreMaterialManager.h>
#include <OgreMeshManager.h>
#include <OgreRoot.h>

#include <new>

namespace fs = std::filesystem;

namespace lodsmith::cli {

namespace {

Error withFile(Error error, const fs::path& path)
{
    error.file = path.string();
    return error;
}

} // namespace

OgreSession::OgreSession()
{
    // A log of our own, made before Root makes its: neither a file nor the standard streams.
    mLogManager = std::make_unique<Ogre::LogManager>();
    mLogManager->createLog("", true, false, true);
    mRoot = std::make_unique<Ogre::Root>("", "", "");
    mBufferManager = std::make_unique<Ogre::DefaultHardwareBufferManager>();
    Ogre::MaterialManager::getSingleton().initialise();
    Ogre::ResourceGroupManager::getSingleton().setLoadingListener(this);
    Ogre::MeshManager::getSingleton().setListener(this);
}

OgreSession::~OgreSession()
{
    Ogre::MeshManager::getSingleton().setListener(nullptr);
    Ogre::ResourceGroupManager::getSingleton().setLoadingListener(nullptr);
    // Meshes hold hardware buffers, so Root goes before the buffer manager.
    mRoot.reset();
    mBufferManager.reset();
    mLogManager.reset();
}

Result<Ogre::MeshPtr> OgreSession::load(const fs::path& path)
{
    // One resource group a file keeps files of equal names in different directories apart.
    const std::string group = path.string();
    auto& groups = Ogre::ResourceGroupManager::getSingleton();
    if (!groups.resourceGroupExists(group))
        groups.createResourceGroup(group, false);
    mDirectoryOfGroup[group] = path.parent_path();
    return loadAs(path, group, group);
}

Result<Ogre::MeshPtr> OgreSession::loadLevelOf(const Ogre::Mesh& owner, const fs::path& path, const std::string& name)
{
    return loadAs(path, name, owner.getGroup());
}

Result<std::string> OgreSession::readNoted(const fs::path& path)
{
    Result<std::string> bytes = readFile(path);
    mFilesRead.emplace(path, bytes ? std::optional(contentHash(bytes.value())) : std::nullopt);
    return bytes;
}

Result<Ogre::MeshPtr> OgreSession::loadAs(const fs::path& path, const std::string& name, const std::string& group)
{
    Result<std::string> bytes = readNoted(path);
    if (!bytes)
        return bytes.error();
    if (const Result<MeshHeader> header = parseMeshHeader(bytes.value()); !header)
        return withFile(header.error(), path);
    mBytes = std::move(bytes).value();
    try {
        Ogre::MeshPtr mesh = Ogre::MeshManager::getSingleton().createManual(name, group, this);
        mesh->load();
        mBytes = std::string();
        return mesh;
    } catch (const Ogre::Exception& exception) {
        return withFile({ErrorCode::BadFile, exception.getDescription()}, path);
    } catch (const std::bad_alloc&) {
        return withFile({ErrorCode::OutOfMemory, "asks for more memory than the limit allows"}, path);
    }
}

Ogre::MeshPtr OgreSession::create(const Ogre::String& name)
{
    Ogre::MeshPtr mesh = Ogre::MeshManager::getSingleton().createManual(name, Ogre::RGN_DEFAULT);
    // OGRE frees the submeshes of loaded meshes alone.
    mesh->load();
    return mesh;
}

void OgreSession::provideMaterial(const Ogre::Mesh& mesh, const Ogre::String& name)
{
    auto& materials = Ogre::MaterialManager::getSingleton();
    if (!name.empty() && !materials.getByName(name, mesh.getGroup()))
        materials.create(name, mesh.getGroup());
}

bool OgreSession::staysInside(const std::string& name)
{
    const fs::path path(name);
    if (name.empty() || path.is_absolute())
        return false;
    for (const fs::path& part : path)
        if (part == "..")
            return false;
    return true;
}

void OgreSession::loadResource(Ogre::Resource* mesh)
{
    // Mesh::load() would copy the file into a stream of its own, which is as trusting as they all are.
    Ogre::MeshSerializer serializer;
    serializer.setListener(this);
    serializer.importMesh(std::make_shared<CheckedStream>(mesh->getName(), mBytes), static_cast<Ogre::Mesh*>(mesh));
}

Ogre::DataStreamPtr OgreSession::resourceLoading(const Ogre::String& name, const Ogre::String& group, Ogre::Resource*)
{
    const auto directory = mDirectoryOfGroup.find(group);
    if (directory == mDirectoryOfGroup.end() || !staysInside(name))
        return nullptr;
    const Result<std::string> bytes = readNoted(directory->second / name);
    if (!bytes)
        return nullptr;
    return std::make_shared<CheckedStream>(name, bytes.value());
}

void OgreSession::processMaterialName(Ogre::Mesh* mesh, Ogre::String* name)
{
    provideMaterial(*mesh, *name);
}

} // namespace lodsmith::cli
