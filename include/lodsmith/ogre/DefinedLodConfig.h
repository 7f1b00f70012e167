#pragma once

#include <lodsmith/core/Export.h>
#include <lodsmith/core/Result.h>
#include <lodsmith/loddef/LodDefinition.h>
#include <lodsmith/ogre/AutomaticLods.h>
#include <lodsmith/ogre/LodConfig.h>

#include <vector>

namespace lodsmith {

/// What becomes of a definition when it meets its mesh.
struct DefinedLodConfig {
    LodConfig config;
    /// What the definition asks for and the mesh or its group does not have, one sentence each, the definition's name as
    /// file. NotFound, Unsupported or InvalidSetting for a hand-made level that is left out; NotFound for a submesh.
    std::vector<Error> leftOut;
};

/// A definition as the configuration of one mesh.
///
/// An automatic one becomes automaticLodConfig(mesh, automatic). Else the levels are those of the definition, nearest first, with its
/// strategy and simplifyOptions(). No levels at all mean that the mesh is to have none. A hand-made level is looked for as a
/// resource in the mesh's group by its name, failing that by its path relative to the definition; it is loaded, and stands
/// in the configuration by the name it was found under. One that is missing, cannot be loaded, has levels of its own or is
/// the mesh itself is left out, and everything else stays. Entities of the mesh that live are not looked at here.
///
/// Errors: InvalidSetting (findErrors(); automatic settings out of range), InvalidGeometry (automatic levels for a mesh without a bounding radius).
/// Main thread only, as MeshReader.
///
/// @param definitionName the definition's name in the mesh's group, which hand-made levels are relative to; empty for
///                       loddefFileName(mesh->getName())
LODSMITH_API Result<DefinedLodConfig> lodConfig(const LodDefinition& definition, const Ogre::MeshPtr& mesh,
                                                const Ogre::String& definitionName = {},
                                                const AutomaticLods& automatic = {});

} // namespace lodsmith
