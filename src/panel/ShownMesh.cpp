#include "ShownMesh.h"

#include <OgreEntity.h>
#include <OgreMeshManager.h>
#include <OgreSceneManager.h>
#include <OgreSceneNode.h>
#include <OgreSubMesh.h>

#include <utility>

namespace lodsmith {

bool ShownMesh::Levels::operator==(const Levels& other) const
{
    return std::tie(stateCount, strategy, usages, lists)
           == std::tie(other.stateCount, other.strategy, other.usages, other.lists);
}

ShownMesh::Levels ShownMesh::levelsOf(const Ogre::Mesh& mesh)
{
    Levels levels;
    levels.stateCount = mesh.getStateCount();
    levels.strategy = mesh.getLodStrategy();
    for (Ogre::ushort i = 0; i < mesh.getNumLodLevels(); ++i) {
        const Ogre::MeshLodUsage& usage = mesh.getLodLevel(i);
        const bool isHandMade = usage.manualMesh != nullptr;
        levels.usages.emplace_back(usage.value, isHandMade ? usage.manualMesh->getHandle() : 0,
                                   isHandMade ? usage.manualMesh->getStateCount() : 0);
    }
    for (const Ogre::SubMesh* part : mesh.getSubMeshes())
        for (const Ogre::IndexData* list : part->mLodFaceList)
            levels.lists.emplace_back(list->indexBuffer, list->indexStart, list->indexCount);
    return levels;
}

ShownMesh::ShownMesh(Ogre::SceneNode& node) : mNode(node) {}

ShownMesh::~ShownMesh()
{
    clear();
}

void ShownMesh::show(const Ogre::MeshPtr& mesh)
{
    clear();
    mMesh = mesh;
    mMesh->addListener(this);
    try {
        createEntity();
    } catch (...) {
        clear();
        throw;
    }
}

void ShownMesh::clear()
{
    destroyEntity();
    if (mMesh)
        mMesh->removeListener(this);
    mMesh.reset();
    mLevels = {};
}

void ShownMesh::createEntity()
{
    mEntity = mNode.getCreator()->createEntity(mMesh);
    mNode.attachObject(mEntity);
    mLevels = levelsOf(*mMesh);
}

void ShownMesh::destroyEntity()
{
    if (mEntity)
        mNode.getCreator()->destroyEntity(mEntity);
    mEntity = nullptr;
    mIsStale = false;
}

// The mesh's listeners, of which the entity is one, are being told: it must not vanish now.
void ShownMesh::unloadingComplete(Ogre::Resource*)
{
    mIsStale = true;
}

/// From all that OGRE knows; it tells nobody when a manager removes all of its resources.
bool ShownMesh::isRemoved() const
{
    return Ogre::MeshManager::getSingleton().getByHandle(mMesh->getHandle()) != mMesh;
}

ShownMesh::Change ShownMesh::follow()
{
    if (!mMesh)
        return Change::None;
    if (isRemoved()) {
        clear();
        return Change::Mesh;
    }
    const bool wasStale = mIsStale;
    if (wasStale)
        destroyEntity();
    if (!mEntity && mMesh->isLoaded()) {
        createEntity();
        return Change::Mesh;
    }
    if (wasStale)
        return Change::Mesh;
    if (!mEntity)
        return Change::None;
    Levels levels = levelsOf(*mMesh);
    if (levels == mLevels)
        return Change::None;
    const bool isOther = levels.stateCount != mLevels.stateCount;
    mLevels = std::move(levels);
    // Of hand-made levels, for which OGRE makes entities of their own, those that are made while the entity is attached
    // have neither its place nor its lights.
    mNode.detachObject(mEntity);
    mNode.attachObject(mEntity);
    return isOther ? Change::Mesh : Change::Levels;
}

} // namespace lodsmith
