#include "AddLods.h"

#include <lodsmith/ogre/QueuedProgressiveMeshGenerator.h>

#include <OgreDefaultHardwareBufferManager.h>
#include <OgreLogManager.h>
#include <OgreMeshManager.h>
#include <OgreRoot.h>
#include <OgreSubMesh.h>

#include <cstdio>
#include <memory>

namespace {

std::size_t triangles(const Ogre::MeshPtr& mesh, unsigned short level)
{
    const auto& faces = mesh->getSubMesh(0)->mLodFaceList;
    return (level == 0 ? mesh->getSubMesh(0)->indexData : faces[level - 1u])->indexCount / 3;
}

/// Levels made in the background; true when they are on the mesh.
bool addLodsInBackground(const Ogre::MeshPtr& mesh)
{
    bool injected = false;
    lodsmith::QueuedProgressiveMeshGenerator queue;
    queue.signals().injected.connect([&](const Ogre::MeshPtr&, const lodsmith::LodReport&) { injected = true; });
    if (!queue.generateAutoconfiguredLodLevels(mesh))
        return false;
    queue.injector().finishAll();
    return injected && mesh->getNumLodLevels() > 1;
}

} // namespace

/// A game in small: no window, one mesh, two levels for it.
int main()
{
    Ogre::LogManager logManager;
    logManager.createLog("consumer.log", true, false, true);
    const auto buffers = std::make_unique<Ogre::DefaultHardwareBufferManager>();
    const Ogre::Root root("", "", "");
    const Ogre::MeshPtr mesh = Ogre::MeshManager::getSingleton().createPlane(
        "plane", Ogre::ResourceGroupManager::DEFAULT_RESOURCE_GROUP_NAME, Ogre::Plane(Ogre::Vector3::UNIT_Y, 0.0f),
        100.0f, 100.0f, 20, 20, true, 1, 1.0f, 1.0f, Ogre::Vector3::UNIT_Z);

    if (!addLods(mesh) || mesh->getNumLodLevels() != 3)
        return 1;
    std::printf("%zu, %zu, %zu triangles\n", triangles(mesh, 0), triangles(mesh, 1), triangles(mesh, 2));
    const bool falling = triangles(mesh, 1) < triangles(mesh, 0) && triangles(mesh, 2) < triangles(mesh, 1);
    return falling && addLodsInBackground(mesh) ? 0 : 1;
}
