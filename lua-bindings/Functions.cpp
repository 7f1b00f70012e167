#include "Functions.h"

#include "Definition.h"

#include <lodsmith/lua/Mesh.h>
#include <lodsmith/ogre/LodDefinitionResource.h>
#include <lodsmith/ogre/MeshFiles.h>

#include <OgreMeshManager.h>
#include <OgreResourceGroupManager.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <tuple>
#include <vector>

namespace fs = std::filesystem;

namespace lodsmith::lua {

namespace {

Error noOgre()
{
    return Error{ErrorCode::NotFound, "OGRE is gone"};
}

std::vector<Ogre::MeshPtr> knownMeshes()
{
    std::vector<Ogre::MeshPtr> meshes;
    for (auto resources = Ogre::MeshManager::getSingleton().getResourceIterator(); resources.hasMoreElements();)
        if (auto mesh = std::dynamic_pointer_cast<Ogre::Mesh>(resources.getNext());
            mesh && mesh->getGroup() != Ogre::RGN_INTERNAL)
            meshes.push_back(mesh);
    std::sort(meshes.begin(), meshes.end(), [](const Ogre::MeshPtr& a, const Ogre::MeshPtr& b) {
        return std::tie(a->getName(), a->getGroup()) < std::tie(b->getName(), b->getGroup());
    });
    return meshes;
}

Table sortedTable(std::vector<std::string> names)
{
    std::sort(names.begin(), names.end());
    return Table(names);
}

Returned directoryError(const fs::path& path, const std::error_code& error)
{
    return Error{ErrorCode::Io, error.message(), path.string()};
}

} // namespace

Resource::Resource(const Ogre::ResourcePtr& resource) : Handle("lodsmith::Resource"), mResource(resource) {}

Ogre::ResourcePtr Resource::lock() const
{
    return Ogre::ResourceGroupManager::getSingletonPtr() ? Ogre::ResourcePtr(mResource.lock()) : Ogre::ResourcePtr();
}

Returned Resource::name() const
{
    const Ogre::ResourcePtr resource = lock();
    return resource ? Returned(resource->getName()) : Returned::failure("the resource is gone");
}

Returned Resource::group() const
{
    const Ogre::ResourcePtr resource = lock();
    return resource ? Returned(resource->getGroup()) : Returned::failure("the resource is gone");
}

Returned Resource::type() const
{
    const Ogre::ResourcePtr resource = lock();
    return resource ? Returned(resource->getCreator()->getResourceType()) : Returned::failure("the resource is gone");
}

Returned Resource::isGone() const
{
    return !lock();
}

Returned meshes()
{
    if (!Ogre::MeshManager::getSingletonPtr())
        return noOgre();
    Table meshes;
    for (const Ogre::MeshPtr& mesh : knownMeshes())
        meshes.add(std::make_unique<Mesh>(mesh));
    return meshes;
}

Returned openMesh(Text path)
{
    if (!Ogre::MeshManager::getSingletonPtr())
        return noOgre();
    const Result<Ogre::MeshPtr> mesh = openMeshFile(fs::path(path));
    if (!mesh)
        return mesh.error();
    return std::make_unique<Mesh>(mesh.value());
}

Returned openDirectory(Text path)
{
    if (!Ogre::MeshManager::getSingletonPtr())
        return noOgre();
    const Result<std::vector<Ogre::MeshPtr>> found = openMeshDirectory(fs::path(path));
    if (!found)
        return found.error();
    Table meshes;
    for (const Ogre::MeshPtr& mesh : found.value())
        meshes.add(std::make_unique<Mesh>(mesh));
    return meshes;
}

Returned listDirectory(Text path)
{
    std::error_code error;
    const fs::path directory = fs::canonical(fs::path(path), error);
    if (error)
        return directoryError(fs::path(path), error);
    std::vector<std::string> directories, meshes;
    fs::directory_iterator entries(directory, error);
    for (; !error && entries != fs::directory_iterator(); entries.increment(error)) {
        const std::string name = entries->path().filename().string();
        std::error_code unreadable; // a link that leads nowhere is neither
        if (name.front() == '.')
            continue;
        if (entries->is_directory(unreadable))
            directories.push_back(name);
        else if (entries->is_regular_file(unreadable) && isMeshFileName(name))
            meshes.push_back(name);
    }
    if (error)
        return directoryError(directory, error);
    Table table;
    table.set("path", directory.string())
        .set("parent", directory.has_relative_path() ? Value(directory.parent_path().string()) : Value())
        .set("directories", sortedTable(std::move(directories)))
        .set("meshes", sortedTable(std::move(meshes)));
    return table;
}

Returned resource(Text name, Text group)
{
    auto* groups = Ogre::ResourceGroupManager::getSingletonPtr();
    if (!groups)
        return noOgre();
    for (const char* type : {"Mesh", "LodDefinition"}) {
        const auto manager = groups->getResourceManagers().find(type);
        if (manager == groups->getResourceManagers().end())
            continue;
        const Ogre::ResourcePtr resource = manager->second->getResourceByName(std::string(name), std::string(group));
        if (resource && resource->getGroup() == group)
            return std::make_unique<Resource>(resource);
    }
    return nullptr;
}

Returned toMesh(const Resource& resource)
{
    const auto mesh = std::dynamic_pointer_cast<Ogre::Mesh>(resource.lock());
    return mesh ? Returned(std::make_unique<Mesh>(mesh)) : Returned(nullptr);
}

Returned toDefinition(const Resource& resource)
{
    const auto definition = std::dynamic_pointer_cast<LodDefinitionResource>(resource.lock());
    if (!definition || !definition->definition())
        return nullptr;
    return std::make_unique<Definition>(*definition->definition());
}

} // namespace lodsmith::lua
