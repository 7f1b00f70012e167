#pragma once

#include "MeshBuilders.h"

#include <lodsmith/ogre/LodConfig.h>

#include <OgreMesh.h>
#include <OgreRenderOperation.h>

#include <cstdint>
#include <string>
#include <vector>

namespace lodsmith::test {

struct OgreMeshOptions {
    /// Every submesh uses vertex buffer 0 as the mesh's shared vertices; else each has its buffer, as a copy, to itself.
    bool shared = false;
    bool wideIndices = false; ///< 32 instead of 16 bits
};

/// The mesh as OGRE would load it: position, normal, texture coordinates and colour interleaved; bones as assignments; pose
/// offsets as poses; bounds set; loaded. Importance has no place in it.
Ogre::MeshPtr makeOgreMesh(const std::string& name, const TestMesh& mesh, const OgreMeshOptions& options = {});

/// Fresh index data with a buffer of its own, which holds `before` other indices (of value 0) in front.
Ogre::IndexData* makeIndexData(const std::vector<std::uint32_t>& indices, bool wide = false, std::size_t before = 0);

/// Gives a submesh another level 0.
void setIndices(Ogre::SubMesh& subMesh, const std::vector<std::uint32_t>& indices,
                Ogre::RenderOperation::OperationType type, bool wide = false, std::size_t before = 0);

/// The indices that are drawn.
std::vector<std::uint32_t> indicesOf(const Ogre::IndexData& data);

/// Levels at 10, 20, ... that remove these shares of the vertices.
LodConfig proportional(const Ogre::MeshPtr& mesh, const std::vector<double>& removed);

/// Gives a mesh levels at 10, 20, ...: other meshes of its group, which need not be there.
void setHandMadeLevels(Ogre::Mesh& mesh, const std::vector<std::string>& names);

/// Gives a mesh one level, at 10: another mesh of its group, which need not be there.
void setHandMadeLevel(Ogre::Mesh& mesh, const std::string& name);

/// Levels that hold the first triangles of each submesh, `shares` (0..1) of them: a chain without a simplifier.
LodChain shortenedChain(const MeshView& mesh, const std::vector<double>& shares);

/// What has to hold for the LOD levels of any mesh OGRE is to draw, clone and save: one sentence for each thing that does
/// not. Lists as long as the levels, index data everywhere, ranges inside their buffers, indices inside the vertices, width,
/// usage and shadow buffer as at level 0, whole triangles with different corners (or one with none), values in order.
std::vector<std::string> brokenLevels(const Ogre::Mesh& mesh);

} // namespace lodsmith::test
