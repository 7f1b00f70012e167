#pragma once

#include <lodsmith/core/Export.h>
#include <lodsmith/core/MeshView.h>
#include <lodsmith/core/Result.h>

#include <OgreMesh.h>

#include <memory>
#include <string>
#include <vector>

namespace lodsmith {

/// A moment in which a mesh is looked at.
struct PoseMoment {
    enum class Kind {
        Skeleton, ///< of an animation of the skeleton, or of one that it is linked to
        Morph,    ///< of a morph animation of the mesh: a key frame
        Pose,     ///< a pose of the mesh, at full influence
    };
    Kind kind = Kind::Skeleton;
    std::string name;     ///< of the animation or pose
    float seconds = 0.0f; ///< since the animation's beginning; 0 for a pose
};

inline bool operator==(const PoseMoment& a, const PoseMoment& b)
{
    return a.kind == b.kind && a.name == b.name && a.seconds == b.seconds;
}

/// A copy of an OGRE mesh's level 0 in plain arrays, ready for any thread. Owns everything that view() shows: for each
/// vertex 12 bytes of position and of normal, 4 for each texture coordinate, 16 of colour, 24 of bones, 12 for each pose
/// or morph frame, 12 for each pose that is shown (poses()) and 4 of importance, as far as there are such; indices at the width
/// of their buffer. Can be moved, not copied.
class LODSMITH_API MeshData {
public:
    /// The arrays stay where they are when this object is moved; the MeshView itself moves with it.
    const MeshView& view() const { return mView; }

    /// Frees the arrays. What view() says about counts stays true; its streams and indices are null then.
    void releaseArrays();

    /// For each OGRE submesh the number of its SubMeshView in view(), or -1 when it was left alone (see notes()).
    const std::vector<int>& subMeshOf() const { return mSubMeshOf; }

    /// The moments that the poses in view() show, in their order.
    const std::vector<PoseMoment>& poses() const { return mPoses; }

    /// One sentence for each thing that was left alone or converted: "submesh 2: a line list, left as it is".
    const std::vector<std::string>& notes() const { return mNotes; }

private:
    friend class MeshReader;
    std::vector<std::unique_ptr<unsigned char[]>> mBlocks;
    MeshView mView;
    std::vector<int> mSubMeshOf;
    std::vector<PoseMoment> mPoses;
    std::vector<std::string> mNotes;
};

/// The way in: OGRE mesh to plain arrays.
///
/// Reads level 0: shared and own vertex data, vertexStart and vertexCount (a buffer that prepareForShadowVolume() has doubled
/// is read once), 16- and 32-bit indices, indexStart and indexCount, strips and fans (as lists of the same winding), every
/// number type OGRE has for positions, normals, texture coordinates and colours, bone assignments (the four heaviest a
/// vertex, made to sum to 1), pose offsets, and morph frames as offsets from the rest position. With them it gives positions at
/// up to four moments of the skeleton's animations and up to four poses and morph frames: those most unlike rest and one
/// another, in how surfaces bend and stretch, of at most 128 key frames and moments halfway between two. Submeshes of points or lines
/// and those without indices are left alone and noted. Numbers are copied as they are, whether finite or not.
///
/// Each buffer is locked once, for reading. Buffers in system memory (all of them without a render system) and those
/// with a shadow buffer can always be read; from others a render system may refuse it, which is an error here.
///
/// Main thread only, which is the thread that was the first to call into the adapter: OGRE does not lock its meshes.
class LODSMITH_API MeshReader {
public:
    /// Errors: IndexOutOfRange (an index, an index range or a pose beyond its buffer), InvalidGeometry (vertices or positions
    /// missing, or fewer than declared), Unsupported (no submeshes, positions of an unknown type, a buffer that cannot be
    /// read), OutOfMemory; file is the mesh's name, subMesh its number in the mesh, item the position of a wrong index.
    ///
    /// @param subMeshImportance as LodConfig::subMeshImportance; numbers out of range are misuse. Vertex buffers that no
    ///                          important submesh uses get no importance.
    /// @param poses             moments to read the mesh in, such as those of another mesh that it is to be compared with;
    ///                          if one of them cannot be shown, there are no poses. Null to have moments chosen.
    static Result<MeshData> read(const Ogre::Mesh& mesh, const std::vector<float>& subMeshImportance = {},
                                 const std::vector<PoseMoment>* poses = nullptr);
};

} // namespace lodsmith
