#include <lodsmith/lua/Mesh.h>

#include "MeshInfo.h"

#include <lodsmith/ogre/MeshFiles.h>

#include <OgreMeshManager.h>

namespace lodsmith::lua {

namespace {

Error goneError()
{
    return Error{ErrorCode::NotFound, "the mesh is gone"};
}

} // namespace

Mesh::Mesh(const Ogre::MeshPtr& mesh) : Handle("lodsmith::Mesh"), mMesh(mesh) {}

Mesh::~Mesh() = default;

Ogre::MeshPtr Mesh::lock() const
{
    // OGRE itself ends with its meshes still held by somebody: nothing can be done with them any more.
    return Ogre::MeshManager::getSingletonPtr() ? Ogre::MeshPtr(mMesh.lock()) : Ogre::MeshPtr();
}

Result<Ogre::MeshPtr> Mesh::loaded() const
{
    const Ogre::MeshPtr mesh = lock();
    if (!mesh)
        return goneError();
    if (!mesh->isLoaded())
        return Error{ErrorCode::InvalidSetting, "the mesh is not loaded", mesh->getName()};
    return mesh;
}

Returned Mesh::name() const
{
    const Ogre::MeshPtr mesh = lock();
    return mesh ? Returned(mesh->getName()) : Returned(goneError());
}

Returned Mesh::group() const
{
    const Ogre::MeshPtr mesh = lock();
    return mesh ? Returned(mesh->getGroup()) : Returned(goneError());
}

Returned Mesh::isLoaded() const
{
    const Ogre::MeshPtr mesh = lock();
    return mesh && mesh->isLoaded();
}

Returned Mesh::isGone() const
{
    return !lock();
}

Returned Mesh::load() const
{
    const Ogre::MeshPtr mesh = lock();
    if (!mesh)
        return goneError();
    return loadMesh(mesh);
}

Returned Mesh::equals(const Mesh& other) const
{
    const Ogre::MeshPtr mesh = lock();
    return mesh && mesh == other.lock();
}

Returned Mesh::path() const
{
    const Ogre::MeshPtr mesh = lock();
    if (!mesh)
        return goneError();
    const Result<std::filesystem::path> path = meshPath(*mesh);
    if (!path)
        return path.error();
    return path.value().string();
}

Returned Mesh::info() const
{
    const Result<Ogre::MeshPtr> mesh = loaded();
    if (!mesh)
        return mesh.error();
    Result<Table> info = meshInfo(*mesh.value());
    if (!info)
        return info.error();
    return std::move(info).value();
}

Returned Mesh::triangles(double level) const
{
    const Result<Ogre::MeshPtr> mesh = loaded();
    if (!mesh)
        return mesh.error();
    const Result<std::size_t> triangles = trianglesOfLevel(*mesh.value(), level);
    if (!triangles)
        return triangles.error();
    return triangles.value();
}

} // namespace lodsmith::lua
