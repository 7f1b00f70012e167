#pragma once

#include <lodsmith/core/Result.h>
#include <lodsmith/ogre/LodConfig.h>

#include <vector>

namespace lodsmith {

/// What OGRE has to say about a configuration, found out before anything is changed.
struct LodPlan {
    Ogre::LodStrategy* strategy = nullptr;
    std::vector<Ogre::Real> values;          ///< one a level: LodLevel::value as the strategy compares it
    std::vector<Ogre::MeshPtr> manualMeshes; ///< one a level, loaded; null for generated levels
};

/// The mesh of a manual level, loaded, from the group of the mesh that is to have the level.
/// Errors (without file): NotFound (no such mesh, or it cannot be loaded), InvalidSetting (it is `owner` itself), Unsupported
/// (it has levels of its own).
Result<Ogre::MeshPtr> findManualMesh(const Ogre::String& name, const Ogre::Mesh& owner);

/// Checks strategy, values, importances and manual meshes of a configuration, and loads the latter.
/// Errors (without file): InvalidSetting (unknown strategy; values not finite, not positive or not in order; importances out
/// of range; hand-made levels among candidates or more than submeshes; a manual mesh that is the mesh itself), NotFound (no such manual mesh), Unsupported (a manual mesh with levels of its own, or manual
/// levels now or before on a mesh with a living entity that is not to be initialised again: OGRE ends the process over either).
Result<LodPlan> planLods(const LodConfig& config);

} // namespace lodsmith
