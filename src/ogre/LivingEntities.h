#pragma once

#include <OgreMesh.h>

#include <vector>

namespace Ogre {
class Entity;
} // namespace Ogre

namespace lodsmith {

/// All entities of a mesh, in all scene managers.
std::vector<Ogre::Entity*> livingEntities(const Ogre::Mesh& mesh);

} // namespace lodsmith
