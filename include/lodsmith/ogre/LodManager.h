#pragma once

#include <lodsmith/core/Export.h>
#include <lodsmith/core/Result.h>
#include <lodsmith/ogre/LodDefinitionManager.h>
#include <lodsmith/ogre/QueuedProgressiveMeshGenerator.h>

#include <OgreMesh.h>
#include <OgreResourceGroupManager.h>

#include <cstdint>
#include <map>
#include <vector>

namespace lodsmith {

/// Which meshes get levels by themselves.
struct LodPolicy {
    /// Off: nothing happens when a mesh is loaded.
    bool enabled = true;
    /// Meshes without a definition get automatic levels; off: definitions alone count.
    bool automatic = true;
    /// Meshes with fewer triangles get no automatic levels.
    std::uint32_t minTriangles = 500;
    /// A mesh that comes with levels of its own gets automatic ones in their place; off: it keeps what it has. A
    /// definition replaces them in any case; they come back when the mesh is loaded again.
    bool replaceLevels = false;
    /// Resource groups whose meshes are looked at; empty: all but OGRE's internal one.
    std::vector<Ogre::String> groups;
    /// Names of meshes to be looked at, `*` standing for any characters; empty: all.
    std::vector<Ogre::String> names;
};

/// What was decided about a mesh.
enum class LodDecision {
    LeftAlone, ///< by the policy, or for want of a definition
    Queued,    ///< levels are generated in the background
    Attached,  ///< levels are on the mesh
    Removed,   ///< the definition has no levels, and the mesh has none any more
};

/// Gives each mesh its levels when it is loaded: those of its definition, else automatic ones.
///
///     lodsmith::LodDefinitionManager definitions;
///     lodsmith::QueuedProgressiveMeshGenerator queue;
///     lodsmith::LodManager manager(definitions, queue); // and every mesh that is loaded from now on gets levels
///
/// It hears of a mesh through OGRE's resource groups when it is created, and listens to the mesh itself from then on, so that
/// loading it again, at any time and from anywhere, gives it its levels again. (MeshSerializerListener has room for one
/// listener, which may be the program's, and does not hear of meshes that come from no file.) It listens to definitions in the same way: one that is
/// reloaded is applied again to the meshes that it belongs to.
///
/// Reduced levels come from the queue. A definition with hand-made levels is applied at once, within the loading: later,
/// entities would be alive, for which OGRE cannot change such levels. Meshes that are loaded meanwhile, as hand-made levels, get
/// none of their own.
///
/// Errors are logged to OGRE's log; those of the queue also come through its signals. Made after the manager and the queue that it uses, and
/// destroyed before them. Main thread only, as MeshReader.
class LODSMITH_API LodManager : private Ogre::ResourceGroupListener, private Ogre::Resource::Listener {
public:
    /// Also applies the policy to the meshes that are loaded by now.
    LodManager(LodDefinitionManager& definitions, QueuedProgressiveMeshGenerator& queue, const LodPolicy& policy = {});
    ~LodManager() override;
    LodManager(const LodManager&) = delete;
    LodManager& operator=(const LodManager&) = delete;

    const LodPolicy& policy() const { return mPolicy; }
    /// For meshes that are loaded from now on. applyToAll() is for the others.
    void setPolicy(const LodPolicy& policy) { mPolicy = policy; }

    /// Decides about a loaded mesh anew, whatever the policy says about groups, names and being enabled. Errors: those of
    /// lodConfig() and of generation, and BadFile for a definition with errors: then the mesh stays as it is.
    Result<LodDecision> apply(const Ogre::MeshPtr& mesh);

    /// Applies the policy to all loaded meshes.
    void applyToAll();

private:
    void resourceCreated(const Ogre::ResourcePtr& resource) override;
    void resourceRemove(const Ogre::ResourcePtr& resource) override;
    void loadingComplete(Ogre::Resource* resource) override;

    void meet(const Ogre::MeshPtr& mesh);
    void applyPolicy(const Ogre::MeshPtr& mesh);
    void applyToMeshesOf(const LodDefinitionResource& definition);
    bool isWanted(const Ogre::Mesh& mesh) const;
    Result<LodDecision> applyAutomatic(const Ogre::MeshPtr& mesh);
    Result<LodDecision> applyDefinition(const Ogre::MeshPtr& mesh, const LodDefinition& definition);

    LodDefinitionManager& mDefinitions;
    QueuedProgressiveMeshGenerator& mQueue;
    LodPolicy mPolicy;
    std::map<Ogre::ResourceHandle, bool> mHadLevels; ///< of loaded meshes: whether they came with levels of their own
    bool mIsApplying = false; ///< what is loaded now is loaded for a mesh that is being dealt with
};

} // namespace lodsmith
