#pragma once

#include "Blocks.h"

#include <lodsmith/core/MeshView.h>
#include <lodsmith/core/Result.h>
#include <lodsmith/ogre/MeshReader.h>

#include <OgreMesh.h>
#include <OgreVertexIndexData.h>

#include <string>
#include <vector>

namespace lodsmith {

/// One set of vertices of a mesh: the shared ones or those of one submesh.
struct VertexSource {
    const Ogre::VertexData* vertices = nullptr;
    const Ogre::Mesh::VertexBoneAssignmentList* bones = nullptr;
    /// The number by which poses and animation tracks name it: 0 for the shared vertices, else submesh number + 1.
    unsigned short handle = 0;
};

/// One set of vertices, copied.
struct ReadVertices {
    VertexBufferView view;
    std::vector<PoseMoment> offsets; ///< what each of view.offsets is
};

/// Copies one set of vertices, with everything that moves them, into new blocks. Adds a note for what was left out.
/// Errors (without file and submesh): InvalidGeometry, IndexOutOfRange, Unsupported.
Result<ReadVertices> readVertices(const Ogre::Mesh& mesh, const VertexSource& source, Blocks& blocks,
                                  std::vector<std::string>& notes);

} // namespace lodsmith
