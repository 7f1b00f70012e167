#include "MeshHash.h"

#define XXH_INLINE_ALL
#include <xxhash.h>

#include <array>
#include <memory>

namespace lodsmith::benchmarks {

namespace {

class Hasher {
public:
    Hasher() { XXH3_128bits_reset(mState.get()); }

    void number(std::uint64_t value) { XXH3_128bits_update(mState.get(), &value, sizeof value); }

    /// Whether there is such a stream, then `components` floats a vertex.
    void stream(const FloatStream& stream, std::size_t count, int components)
    {
        number(stream ? std::uint64_t(components) : 0);
        if (!stream)
            return;
        std::array<float, 4> values{};
        for (std::size_t i = 0; i < count; ++i) {
            stream.read(i, components, values.data());
            XXH3_128bits_update(mState.get(), values.data(), std::size_t(components) * sizeof(float));
        }
    }

    void bones(const BoneInfluences* bones, std::size_t count)
    {
        number(bones != nullptr);
        for (std::size_t i = 0; bones && i < count; ++i) {
            XXH3_128bits_update(mState.get(), bones[i].bone, sizeof bones[i].bone);
            XXH3_128bits_update(mState.get(), bones[i].weight, sizeof bones[i].weight);
        }
    }

    std::string digits() const
    {
        XXH128_canonical_t canonical;
        XXH128_canonicalFromHash(&canonical, XXH3_128bits_digest(mState.get()));
        std::string digits;
        for (const unsigned char byte : canonical.digest)
            digits += {"0123456789abcdef"[byte >> 4], "0123456789abcdef"[byte & 15]};
        return digits;
    }

private:
    struct Free {
        void operator()(XXH3_state_t* state) const { XXH3_freeState(state); }
    };
    std::unique_ptr<XXH3_state_t, Free> mState{XXH3_createState()};
};

void addVertices(Hasher& hasher, const VertexBufferView& buffer)
{
    const std::size_t count = buffer.vertexCount;
    hasher.number(count);
    hasher.stream(buffer.positions, count, 3);
    hasher.stream(buffer.normals, count, 3);
    hasher.number(buffer.uvSets.size());
    for (const UvStream& uv : buffer.uvSets)
        hasher.stream(uv.stream, count, uv.components);
    hasher.stream(buffer.colours, count, 4);
    hasher.bones(buffer.bones, count);
    hasher.number(buffer.offsets.size());
    for (const FloatStream& offsets : buffer.offsets)
        hasher.stream(offsets, count, 3);
    hasher.number(buffer.poses.size());
    for (const FloatStream& pose : buffer.poses)
        hasher.stream(pose, count, 3);
    hasher.stream(buffer.importance, count, 1);
}

} // namespace

std::string meshHash(const MeshView& mesh)
{
    Hasher hasher;
    hasher.number(mesh.vertexBuffers.size());
    for (const VertexBufferView& buffer : mesh.vertexBuffers)
        addVertices(hasher, buffer);
    hasher.number(mesh.subMeshes.size());
    for (const SubMeshView& subMesh : mesh.subMeshes) {
        hasher.number(subMesh.vertexBuffer);
        hasher.number(subMesh.indexCount);
        for (std::uint32_t i = 0; i < subMesh.indexCount; ++i)
            hasher.number(subMesh.index(i));
    }
    return hasher.digits();
}

} // namespace lodsmith::benchmarks
