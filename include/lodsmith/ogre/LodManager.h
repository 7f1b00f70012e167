#pragma once

#include <lodsmith/core/Export.h>
#include <lodsmith/core/Result.h>
#include <lodsmith/ogre/LodDefinitionManager.h>
#include <lodsmith/ogre/QueuedProgressiveMeshGenerator.h>

#include <OgreFrameListener.h>
#include <OgreMesh.h>
#include <OgreResourceGroupManager.h>

#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <utility>
#include <vector>

namespace lodsmith {

/// Which meshes get levels by themselves, and what levels these are.
struct LodPolicy {
    /// Off: no mesh gets levels when it is loaded.
    bool enabled = true;
    /// Meshes without a definition get automatic levels; off: definitions alone count.
    bool automatic = true;
    /// What automatic levels are like, also those of definitions that ask for them.
    AutomaticLods automaticLods;
    /// Meshes with fewer triangles get no automatic levels.
    std::uint32_t minTriangles = 500;
    /// A mesh that has levels of its own, from its file or by other hands than LodManager's, gets automatic ones in their
    /// place; off: it keeps what it has. A definition replaces them in any case; they come back when the mesh is loaded again.
    bool replaceLevels = false;
    /// Lets hand-made levels reach entities that live, by initialising these again: see LodConfig::reinitialiseEntities. Off: a
    /// definition that would need it is refused until the mesh is loaded again, or its entities are gone. While a mesh
    /// is loaded again it is done in any case, since OGRE does it itself then.
    bool reinitialiseEntities = false;
    /// Resource groups whose meshes are looked at; empty: all but OGRE's internal one.
    std::vector<Ogre::String> groups;
    /// Names of meshes to be looked at, `*` standing for any characters; empty: all.
    std::vector<Ogre::String> names;
};

/// What was decided about a mesh.
enum class LodDecision {
    LeftAlone, ///< by the policy, for want of a definition, or as another mesh's hand-made level
    Queued,    ///< levels are generated in the background
    Attached,  ///< levels are on the mesh
    Removed,   ///< the mesh has no levels any more: its definition has none, or what gave it some does so no longer
};

/// Gives each mesh its levels when it is loaded: those of its definition, else automatic ones.
///
///     lodsmith::LodDefinitionManager definitions;
///     lodsmith::QueuedProgressiveMeshGenerator queue;
///     lodsmith::LodManager manager(definitions, queue); // and every mesh that is loaded from now on gets levels
///
/// It hears of a mesh through OGRE's resource groups when it is created, and listens to the mesh itself from then on, so that
/// loading it again, at any time and from anywhere, gives it its levels again. (MeshSerializerListener has room for one
/// listener, which may be the program's, and does not hear of meshes that come from no file.) It listens to definitions in
/// the same way: one that is reloaded is applied again to the meshes that it belongs to, and when one is removed, with the
/// next frame, they get what they have without it.
///
/// Reduced levels come from the queue. A definition with hand-made levels is applied at once, within the loading: later,
/// entities would be alive, for which OGRE cannot change such levels (LodPolicy::reinitialiseEntities). A mesh that is a
/// hand-made level of another has no levels, which OGRE would not allow: it gets none, and automatic ones that it has are taken
/// off it.
///
/// Errors are logged to OGRE's log; those of the queue also come through its signals. Made after Ogre::Root and the manager and the
/// queue that it uses, and destroyed before them. Main thread only, as MeshReader.
class LODSMITH_API LodManager : private Ogre::ResourceGroupListener,
                                private Ogre::Resource::Listener,
                                private Ogre::FrameListener {
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

    /// Gives a loaded mesh the levels of another definition than its own, at once or from the background as always: for editors,
    /// whose definition is not saved yet. An automatic one gives the automatic levels of the policy. It counts once; whatever makes
    /// this object decide about the mesh anew (loading it again, apply(), its definition's reload) goes by what is there then.
    /// Errors: those of lodConfig() and of generation, and then the mesh stays as it is.
    Result<LodDecision> apply(const Ogre::MeshPtr& mesh, const LodDefinition& definition);

    /// Applies the policy to all loaded meshes. Levels that this object gave and the policy does not ask for any more go.
    void applyToAll();

    /// Deals with definitions that were removed. OGRE's frames call it; a program without frames does so itself.
    void update();

private:
    /// Whether OGRE makes the entities of a mesh anew by itself.
    enum class Occasion { Loading, Later };
    using DefinitionName = std::pair<Ogre::String, Ogre::String>; ///< its group, and its name there

    void resourceCreated(const Ogre::ResourcePtr& resource) override;
    void resourceRemove(const Ogre::ResourcePtr& resource) override;
    void loadingComplete(Ogre::Resource* resource) override;
    void unloadingComplete(Ogre::Resource* resource) override;
    bool frameStarted(const Ogre::FrameEvent& event) override;

    void listenTo(const Ogre::ResourcePtr& resource);
    void meet(const Ogre::MeshPtr& mesh, Occasion occasion);
    void applyPolicy(const Ogre::MeshPtr& mesh, Occasion occasion);
    void applyToMeshesOf(const std::set<DefinitionName>& definitions);
    bool isWanted(const Ogre::Mesh& mesh) const;
    bool isHandMadeLevel(const Ogre::MeshPtr& mesh) const;
    bool hasLevelsOfItsOwn(const Ogre::Mesh& mesh) const;
    Result<LodDecision> decide(const Ogre::MeshPtr& mesh, Occasion occasion);
    Result<LodDecision> decideWithoutDefinition(const Ogre::MeshPtr& mesh, Occasion occasion);
    Result<LodDecision> decideByDefinition(const Ogre::MeshPtr& mesh, const LodDefinition& definition,
                                           Occasion occasion);
    Result<LodDecision> give(LodConfig config, Occasion occasion);
    void take(const Ogre::MeshPtr& mesh);
    void freeHandMadeLevels(const Ogre::Mesh& mesh, const LodDefinition& definition);
    void noteHandMadeLevels(const Ogre::MeshPtr& mesh);

    LodDefinitionManager& mDefinitions;
    QueuedProgressiveMeshGenerator& mQueue;
    LodPolicy mPolicy;
    /// All that is listened to; OGRE does not tell when a manager removes all of its resources.
    std::map<const Ogre::Resource*, std::weak_ptr<Ogre::Resource>> mHeard;
    std::set<Ogre::ResourceHandle> mGiven;        ///< meshes whose levels, there or on their way, are from here
    std::set<Ogre::ResourceHandle> mWithHandMade; ///< meshes that have, or had, hand-made levels
    std::set<DefinitionName> mRemoved;            ///< since the last update
    bool mIsApplying = false;                     ///< what is loaded now is loaded for a mesh that is being dealt with
};

} // namespace lodsmith
