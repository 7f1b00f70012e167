#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace lodsmith {

/// A strided stream of float tuples in memory that the caller owns; null when the mesh has no such attribute.
/// Neither alignment nor tight packing is needed.
struct FloatStream {
    const void* data = nullptr;
    std::size_t stride = 0; ///< bytes from one vertex to the next

    explicit operator bool() const { return data != nullptr; }

    /// Copies `count` floats of vertex `index` to `out`.
    void read(std::size_t index, int count, float* out) const
    {
        std::memcpy(out, static_cast<const char*>(data) + index * stride,
                    sizeof(float) * static_cast<std::size_t>(count));
    }
};

/// One texture coordinate set.
struct UvStream {
    FloatStream stream;
    int components = 2; ///< floats a vertex, 1..4
};

/// The bones that move a vertex: up to four, unused entries have weight 0. The order of the entries means nothing.
struct BoneInfluences {
    std::uint16_t bone[4] = {0, 0, 0, 0};
    float weight[4] = {0.0f, 0.0f, 0.0f, 0.0f}; ///< 0..1, summing to 1 on a skinned vertex
};

/// One vertex buffer. Every stream that is not null holds `vertexCount` entries.
struct VertexBufferView {
    std::uint32_t vertexCount = 0;
    FloatStream positions; ///< 3 floats, world units; must not be null when vertexCount > 0
    FloatStream normals;   ///< 3 floats, any length; null for none
    std::vector<UvStream> uvSets;
    FloatStream colours;                   ///< 4 floats r, g, b, a, 0..1; null for none
    const BoneInfluences* bones = nullptr; ///< vertexCount entries; null for none
    std::vector<FloatStream> offsets; ///< 3 floats each: how far a pose or morph frame moves the vertex, world units
    /// 3 floats each: where animation takes the vertex, world units; null where it stays at rest. Pose i is the same moment
    /// in every buffer. A buffer that has fewer poses than another is at rest in those that it lacks.
    std::vector<FloatStream> poses;
    FloatStream importance; ///< 1 float, 0..1: deviation counts 1/(1-x) times as much here; 1 locks the vertex
};

/// A triangle list into one vertex buffer: three consecutive indices a triangle, counter-clockwise front.
struct SubMeshView {
    std::uint32_t vertexBuffer = 0; ///< which of MeshView::vertexBuffers; several submeshes may share one
    const void* indices = nullptr;
    std::uint32_t indexCount = 0; ///< a multiple of 3; 0 for an empty submesh
    int indexBytes = 4;           ///< 2 or 4

    std::uint32_t index(std::size_t i) const
    {
        return indexBytes == 2 ? static_cast<const std::uint16_t*>(indices)[i]
                               : static_cast<const std::uint32_t*>(indices)[i];
    }
};

/// A mesh as the core sees it: views on memory that the caller owns and keeps unchanged while they are in use.
struct MeshView {
    std::vector<VertexBufferView> vertexBuffers;
    std::vector<SubMeshView> subMeshes;
};

/// How many poses a mesh has besides rest.
inline std::size_t poseCount(const MeshView& mesh)
{
    std::size_t count = 0;
    for (const VertexBufferView& buffer : mesh.vertexBuffers)
        count = std::max(count, buffer.poses.size());
    return count;
}

/// A buffer's positions in a pose, which may be one that it does not have.
inline const FloatStream& positionsInPose(const VertexBufferView& buffer, std::size_t pose)
{
    return pose < buffer.poses.size() && buffer.poses[pose] ? buffer.poses[pose] : buffer.positions;
}

/// The mesh as it stands in a pose, as if that were rest: it has no poses itself. Shares the memory that `mesh` views.
inline MeshView inPose(const MeshView& mesh, std::size_t pose)
{
    MeshView posed = mesh;
    for (VertexBufferView& buffer : posed.vertexBuffers) {
        buffer.positions = positionsInPose(buffer, pose);
        buffer.poses.clear();
    }
    return posed;
}

} // namespace lodsmith
