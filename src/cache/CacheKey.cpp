#include <lodsmith/cache/CacheKey.h>

#include "CacheFormat.h"
#include "Xxhash.h"

#include <lodsmith/core/Assert.h>

#include <algorithm>
#include <cstring>
#include <string_view>

namespace lodsmith {

namespace {

constexpr std::size_t kBlock = 4096; // numbers that are gathered before they are hashed

class KeyHasher {
public:
    KeyHasher() { XXH3_128bits_reset(&mState); }

    void number(std::uint64_t value) { bytes(&value, sizeof value); }
    void real(double value) { bytes(&value, sizeof value); }

    void text(std::string_view value)
    {
        number(value.size());
        bytes(value.data(), value.size());
    }

    /// Where there is a stream, its components stand before it, else 0.
    template <int kComponents>
    void floats(const FloatStream& stream, std::size_t count)
    {
        constexpr std::size_t kTuple = kComponents * sizeof(float);
        number(stream ? kComponents : 0);
        if (!stream)
            return;
        if (stream.stride == kTuple)
            return bytes(stream.data, count * kTuple);
        float gathered[kBlock * kComponents];
        for (std::size_t begin = 0; begin < count; begin += kBlock) {
            const std::size_t end = std::min(count, begin + kBlock);
            for (std::size_t i = begin; i < end; ++i)
                stream.read(i, kComponents, gathered + (i - begin) * kComponents);
            bytes(gathered, (end - begin) * kTuple);
        }
    }

    void bones(const BoneInfluences* influences, std::size_t count)
    {
        static_assert(sizeof(BoneInfluences) == 4 * sizeof(std::uint16_t) + 4 * sizeof(float), "no gaps to be hashed");
        number(influences ? 1 : 0);
        if (influences)
            bytes(influences, count * sizeof(BoneInfluences));
    }

    void indices(const SubMeshView& subMesh)
    {
        number(subMesh.indexCount);
        if (subMesh.indexBytes == 4)
            return bytes(subMesh.indices, subMesh.indexCount * sizeof(std::uint32_t));
        std::uint32_t widened[kBlock];
        for (std::size_t begin = 0; begin < subMesh.indexCount; begin += kBlock) {
            const std::size_t end = std::min<std::size_t>(subMesh.indexCount, begin + kBlock);
            for (std::size_t i = begin; i < end; ++i)
                widened[i - begin] = subMesh.index(i);
            bytes(widened, (end - begin) * sizeof(std::uint32_t));
        }
    }

    CacheKey key() const
    {
        XXH128_canonical_t canonical;
        XXH128_canonicalFromHash(&canonical, XXH3_128bits_digest(&mState));
        CacheKey key;
        static_assert(sizeof canonical.digest == sizeof key.bytes);
        std::memcpy(key.bytes.data(), canonical.digest, sizeof canonical.digest);
        return key;
    }

private:
    void bytes(const void* data, std::size_t size)
    {
        if (size > 0)
            XXH3_128bits_update(&mState, data, size);
    }

    XXH3_state_t mState;
};

void addUv(KeyHasher& hasher, const UvStream& uv, std::size_t count)
{
    switch (uv.components) {
    case 1: return hasher.floats<1>(uv.stream, count);
    case 2: return hasher.floats<2>(uv.stream, count);
    case 3: return hasher.floats<3>(uv.stream, count);
    default: return hasher.floats<4>(uv.stream, count);
    }
}

void addVertices(KeyHasher& hasher, const VertexBufferView& buffer)
{
    const std::size_t count = buffer.vertexCount;
    LODSMITH_ASSERT(count == 0 || buffer.positions, "positions are missing");
    hasher.number(count);
    hasher.floats<3>(buffer.positions, count);
    hasher.floats<3>(buffer.normals, count);
    hasher.number(buffer.uvSets.size());
    for (const UvStream& uv : buffer.uvSets) {
        LODSMITH_ASSERT(uv.components >= 1 && uv.components <= 4, "a texture coordinate has one to four components");
        addUv(hasher, uv, count);
    }
    hasher.floats<4>(buffer.colours, count);
    hasher.bones(buffer.bones, count);
    hasher.number(buffer.offsets.size());
    for (const FloatStream& offsets : buffer.offsets)
        hasher.floats<3>(offsets, count);
    hasher.number(buffer.poses.size());
    for (const FloatStream& pose : buffer.poses)
        hasher.floats<3>(pose, count);
    hasher.floats<1>(buffer.importance, count);
}

void addMesh(KeyHasher& hasher, const MeshView& mesh)
{
    hasher.number(mesh.vertexBuffers.size());
    for (const VertexBufferView& buffer : mesh.vertexBuffers)
        addVertices(hasher, buffer);
    hasher.number(mesh.subMeshes.size());
    for (const SubMeshView& subMesh : mesh.subMeshes) {
        LODSMITH_ASSERT(subMesh.vertexBuffer < mesh.vertexBuffers.size(),
                        "a submesh names a vertex buffer that is not there");
        LODSMITH_ASSERT(subMesh.indexBytes == 2 || subMesh.indexBytes == 4, "indices have two or four bytes");
        LODSMITH_ASSERT(subMesh.indexCount == 0 || subMesh.indices, "indices are missing");
        hasher.number(subMesh.vertexBuffer);
        hasher.indices(subMesh);
    }
}

void addSettings(KeyHasher& hasher, const std::vector<LevelTarget>& targets, const SimplifyOptions& options)
{
    hasher.number(targets.size());
    for (const LevelTarget& target : targets) {
        hasher.number(static_cast<std::uint64_t>(target.kind));
        hasher.real(target.amount);
    }
    hasher.number(static_cast<std::uint64_t>(options.metric));
    for (const float weight :
         {options.weights.normal, options.weights.uv, options.weights.colour, options.weights.bone})
        hasher.real(weight);
    hasher.number(options.lockBorders ? 1 : 0);
    hasher.number(options.lockSeams ? 1 : 0);
}

} // namespace

std::string toHex(const CacheKey& key)
{
    constexpr char kDigits[] = "0123456789abcdef";
    std::string text;
    for (const std::uint8_t byte : key.bytes) {
        text += kDigits[byte >> 4];
        text += kDigits[byte & 15];
    }
    return text;
}

CacheKey cacheKey(const MeshView& mesh, const std::vector<LevelTarget>& targets, const SimplifyOptions& options,
                  std::string_view finish)
{
    KeyHasher hasher;
    hasher.text(LODSMITH_VERSION);
    hasher.number(kCacheFormat);
    addSettings(hasher, targets, options);
    hasher.text(finish);
    addMesh(hasher, mesh);
    return hasher.key();
}

} // namespace lodsmith
