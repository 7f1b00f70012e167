#pragma once

#include <lodsmith/core/Export.h>
#include <lodsmith/core/MeshView.h>
#include <lodsmith/core/Result.h>
#include <lodsmith/ogre/MeshReader.h>

#include <OgreMesh.h>

#include <memory>
#include <vector>

namespace lodsmith {

/// One level of an OGRE mesh in plain arrays, ready for any thread. Owns what view() shows, or shares it with the MeshData it
/// was read with. Can be moved, not copied; the arrays stay where they are.
class LODSMITH_API LevelData {
public:
    const MeshView& view() const { return mView; }

private:
    friend class LevelReader;
    std::shared_ptr<const MeshData> mVertices;
    std::vector<std::unique_ptr<unsigned char[]>> mBlocks;
    MeshView mView;
};

/// Any level of a mesh as it is now: what OGRE draws at that level, read as MeshReader reads level 0.
///
/// Main thread only, as MeshReader.
class LODSMITH_API LevelReader {
public:
    /// MeshReader::read(), for several levels to share.
    /// @param poses as for MeshReader::read()
    static Result<std::shared_ptr<const MeshData>> readLevelZero(const Ogre::Mesh& mesh,
                                                                 const std::vector<PoseMoment>* poses = nullptr);

    /// Level 0 is `levelZero` itself. A generated level is the vertex buffers of `levelZero` with the level's own triangles,
    /// copied at the width of their buffer, without the triangle without area that stands for an empty list. A hand-made level
    /// is level 0 of the other mesh in the same poses, which OGRE loads if it is not, and has vertex buffers and submeshes of its own.
    ///
    /// Errors: InvalidSetting (no such level), NotFound (the mesh of a hand-made level), InvalidGeometry (the mesh has not
    /// the submeshes that `levelZero` has, so it has changed), IndexOutOfRange, Unsupported (a submesh without that level, a
    /// buffer that cannot be read), OutOfMemory, and for a hand-made level those of MeshReader::read(); file is the mesh's
    /// name, subMesh its number in the mesh.
    ///
    /// @param levelZero of `mesh`; must not be null
    static Result<LevelData> read(const Ogre::Mesh& mesh, const std::shared_ptr<const MeshData>& levelZero,
                                  unsigned level);
};

} // namespace lodsmith
