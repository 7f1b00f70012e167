#include <lodsmith/ogre/LodManager.h>

#include "MainThread.h"

#include <lodsmith/core/Assert.h>
#include <lodsmith/loddef/LoddefFileName.h>
#include <lodsmith/ogre/DefinedLodConfig.h>
#include <lodsmith/ogre/MeshWriter.h>
#include <lodsmith/ogre/ProgressiveMeshGenerator.h>

#include <OgreLogManager.h>
#include <OgreMeshManager.h>
#include <OgreStringVector.h>
#include <OgreSubMesh.h>

#include <algorithm>
#include <functional>
#include <memory>

namespace lodsmith {

namespace {

/// What the meshes are now: applying loads further ones.
std::vector<Ogre::MeshPtr> loadedMeshes()
{
    std::vector<Ogre::MeshPtr> meshes;
    auto resources = Ogre::MeshManager::getSingleton().getResourceIterator();
    while (resources.hasMoreElements())
        if (auto mesh = std::dynamic_pointer_cast<Ogre::Mesh>(resources.getNext()); mesh && mesh->isLoaded())
            meshes.push_back(std::move(mesh));
    return meshes;
}

std::size_t triangleCount(const Ogre::Mesh& mesh)
{
    std::size_t triangles = 0;
    for (std::size_t i = 0; i < mesh.getNumSubMeshes(); ++i) {
        const Ogre::SubMesh& subMesh = *mesh.getSubMesh(i);
        const std::size_t indices = subMesh.indexData ? subMesh.indexData->indexCount : 0;
        if (subMesh.operationType == Ogre::RenderOperation::OT_TRIANGLE_LIST)
            triangles += indices / 3;
        else if (subMesh.operationType >= Ogre::RenderOperation::OT_TRIANGLE_STRIP && indices > 2)
            triangles += indices - 2;
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
    auto resources = Ogre::MeshManager::getSingleton().getResourceIterator();
    while (resources.hasMoreElements())
        resources.getNext()->addListener(this);
    auto known = mDefinitions.getResourceIterator();
    while (known.hasMoreElements())
        known.getNext()->addListener(this);
    Ogre::ResourceGroupManager::getSingleton().addResourceGroupListener(this);
    for (const Ogre::MeshPtr& mesh : loadedMeshes())
        meet(mesh);
}

LodManager::~LodManager()
{
    Ogre::ResourceGroupManager::getSingleton().removeResourceGroupListener(this);
    auto resources = Ogre::MeshManager::getSingleton().getResourceIterator();
    while (resources.hasMoreElements())
        resources.getNext()->removeListener(this);
    auto known = mDefinitions.getResourceIterator();
    while (known.hasMoreElements())
        known.getNext()->removeListener(this);
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
    if (const auto* definition = dynamic_cast<LodDefinitionResource*>(resource))
        applyToMeshesOf(*definition);
    else if (auto mesh =
                 std::dynamic_pointer_cast<Ogre::Mesh>(resource->getCreator()->getByHandle(resource->getHandle())))
        meet(mesh);
}

void LodManager::applyToMeshesOf(const LodDefinitionResource& definition)
{
    for (const Ogre::MeshPtr& mesh : loadedMeshes())
        if (mesh->getGroup() == definition.getGroup() && loddefFileName(mesh->getName()) == definition.getName())
            applyPolicy(mesh);
}

} // namespace lodsmith
