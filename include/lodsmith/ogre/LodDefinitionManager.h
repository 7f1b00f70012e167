#pragma once

#include <lodsmith/core/Export.h>
#include <lodsmith/core/Result.h>
#include <lodsmith/ogre/LodDefinitionResource.h>

#include <OgreMesh.h>
#include <OgreResourceManager.h>

#include <filesystem>

namespace lodsmith {

/// The `.loddef` files of OGRE's resource groups.
///
///     lodsmith::LodDefinitionManager definitions;
///     if (const auto resource = definitions.definitionFor(*mesh); resource && resource->definition())
///         use(lodsmith::lodConfig(*resource->definition(), mesh));
///
/// Registers itself with OGRE as manager of the resource type "LodDefinition" and as script loader for "*.loddef", so that
/// initialising a group finds its definitions, loading a group loads them, after its meshes, and clearing it takes them
/// away. No singleton: its owner makes one after Ogre::Root and destroys it before; only one may live at a time. Pointers
/// to its resources have to be gone before it is, as with OGRE's own managers. Main thread only, as MeshReader.
class LODSMITH_API LodDefinitionManager final : public Ogre::ResourceManager {
public:
    LodDefinitionManager();
    ~LodDefinitionManager() override;

    /// The definition that belongs to a mesh, loaded: the resource or file of the name loddefFileName(mesh.getName()) in
    /// the mesh's group, and nothing else. Null when there is none, also for a mesh whose group OGRE is still to find, and
    /// for a file that cannot be opened, which is logged. A file with errors is a resource without definition.
    ///
    /// Files that come to a group later are found as soon as the group knows them (a location added, or
    /// ResourceGroupManager::createResource()). A loaded definition stays as it is until it is reloaded. One whose file the
    /// group does not know any more is unloaded and counts as none.
    LodDefinitionResourcePtr definitionFor(const Ogre::Mesh& mesh);

    /// Writes a definition to its place below a directory, loddefFileName(meshName), whole or not at all; directories
    /// are made. Returns the file's path. The resource of that name, if any, reads it on reload().
    ///
    /// No mesh name leads out of the directory. Refused are: names that are absolute, or have empty parts, ".", "..",
    /// backslashes, colons or control characters; and those that lead out over symbolic links among their directories. A
    /// link in place of the file itself is replaced, not followed. Touches no OGRE object; any thread.
    ///
    /// Errors: InvalidSetting (a name as above, or without a base name; a definition with errors), BadFile (an
    /// `original` that is no definition), Io.
    static Result<std::filesystem::path> exportScript(const Ogre::String& meshName, const LodDefinition& definition,
                                                      const std::filesystem::path& directory);

    /// The file of the definition that belongs to a mesh: the one that the mesh's group has in a directory, or else
    /// where it would be, beside the mesh. Errors: InvalidSetting (a mesh without a base name), and those of meshPath().
    static Result<std::filesystem::path> pathFor(const Ogre::Mesh& mesh);

    /// Writes a definition to pathFor(mesh), as exportScript() does, and lets the mesh's group know the file. It counts for the
    /// mesh from now on: definitionFor() reads it, and LodManager applies it when the mesh is loaded again, or at apply().
    /// Errors: those of pathFor() and exportScript().
    Result<std::filesystem::path> save(const Ogre::Mesh& mesh, const LodDefinition& definition);

    /// For OGRE, which calls it for each file of a group that is initialised: makes the resource; the file is read when
    /// that is loaded.
    void parseScript(Ogre::DataStreamPtr& stream, const Ogre::String& groupName) override;

private:
    Ogre::Resource* createImpl(const Ogre::String& name, Ogre::ResourceHandle handle, const Ogre::String& group,
                               bool isManual, Ogre::ManualResourceLoader* loader,
                               const Ogre::NameValuePairList* createParams) override;
    Ogre::ResourcePtr findOrCreate(const Ogre::String& name, const Ogre::String& group);
};

} // namespace lodsmith
