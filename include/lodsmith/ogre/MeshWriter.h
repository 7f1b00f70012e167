#pragma once

#include <lodsmith/core/Export.h>
#include <lodsmith/core/LodChain.h>
#include <lodsmith/core/Result.h>
#include <lodsmith/ogre/LodConfig.h>
#include <lodsmith/ogre/MeshReader.h>

namespace lodsmith {

/// The way out: finished levels onto an OGRE mesh. Main thread only, as MeshReader.
class LODSMITH_API MeshWriter {
public:
    /// Replaces the mesh's LOD levels by those of `config`: generated ones from `chain` in order, without the skipped ones,
    /// and manual ones. Sets the strategy, and for each level the user's value and the one that the strategy makes of it.
    ///
    /// Level 0 and the vertex buffers stay as they are. Index width, usage and shadow buffer of new index buffers follow the
    /// submesh's level 0. A submesh without triangles at a level gets one of zero area, since render systems crash over
    /// empty index buffers. A submesh that was left alone draws at every level what it draws at level 0. OGRE has one
    /// operation type for all levels of a submesh, so that level 0 of a strip or fan becomes a list as soon as a generated
    /// level is stored. Edge lists are freed; where there were some, OGRE builds them again on demand.
    ///
    /// Existing entities see generated levels at once. Manual levels reach only entities made afterwards, or all of them with
    /// LodConfig::reinitialiseEntities.
    ///
    /// Errors: InvalidSetting (unknown strategy; values not finite, not positive or not rising or falling as the strategy
    /// demands; the mesh as its own manual level), NotFound (no such manual mesh in the mesh's group), Unsupported (a manual
    /// mesh with levels of its own; manual levels, now or earlier, on a mesh with a living entity, unless LodConfig::reinitialiseEntities: OGRE
    /// would end the process), InvalidGeometry (the mesh is no longer what `data` was read from), OutOfMemory; file is the mesh's name.
    /// On an error the mesh is as it was.
    ///
    /// @param data  what MeshReader::read() made of the mesh
    /// @param chain what simplify() made of `data`, one level for each generated level of `config`; others are misuse
    static Result<Done> write(const LodConfig& config, const MeshData& data, const LodChain& chain);

    /// Takes all LOD levels off the mesh and frees its edge lists, as write() does. The strategy stays. Entities go back to
    /// level 0 with the next camera notification.
    static void removeLevels(Ogre::Mesh& mesh);
};

} // namespace lodsmith
