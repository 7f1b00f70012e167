#include <lodsmith/ogre/LodDefinitionManager.h>

#include "../files/InsidePath.h"
#include "FileLocations.h"
#include "MainThread.h"
#include "OgreGuard.h"

#include <lodsmith/core/Assert.h>
#include <lodsmith/loddef/LoddefFileName.h>
#include <lodsmith/loddef/LoddefXml.h>
#include <lodsmith/ogre/MeshFiles.h>

#include <OgreException.h>
#include <OgreLogManager.h>
#include <OgreResourceGroupManager.h>

#include <algorithm>

namespace lodsmith {

namespace {

constexpr const char* kResourceType = "LodDefinition";

// OGRE's meshes have 350.
constexpr Ogre::Real kAfterMeshes = 360;

/// OGRE creates what is declared itself, after the scripts, and throws when it is there already.
bool isDeclared(const Ogre::String& name, const Ogre::String& group)
{
    const auto declared = Ogre::ResourceGroupManager::getSingleton().getResourceDeclarationList(group);
    return std::any_of(declared.begin(), declared.end(), [&](const auto& declaration) {
        return declaration.resourceName == name && declaration.resourceType == kResourceType;
    });
}

/// The directory that has the definition of a mesh, failing that the one that has the mesh.
Result<Ogre::String> directoryFor(const Ogre::Mesh& mesh, const Ogre::String& name)
{
    if (name.empty())
        return Error{ErrorCode::InvalidSetting, "the mesh has no name that a file could be named for", mesh.getName()};
    if (const Ogre::Archive* directory = directoryWith(name, mesh.getGroup()))
        return directory->getName();
    if (const Result<std::filesystem::path> path = meshPath(mesh); !path)
        return path.error();
    return directoryWith(mesh.getName(), mesh.getGroup())->getName();
}

/// OGRE keeps a resource when its group is listed anew and its file is not there any more.
bool isFileGone(const LodDefinitionResource& resource)
{
    return resource.isFromFile() && !resource.isManuallyLoaded()
           && !Ogre::ResourceGroupManager::getSingleton().resourceExists(resource.getGroup(), resource.getName());
}

} // namespace

LodDefinitionManager::LodDefinitionManager()
{
    assertMainThread();
    mResourceType = kResourceType;
    mLoadOrder = kAfterMeshes;
    mScriptPatterns = {"*.loddef"};
    auto& groups = Ogre::ResourceGroupManager::getSingleton();
    LODSMITH_ASSERT(groups.getResourceManagers().count(mResourceType) == 0, "there is a LodDefinitionManager already");
    groups._registerResourceManager(mResourceType, this);
    groups._registerScriptLoader(this);
}

LodDefinitionManager::~LodDefinitionManager()
{
    auto& groups = Ogre::ResourceGroupManager::getSingleton();
    // While this still is the creator that its resources know.
    removeAll();
    groups._unregisterScriptLoader(this);
    groups._unregisterResourceManager(mResourceType);
}

LodDefinitionResourcePtr LodDefinitionManager::definitionFor(const Ogre::Mesh& mesh)
{
    assertMainThread();
    const Ogre::String name = loddefFileName(mesh.getName());
    if (name.empty() || mesh.getGroup() == Ogre::RGN_AUTODETECT)
        return nullptr;
    try {
        auto resource = std::static_pointer_cast<LodDefinitionResource>(findOrCreate(name, mesh.getGroup()));
        if (resource && isFileGone(*resource)) {
            resource->unload();
            return nullptr;
        }
        if (resource)
            resource->load();
        return resource;
    } catch (const Ogre::Exception& exception) {
        Ogre::LogManager::getSingleton().logError(name + ": " + exception.getDescription());
        return nullptr;
    }
}

Result<std::filesystem::path> LodDefinitionManager::exportScript(const Ogre::String& meshName,
                                                                 const LodDefinition& definition,
                                                                 const std::filesystem::path& directory)
{
    const std::string name = loddefFileName(meshName);
    if (name.empty())
        return Error{ErrorCode::InvalidSetting, "the mesh has no name that a file could be named for", meshName};
    Result<std::filesystem::path> path = pathInside(directory, name);
    if (!path)
        return path;
    const Result<Done> written = writeLoddefFile(path.value(), definition);
    if (!written)
        return written.error();
    return path;
}

Result<std::filesystem::path> LodDefinitionManager::pathFor(const Ogre::Mesh& mesh)
{
    assertMainThread();
    const Ogre::String name = loddefFileName(mesh.getName());
    const Result<Ogre::String> directory = directoryFor(mesh, name);
    if (!directory)
        return directory.error();
    return std::filesystem::path(directory.value()) / name;
}

Result<std::filesystem::path> LodDefinitionManager::save(const Ogre::Mesh& mesh, const LodDefinition& definition)
{
    assertMainThread();
    const Ogre::String name = loddefFileName(mesh.getName());
    const Result<Ogre::String> directory = directoryFor(mesh, name);
    if (!directory)
        return directory.error();
    Result<std::filesystem::path> path = exportScript(mesh.getName(), definition, directory.value());
    if (!path)
        return path;
    return guarded(name, [&] {
        if (!Ogre::ResourceGroupManager::getSingleton().resourceExists(mesh.getGroup(), name))
            listAgain(directory.value(), mesh.getGroup());
        // What was loaded is of an earlier file. Reading is left to whoever wants the definition.
        const Ogre::ResourcePtr resource = getResourceByName(name, mesh.getGroup());
        if (resource && resource->getGroup() == mesh.getGroup())
            resource->unload();
        return path;
    });
}

void LodDefinitionManager::parseScript(Ogre::DataStreamPtr& stream, const Ogre::String& groupName)
{
    const Ogre::String& name = stream->getName();
    if (!isDeclared(name, groupName))
        createOrRetrieve(name, groupName);
}

Ogre::Resource* LodDefinitionManager::createImpl(const Ogre::String& name, Ogre::ResourceHandle handle,
                                                 const Ogre::String& group, bool isManual,
                                                 Ogre::ManualResourceLoader* loader, const Ogre::NameValuePairList*)
{
    return OGRE_NEW LodDefinitionResource(this, name, handle, group, isManual, loader);
}

Ogre::ResourcePtr LodDefinitionManager::findOrCreate(const Ogre::String& name, const Ogre::String& group)
{
    const Ogre::ResourcePtr resource = getResourceByName(name, group);
    // Among groups of the global pool OGRE also answers with a resource of another group.
    if (resource && resource->getGroup() == group)
        return resource;
    if (Ogre::ResourceGroupManager::getSingleton().resourceExists(group, name))
        return createResource(name, group);
    return nullptr;
}

} // namespace lodsmith
