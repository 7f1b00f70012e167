#include <lodsmith/ogre/LodManager.h>

#include "BesideDefinition.h"
#include "GenerationSteps.h"
#include "MainThread.h"
#include "TrianglesIn.h"

#include <lodsmith/core/Assert.h>
#include <lodsmith/loddef/LoddefFileName.h>
#include <lodsmith/ogre/DefinedLodConfig.h>
#include <lodsmith/ogre/MeshWriter.h>
#include <lodsmith/ogre/ProgressiveMeshGenerator.h>

#include <OgreLogManager.h>
#include <OgreMeshManager.h>
#include <OgreRoot.h>
#include <OgreString.h>
#include <OgreSubMesh.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <utility>

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

/// Without those that cannot be had: OGRE loads those of a mesh's file when they are asked for.
std::vector<Ogre::MeshPtr> handMadeLevels(const Ogre::Mesh& mesh)
{
    std::vector<Ogre::MeshPtr> levels;
    for (Ogre::ushort level = 1; level < mesh.getNumLodLevels(); ++level)
        try {
            if (const Ogre::MeshPtr& handMade = mesh.getLodLevel(level).manualMesh)
                levels.push_back(handMade);
        } catch (const Ogre::Exception& exception) {
            Ogre::LogManager::getSingleton().logError(mesh.getName() + ": " + exception.getDescription());
        }
    return levels;
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
    const auto listen = [this](const Ogre::ResourcePtr& resource) { listenTo(resource); };
    forEachResource(Ogre::MeshManager::getSingleton(), listen);
    forEachResource(mDefinitions, listen);
    Ogre::ResourceGroupManager::getSingleton().addResourceGroupListener(this);
    Ogre::Root::getSingleton().addFrameListener(this);
    for (const Ogre::MeshPtr& mesh : loadedMeshes())
        meet(mesh, Occasion::Later);
}

LodManager::~LodManager()
{
    Ogre::Root::getSingleton().removeFrameListener(this);
    Ogre::ResourceGroupManager::getSingleton().removeResourceGroupListener(this);
    for (const auto& [address, resource] : mHeard)
        if (const std::shared_ptr<Ogre::Resource> living = resource.lock())
            living->removeListener(this);
}

Result<LodDecision> LodManager::apply(const Ogre::MeshPtr& mesh)
{
    assertMainThread();
    LODSMITH_ASSERT(mesh && mesh->isLoaded(), "apply() needs a loaded mesh");
    return decide(mesh, Occasion::Later);
}

Result<LodDecision> LodManager::apply(const Ogre::MeshPtr& mesh, const LodDefinition& definition)
{
    assertMainThread();
    LODSMITH_ASSERT(mesh && mesh->isLoaded(), "apply() needs a loaded mesh");
    const Flag applying(mIsApplying);
    if (isHandMadeLevel(mesh))
        return LodDecision::LeftAlone;
    return decideByDefinition(mesh, definition, Occasion::Later);
}

void LodManager::applyToAll()
{
    assertMainThread();
    for (const Ogre::MeshPtr& mesh : loadedMeshes())
        applyPolicy(mesh, Occasion::Later);
}

void LodManager::update()
{
    assertMainThread();
    if (!mRemoved.empty())
        applyToMeshesOf(std::exchange(mRemoved, {}));
}

void LodManager::listenTo(const Ogre::ResourcePtr& resource)
{
    resource->addListener(this);
    mHeard[resource.get()] = resource;
}

/// A mesh that has been loaded.
void LodManager::meet(const Ogre::MeshPtr& mesh, Occasion occasion)
{
    noteHandMadeLevels(mesh);
    applyPolicy(mesh, occasion);
}

void LodManager::applyPolicy(const Ogre::MeshPtr& mesh, Occasion occasion)
{
    if (!mPolicy.enabled || !isWanted(*mesh))
        return;
    if (const Result<LodDecision> decision = decide(mesh, occasion); !decision)
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

bool LodManager::isHandMadeLevel(const Ogre::MeshPtr& mesh) const
{
    return std::any_of(mWithHandMade.begin(), mWithHandMade.end(), [&](Ogre::ResourceHandle handle) {
        const auto owner = std::dynamic_pointer_cast<Ogre::Mesh>(Ogre::MeshManager::getSingleton().getByHandle(handle));
        const auto levels = owner ? handMadeLevels(*owner) : std::vector<Ogre::MeshPtr>();
        return std::find(levels.begin(), levels.end(), mesh) != levels.end();
    });
}

bool LodManager::hasLevelsOfItsOwn(const Ogre::Mesh& mesh) const
{
    return mesh.getNumLodLevels() > 1 && mGiven.count(mesh.getHandle()) == 0;
}

Result<LodDecision> LodManager::decide(const Ogre::MeshPtr& mesh, Occasion occasion)
{
    const Flag applying(mIsApplying);
    if (isHandMadeLevel(mesh))
        return LodDecision::LeftAlone;
    const LodDefinitionResourcePtr resource = mDefinitions.definitionFor(*mesh);
    if (!resource)
        return decideWithoutDefinition(mesh, occasion);
    if (!resource->definition())
        return Error{ErrorCode::BadFile, "its definition has errors, and the mesh stays as it is", mesh->getName()};
    return decideByDefinition(mesh, *resource->definition(), occasion);
}

Result<LodDecision> LodManager::decideWithoutDefinition(const Ogre::MeshPtr& mesh, Occasion occasion)
{
    const bool keepsItsOwn = hasLevelsOfItsOwn(*mesh) && !mPolicy.replaceLevels;
    if (!mPolicy.automatic || keepsItsOwn || triangleCount(*mesh) < mPolicy.minTriangles) {
        if (mGiven.count(mesh->getHandle()) == 0)
            return LodDecision::LeftAlone;
        take(mesh);
        return LodDecision::Removed;
    }
    const Result<LodConfig> config = checkedAutomaticConfig(mesh, mPolicy.automaticLods);
    if (!config)
        return config.error();
    return give(config.value(), occasion);
}

Result<LodDecision> LodManager::decideByDefinition(const Ogre::MeshPtr& mesh, const LodDefinition& definition,
                                                   Occasion occasion)
{
    freeHandMadeLevels(*mesh, definition);
    const Result<DefinedLodConfig> defined = lodConfig(definition, mesh, {}, mPolicy.automaticLods);
    if (!defined)
        return defined.error();
    for (const Error& error : defined.value().leftOut)
        Ogre::LogManager::getSingleton().logWarning(describe(error));
    if (!defined.value().config.levels.empty())
        return give(defined.value().config, occasion);
    take(mesh);
    return LodDecision::Removed;
}

Result<LodDecision> LodManager::give(LodConfig config, Occasion occasion)
{
    const Ogre::MeshPtr mesh = config.mesh;
    const bool isLoading = occasion == Occasion::Loading;
    // Entities that OGRE makes anew after a loading have to find what stays.
    const bool atOnce = isHandMade(config) || (isLoading && mesh->hasManualLodLevel());
    config.reinitialiseEntities = mPolicy.reinitialiseEntities || (isLoading && atOnce);
    if (!atOnce) {
        // Large ones are seen from afar, and stand in many frames.
        if (const Result<Done> queued = mQueue.generateLodLevels(config, mesh->getBoundingSphereRadius()); !queued)
            return queued.error();
    } else if (const Result<LodReport> report = ProgressiveMeshGenerator(mQueue.cache()).generateLodLevels(config);
               !report)
        return report.error();
    else
        mQueue.cancel(mesh);
    mGiven.insert(mesh->getHandle());
    noteHandMadeLevels(mesh);
    return atOnce ? LodDecision::Attached : LodDecision::Queued;
}

void LodManager::take(const Ogre::MeshPtr& mesh)
{
    mQueue.cancel(mesh);
    MeshWriter::removeLevels(*mesh);
    mGiven.erase(mesh->getHandle());
}

/// Automatic levels stand back for meshes that are wanted as levels themselves; those of a definition do not.
void LodManager::freeHandMadeLevels(const Ogre::Mesh& mesh, const LodDefinition& definition)
{
    for (const LodLevelDefinition& level : definition.levels)
        if (level.isManual() && !definition.automatic)
            for (const Ogre::String& name :
                 {level.meshName, besideDefinition(loddefFileName(mesh.getName()), level.meshName)}) {
                const Ogre::MeshPtr handMade = Ogre::MeshManager::getSingleton().getByName(name, mesh.getGroup());
                if (handMade && mGiven.count(handMade->getHandle()) > 0 && !mDefinitions.definitionFor(*handMade))
                    take(handMade);
            }
}

/// Of a mesh that has such levels now, by a definition or from its file.
void LodManager::noteHandMadeLevels(const Ogre::MeshPtr& mesh)
{
    const Flag applying(mIsApplying);
    for (const Ogre::MeshPtr& handMade : handMadeLevels(*mesh)) {
        mWithHandMade.insert(mesh->getHandle());
        if (mGiven.count(handMade->getHandle()) > 0)
            take(handMade);
    }
}

void LodManager::resourceCreated(const Ogre::ResourcePtr& resource)
{
    if (std::dynamic_pointer_cast<Ogre::Mesh>(resource) || std::dynamic_pointer_cast<LodDefinitionResource>(resource))
        listenTo(resource);
}

void LodManager::resourceRemove(const Ogre::ResourcePtr& resource)
{
    resource->removeListener(this);
    mHeard.erase(resource.get());
    if (std::dynamic_pointer_cast<Ogre::Mesh>(resource)) {
        mGiven.erase(resource->getHandle());
        mWithHandMade.erase(resource->getHandle());
    } else if (std::dynamic_pointer_cast<LodDefinitionResource>(resource))
        // Not at once: OGRE may be in the middle of clearing the group.
        mRemoved.emplace(resource->getGroup(), resource->getName());
}

void LodManager::loadingComplete(Ogre::Resource* resource)
{
    if (mIsApplying)
        return;
    const Ogre::ResourcePtr shared = resource->getCreator()->getByHandle(resource->getHandle());
    if (const auto definition = std::dynamic_pointer_cast<LodDefinitionResource>(shared))
        applyToMeshesOf({{definition->getGroup(), definition->getName()}});
    else if (const auto mesh = std::dynamic_pointer_cast<Ogre::Mesh>(shared))
        meet(mesh, Occasion::Loading);
}

void LodManager::unloadingComplete(Ogre::Resource* resource)
{
    if (dynamic_cast<Ogre::Mesh*>(resource))
        mGiven.erase(resource->getHandle());
}

bool LodManager::frameStarted(const Ogre::FrameEvent&)
{
    update();
    return true;
}

void LodManager::applyToMeshesOf(const std::set<DefinitionName>& definitions)
{
    for (const Ogre::MeshPtr& mesh : loadedMeshes())
        if (definitions.count({mesh->getGroup(), loddefFileName(mesh->getName())}) > 0)
            applyPolicy(mesh, Occasion::Later);
}

} // namespace lodsmith
