#pragma once

#include <lodsmith/core/Export.h>
#include <lodsmith/core/Result.h>
#include <lodsmith/generators/FoliageLevels.h>
#include <lodsmith/ogre/MeshReader.h>

#include <OgreMesh.h>

namespace lodsmith {

/// A new mesh that is a level of another one, in that one's group: the vertices that the level uses, with everything
/// OGRE knows about them, in the places the level says; the same submeshes, materials, bone assignments, skeleton,
/// poses and animations; no levels. Submeshes that MeshReader left alone are as in the original. Its bounds are those
/// of the original, widened for leaves that reach beyond. It can be saved, and be a hand-made level of the original.
///
/// Errors: InvalidSetting (there is a mesh of this name), Unsupported (positions of another type than three floats),
/// those of OGRE as Unsupported, OutOfMemory. Main thread only, as MeshReader.
///
/// @param mesh  stays as it is
/// @param data  what MeshReader::read() made of `mesh`
/// @param level of foliageLevels() of `data`, one that was made
LODSMITH_API Result<Ogre::MeshPtr> makeFoliageMesh(Ogre::Mesh& mesh, const MeshData& data, const FoliageLevel& level,
                                                   const Ogre::String& name);

/// Puts a hand-made mesh in the place of a generated level, at that level's value.
///
/// Errors: InvalidSetting (no such level, or `handMade` is the mesh itself), Unsupported (the mesh has living entities,
/// which OGRE would not survive). On an error the mesh is as it was. Main thread only, as MeshReader.
///
/// @param level 1 and up, as OGRE counts
LODSMITH_API Result<Done> replaceLevel(Ogre::Mesh& mesh, unsigned level, const Ogre::MeshPtr& handMade);

} // namespace lodsmith
