#pragma once

#include <OgreMesh.h>

#include <cstddef>

namespace lodsmith {

/// What shows that a mesh was unloaded, loaded again or changed.
struct MeshState {
    explicit MeshState(const Ogre::Mesh& mesh) : loaded(mesh.isLoaded()), changes(mesh.getStateCount()) {}
    bool operator==(const MeshState& other) const { return loaded == other.loaded && changes == other.changes; }

    bool loaded;
    std::size_t changes;
};

} // namespace lodsmith
