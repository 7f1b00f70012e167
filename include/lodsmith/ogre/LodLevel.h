#pragma once

#include <lodsmith/core/Simplify.h>

#include <OgrePrerequisites.h>

namespace lodsmith {

/// One level of detail as a user states it.
struct LodLevel {
    /// What the strategy's user means: a distance in world units, a number of pixels. Never OGRE's transformed value.
    Ogre::Real value = 0;
    /// How far the mesh is reduced; not used by a manual level.
    LevelTarget target;
    /// Name of a hand-made mesh that is this level; empty for a generated one.
    Ogre::String manualMeshName;

    bool isManual() const { return !manualMeshName.empty(); }
};

} // namespace lodsmith
