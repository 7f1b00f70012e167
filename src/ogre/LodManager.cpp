#include <lodsmith/ogre/LodManager.h>

#include "MainThread.h"
#include "TrianglesIn.h"

#include <lodsmith/core/Assert.h>
#include <lodsmith/loddef/LoddefFileName.h>
#include <lodsmith/ogre/DefinedLodConfig.h>
#include <lodsmith/ogre/MeshWriter.h>
#include <lodsmith/ogre/ProgressiveMeshGenerator.h>

#include <OgreLogManager.h>
#include <OgreMeshManager.h>
#include <OgreString.h>
#include <OgreSubMesh.h>

#include <algorithm>
#include <functional>
#include <memory>

namespace lodsmith {

namespace {

template <class Action>
void forEachResource(Ogre::ResourceManager& manager, const Action& action)
{
    auto resources = manager.getResourceIterator();
    while (resources.hasMoreElements())
        action(resources.getNext());
}

/// What the meshes are now: applying loads further ones.
std::vector<Ogre::MeshPtr> loadedMeshes()
{
    std::vector<Ogre::MeshPtr> meshes;
    forEachResource(Ogre::MeshManager::getSingleton(), [&](const Ogre::ResourcePtr& resource) {
        if (auto mesh = std::dynamic_pointer_cast<Ogre::Mesh>(resource); mesh && mesh->isLoaded())
            meshes.push_back(mesh);
    });
    return meshes;
}

std::size_t triangleCount(const Ogre::Mesh& mesh)
{
    std::size_t triangles = 0;
    for (std::size_t i = 0; i < mesh.getNumSubMeshes(); ++i) {
        const Ogre::SubMesh& subMesh = *mesh.getSubMesh(i);
        if (subMesh.indexData)
            triangles += trianglesIn(subMesh.operationType, subMesh.indexData->indexCount);
    }
    return triangles;
}

bool isHandMade(const LodConfig& config)
{
    return std::any_of(config.levels.begin(), config.levels.end(), std::mem_fn(&LodLevel::isManual));
}

class Flag {
public:
    explicit Flag(bool& flag) : mFlag(flag), mBefore(flag) { mFlag = true; }
    ~Flag() { mFlag = mBefore; }
    Flag(const Flag&) = delete;
    Flag& operator=(const Flag&) = delete;

private:
    bool& mFlag;
    bool mBefore;
};

} // namespace

LodManager::LodManager(LodDefinitionManager& definitions, QueuedProgressiveMeshGenerator& queue,
                       const LodPolicy& policy)
    : mDefinitions(definitions), mQueue(queue), mPolicy(policy)
{
    assertMainThread();
    const auto listen = [this](const Ogre::ResourcePtr& resource) { resource->addListener(this); };
    forEachResource(Ogre::MeshManager::getSingleton(), listen);
    forEachResource(mDefinitions, listen);
    Ogre::ResourceGroupManager::getSingleton().addResourceGroupListener(this);
    for (const Ogre::MeshPtr& mesh : loadedMeshes())
        meet(mesh);
}

LodManager::~LodManager()
{
    Ogre::ResourceGroupManager::getSingleton().removeResourceGroupListener(this);
    const auto leave = [this](const Ogre::ResourcePtr& resource) { resource->removeListener(this); };
    forEachResource(Ogre::MeshManager::getSingleton(), leave);
    forEachResource(mDefinitions, leave);
}

Result<LodDecision> LodManager::apply(const Ogre::MeshPtr& mesh)
{
    assertMainThread();
    LODSMITH_ASSERT(mesh && mesh->isLoaded(), "apply() needs a loaded mesh");
    const Flag applying(mIsApplying);
    const LodDefinitionResourcePtr resource = mDefinitions.definitionFor(*mesh);
    if (!resource)
        return applyAutomatic(mesh);
    if (!resource->definition())
        return Error{ErrorCode::BadFile, "its definition has errors, and the mesh stays as it is", mesh->getName()};
    return applyDefinition(mesh, *resource->definition());
}

void LodManager::applyToAll()
{
    for (const Ogre::MeshPtr& mesh : loadedMeshes())
        applyPolicy(mesh);
}

/// A mesh that has been loaded.
void LodManager::meet(const Ogre::MeshPtr& mesh)
{
    mHadLevels[mesh->getHandle()] = mesh->getNumLodLevels() > 1;
    applyPolicy(mesh);
}

void LodManager::applyPolicy(const Ogre::MeshPtr& mesh)
{
    if (!mPolicy.enabled || !isWanted(*mesh))
        return;
    if (const Result<LodDecision> decision = apply(mesh); !decision)
        Ogre::LogManager::getSingleton().logError(describe(decision.error()));
}

bool LodManager::isWanted(const Ogre::Mesh& mesh) const
{
    const auto& groups = mPolicy.groups;
    if (groups.empty() ? mesh.getGroup() == Ogre::RGN_INTERNAL
                       : std::find(groups.begin(), groups.end(), mesh.getGroup()) == groups.end())
        return false;
    return mPolicy.names.empty()
           || std::any_of(mPolicy.names.begin(), mPolicy.names.end(), [&](const Ogre::String& pattern) {
                  return Ogre::StringUtil::match(mesh.getName(), pattern);
              });
}

Result<LodDecision> LodManager::applyAutomatic(const Ogre::MeshPtr& mesh)
{
    const auto known = mHadLevels.find(mesh->getHandle());
    const bool keepsItsOwn = known != mHadLevels.end() && known->second && !mPolicy.replaceLevels;
    if (!mPolicy.automatic || keepsItsOwn || triangleCount(*mesh) < mPolicy.minTriangles)
        return LodDecision::LeftAlone;
    if (const Result<Done> queued = mQueue.generateAutoconfiguredLodLevels(mesh); !queued)
        return queued.error();
    return LodDecision::Queued;
}

Result<LodDecision> LodManager::applyDefinition(const Ogre::MeshPtr& mesh, const LodDefinition& definition)
{
    Result<DefinedLodConfig> defined = lodConfig(definition, mesh);
    if (!defined)
        return defined.error();
    for (const Error& error : defined.value().leftOut)
        Ogre::LogManager::getSingleton().logWarning(describe(error));
    const LodConfig& config = defined.value().config;
    if (config.levels.empty() || isHandMade(config))
        mQueue.cancel(mesh);
    if (config.levels.empty()) {
        MeshWriter::removeLevels(*mesh);
        return LodDecision::Removed;
    }
    if (isHandMade(config)) {
        if (const Result<LodReport> report = ProgressiveMeshGenerator().generateLodLevels(config); !report)
            return report.error();
        return LodDecision::Attached;
    }
    if (const Result<Done> queued = mQueue.generateLodLevels(config); !queued)
        return queued.error();
    return LodDecision::Queued;
}

void LodManager::resourceCreated(const Ogre::ResourcePtr& resource)
{
    if (std::dynamic_pointer_cast<Ogre::Mesh>(resource) || std::dynamic_pointer_cast<LodDefinitionResource>(resource))
        resource->addListener(this);
}

void LodManager::resourceRemove(const Ogre::ResourcePtr& resource)
{
    resource->removeListener(this);
    mHadLevels.erase(resource->getHandle());
}

void LodManager::loadingComplete(Ogre::Resource* resource)
{
    if (mIsApplying)
        return;
    const Ogre::ResourcePtr shared = resource->getCreator()->getByHandle(resource->getHandle());
    if (const auto definition = std::dynamic_pointer_cast<LodDefinitionResource>(shared))
        applyToMeshesOf(*definition);
    else if (const auto mesh = std::dynamic_pointer_cast<Ogre::Mesh>(shared))
        meet(mesh);
}

void LodManager::applyToMeshesOf(const LodDefinitionResource& definition)
{
    for (const Ogre::MeshPtr& mesh : loadedMeshes())
        if (mesh->getGroup() == definition.getGroup() && loddefFileName(mesh->getName()) == definition.getName())
            applyPolicy(mesh);
}

} // namespace lodsmith
