#pragma once

#include <OgreHardwareIndexBuffer.h>
#include <OgreMesh.h>
#include <OgreResource.h>

#include <cstddef>
#include <tuple>
#include <vector>

namespace Ogre {
class Entity;
class SceneNode;
} // namespace Ogre

namespace lodsmith {

/// An entity of a mesh that may be changed, unloaded, loaded again or removed meanwhile. Notices such things in follow(), and has
/// no entity while the mesh is not loaded.
class ShownMesh : private Ogre::Resource::Listener {
public:
    enum class Change { None, Levels, Mesh };

    explicit ShownMesh(Ogre::SceneNode& node);
    ~ShownMesh() override;
    ShownMesh(const ShownMesh&) = delete;
    ShownMesh& operator=(const ShownMesh&) = delete;

    /// A loaded mesh. Exceptions are OGRE's; then it has none.
    void show(const Ogre::MeshPtr& mesh);
    void clear();
    /// The most that has happened to the mesh since this was called last. Exceptions are OGRE's.
    Change follow();

    /// Null when there is none, or when follow() has found it removed.
    const Ogre::MeshPtr& mesh() const { return mMesh; }
    /// Null when the mesh is not loaded.
    Ogre::Entity* entity() const { return mIsStale ? nullptr : mEntity; }

private:
    /// What tells the levels of a mesh from those of another time. It keeps the index buffers alive, so that no new one has
    /// the address of an old one.
    struct Levels {
        std::size_t stateCount = 0;
        const Ogre::LodStrategy* strategy = nullptr;
        std::vector<std::tuple<Ogre::Real, Ogre::ResourceHandle, std::size_t>> usages;
        std::vector<std::tuple<Ogre::HardwareIndexBufferSharedPtr, std::size_t, std::size_t>> lists;

        bool operator==(const Levels& other) const;
    };
    static Levels levelsOf(const Ogre::Mesh& mesh);

    void unloadingComplete(Ogre::Resource* resource) override;
    void createEntity();
    void destroyEntity();
    bool isRemoved() const;

    Ogre::SceneNode& mNode;
    Ogre::MeshPtr mMesh;
    Ogre::Entity* mEntity = nullptr;
    bool mIsStale = false; ///< the entity is of a mesh that was unloaded
    Levels mLevels;
};

} // namespace lodsmith
