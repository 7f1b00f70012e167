#pragma once

#include "Blocks.h"

#include <lodsmith/core/Result.h>

#include <OgreSubMesh.h>

#include <cstdint>
#include <string>

namespace lodsmith {

/// A triangle list in a block.
struct TriangleList {
    const void* indices = nullptr;
    std::uint32_t count = 0; ///< indices, a multiple of 3
    int indexBytes = 2;      ///< 2 or 4, as in the buffer it came from
};

/// Why a submesh cannot be simplified ("a line list"); empty when it is made of indexed triangles.
std::string reasonToLeaveAlone(const Ogre::SubMesh& subMesh);

/// Copies indexed triangles; strips and fans become lists with the same winding, without the triangles that name a vertex
/// twice (strips are stitched with them).
/// Errors (without file and submesh): IndexOutOfRange, InvalidGeometry.
Result<TriangleList> readTriangles(const Ogre::IndexData& data, Ogre::RenderOperation::OperationType type,
                                   std::uint32_t vertexCount, Blocks& blocks);

} // namespace lodsmith
