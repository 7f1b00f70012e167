#include <lodsmith/cache/CacheKey.h>

#include "support/MeshBuilders.h"
#include "support/MeshFromBytes.h"

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <cstring>
#include <functional>
#include <map>
#include <stdexcept>

namespace lodsmith {

namespace {

using test::SimplifyCase;
using test::TestMesh;

CacheKey keyOf(const SimplifyCase& input)
{
    return cacheKey(input.mesh.view(), input.targets, input.options);
}

/// Two buffers and two submeshes; the first buffer has every stream there is.
SimplifyCase fullCase()
{
    SimplifyCase input;
    input.mesh = joined(test::makeUvSphere(8, 5), test::makeTetrahedron());
    test::TestBuffer& buffer = input.mesh.buffers[0];
    const std::size_t count = buffer.vertexCount();
    buffer.uvSets.emplace_back(2 * count, 0.25f);
    buffer.colours.assign(4 * count, 0.5f);
    buffer.bones.assign(count, {{1, 2, 0, 0}, {0.75f, 0.25f, 0.0f, 0.0f}});
    buffer.offsets.assign(2, std::vector<float>(3 * count, 0.125f));
    buffer.poses.assign(2, std::vector<float>(3 * count, 0.375f));
    buffer.importance.assign(count, 0.5f);
    input.targets = {{LevelTarget::Kind::Proportional, 0.5}, {LevelTarget::Kind::Triangles, 20}};
    return input;
}

/// A mesh with its numbers laid out otherwise: all streams of a vertex side by side at odd addresses, and short indices.
class Interleaved {
public:
    explicit Interleaved(const TestMesh& mesh) : mView(mesh.view())
    {
        mBytes.resize(mView.vertexBuffers.size());
        mIndices.resize(mView.subMeshes.size());
        for (std::size_t i = 0; i < mBytes.size(); ++i)
            relayVertices(mView.vertexBuffers[i], mBytes[i]);
        for (std::size_t i = 0; i < mIndices.size(); ++i)
            relayIndices(mView.subMeshes[i], mIndices[i]);
    }

    const MeshView& view() const { return mView; }

private:
    using Streams = std::vector<std::pair<FloatStream*, int>>;

    static Streams streamsOf(VertexBufferView& buffer)
    {
        Streams streams = {{&buffer.positions, 3}, {&buffer.normals, 3}, {&buffer.colours, 4}, {&buffer.importance, 1}};
        for (UvStream& uv : buffer.uvSets)
            streams.emplace_back(&uv.stream, uv.components);
        for (FloatStream& offsets : buffer.offsets)
            streams.emplace_back(&offsets, 3);
        for (FloatStream& pose : buffer.poses)
            streams.emplace_back(&pose, 3);
        return streams;
    }

    static void relayVertices(VertexBufferView& buffer, std::vector<char>& bytes)
    {
        constexpr std::size_t kGap = 3;
        std::size_t stride = kGap;
        for (const auto& [stream, components] : streamsOf(buffer))
            stride += *stream ? sizeof(float) * static_cast<std::size_t>(components) : 0;
        bytes.assign(stride * buffer.vertexCount + 1, '\x5a');
        std::size_t offset = 1;
        for (const auto& [stream, components] : streamsOf(buffer)) {
            if (!*stream)
                continue;
            for (std::uint32_t i = 0; i < buffer.vertexCount; ++i) {
                float tuple[4];
                stream->read(i, components, tuple);
                std::memcpy(&bytes[offset + i * stride], tuple, sizeof(float) * static_cast<std::size_t>(components));
            }
            *stream = {bytes.data() + offset, stride};
            offset += sizeof(float) * static_cast<std::size_t>(components);
        }
    }

    static void relayIndices(SubMeshView& subMesh, std::vector<std::uint16_t>& indices)
    {
        for (std::uint32_t i = 0; i < subMesh.indexCount; ++i)
            if (subMesh.index(i) > 0xffff)
                return;
        for (std::uint32_t i = 0; i < subMesh.indexCount; ++i)
            indices.push_back(static_cast<std::uint16_t>(subMesh.index(i)));
        subMesh.indices = indices.data();
        subMesh.indexBytes = 2;
    }

    MeshView mView;
    std::vector<std::vector<char>> mBytes;
    std::vector<std::vector<std::uint16_t>> mIndices;
};

/// Everything that decides a result, each changed by as little as can be.
std::map<std::string, std::function<void(SimplifyCase&)>> changes()
{
    using Case = SimplifyCase;
    return {
        {"nothing", [](Case&) {}},
        {"last position", [](Case& c) { c.mesh.buffers[0].positions.back() += 0.001f; }},
        {"first position", [](Case& c) { c.mesh.buffers[0].positions.front() += 0.001f; }},
        {"second buffer", [](Case& c) { c.mesh.buffers[1].positions.back() += 0.001f; }},
        {"normal", [](Case& c) { c.mesh.buffers[0].normals.back() += 0.001f; }},
        {"no normals", [](Case& c) { c.mesh.buffers[0].normals.clear(); }},
        {"first uv set", [](Case& c) { c.mesh.buffers[0].uvSets[0].back() += 0.001f; }},
        {"second uv set", [](Case& c) { c.mesh.buffers[0].uvSets[1].back() += 0.001f; }},
        {"order of uv sets", [](Case& c) { std::swap(c.mesh.buffers[0].uvSets[0], c.mesh.buffers[0].uvSets[1]); }},
        {"one uv set", [](Case& c) { c.mesh.buffers[0].uvSets.pop_back(); }},
        {"colour", [](Case& c) { c.mesh.buffers[0].colours.back() += 0.001f; }},
        {"no colours", [](Case& c) { c.mesh.buffers[0].colours.clear(); }},
        {"bone", [](Case& c) { c.mesh.buffers[0].bones.back().bone[0] = 7; }},
        {"bone weight", [](Case& c) { c.mesh.buffers[0].bones.back().weight[1] = 0.125f; }},
        {"no bones", [](Case& c) { c.mesh.buffers[0].bones.clear(); }},
        {"position in a pose", [](Case& c) { c.mesh.buffers[0].poses[1].back() += 0.001f; }},
        {"one posed stream", [](Case& c) { c.mesh.buffers[0].poses.pop_back(); }},
        {"pose", [](Case& c) { c.mesh.buffers[0].offsets[1].back() += 0.001f; }},
        {"one pose", [](Case& c) { c.mesh.buffers[0].offsets.pop_back(); }},
        {"three poses", [](Case& c) { c.mesh.buffers[0].offsets.push_back(c.mesh.buffers[0].offsets[0]); }},
        {"importance", [](Case& c) { c.mesh.buffers[0].importance.back() = 1.0f; }},
        {"no importance", [](Case& c) { c.mesh.buffers[0].importance.clear(); }},
        {"index", [](Case& c) { c.mesh.subMeshes[0].indices.back() = 0; }},
        {"winding", [](Case& c) { std::swap(c.mesh.subMeshes[1].indices[0], c.mesh.subMeshes[1].indices[1]); }},
        {"a triangle less", [](Case& c) { c.mesh.subMeshes[1].indices.resize(9); }},
        {"order of submeshes", [](Case& c) { std::swap(c.mesh.subMeshes[0], c.mesh.subMeshes[1]); }},
        {"another buffer", [](Case& c) { c.mesh.subMeshes[1].vertexBuffer = 0; }},
        {"an empty submesh", [](Case& c) { c.mesh.subMeshes.emplace_back(); }},
        {"an empty buffer", [](Case& c) { c.mesh.buffers.emplace_back(); }},
        {"a vertex more", [](Case& c) { c.mesh.buffers[1].addPosition(9, 9, 9); }},
        {"kind of target", [](Case& c) { c.targets[1].kind = LevelTarget::Kind::Constant; }},
        {"amount", [](Case& c) { c.targets[0].amount = 0.5000001; }},
        {"a level less", [](Case& c) { c.targets.pop_back(); }},
        {"no levels", [](Case& c) { c.targets.clear(); }},
        {"order of levels", [](Case& c) { std::swap(c.targets[0], c.targets[1]); }},
        {"metric", [](Case& c) { c.options.metric = Metric::Curvature; }},
        {"normal weight", [](Case& c) { c.options.weights.normal *= 2; }},
        {"uv weight", [](Case& c) { c.options.weights.uv *= 2; }},
        {"colour weight", [](Case& c) { c.options.weights.colour *= 2; }},
        {"bone weight of options", [](Case& c) { c.options.weights.bone *= 2; }},
        {"locked borders", [](Case& c) { c.options.lockBorders = true; }},
        {"locked seams", [](Case& c) { c.options.lockSeams = true; }},
    };
}

MeshView viewOf(const std::vector<float>& numbers, std::uint32_t vertices)
{
    MeshView view;
    view.vertexBuffers.resize(1);
    view.vertexBuffers[0].vertexCount = vertices;
    view.vertexBuffers[0].positions = {numbers.data(), 3 * sizeof(float)};
    return view;
}

/// Keys of meshes whose numbers, one behind the other, are the same.
void expectAllDifferent(const std::vector<CacheKey>& keys)
{
    std::map<std::string, std::size_t> seen;
    for (std::size_t i = 0; i < keys.size(); ++i)
        EXPECT_TRUE(seen.emplace(toHex(keys[i]), i).second) << i << " and " << seen[toHex(keys[i])];
}

} // namespace

TEST(CacheKey, everythingThatDecidesAResultChangesIt)
{
    std::map<std::string, std::string> seen;
    for (const auto& [name, change] : changes()) {
        SimplifyCase input = fullCase();
        change(input);
        const auto [other, isNew] = seen.emplace(toHex(keyOf(input)), name);
        EXPECT_TRUE(isNew) << name << " and " << other->second;
    }
}

TEST(CacheKey, addressesAndLayoutsDoNotChangeIt)
{
    const SimplifyCase input = fullCase(), copy = input;
    EXPECT_EQ(keyOf(copy), keyOf(input));
    const Interleaved interleaved(input.mesh);
    EXPECT_EQ(interleaved.view().subMeshes[0].indexBytes, 2);
    EXPECT_EQ(cacheKey(interleaved.view(), input.targets, input.options), keyOf(input));
}

TEST(CacheKey, layoutsOfMeshesOfManyBlocksDoNotChangeIt)
{
    const TestMesh mesh = test::makeUvSphere(200, 100);
    const Interleaved interleaved(mesh);
    EXPECT_EQ(interleaved.view().subMeshes[0].indexBytes, 2);
    EXPECT_EQ(cacheKey(interleaved.view(), {}), cacheKey(mesh.view(), {}));
}

RC_GTEST_PROP(CacheKeyProperty, LayoutDoesNotChangeItWhateverTheMesh, (const std::vector<std::uint8_t>& bytes))
{
    test::ByteSource source(bytes.data(), bytes.size());
    const SimplifyCase input = test::caseFromBytes(source, test::Trust::Garbage);
    const Interleaved interleaved(input.mesh);
    RC_ASSERT(cacheKey(interleaved.view(), input.targets, input.options) == keyOf(input));
}

TEST(CacheKey, whereAListEndsIsPartOfIt)
{
    const std::vector<float> numbers(36, 0.0f);
    const float* data = numbers.data();
    const MeshView all = viewOf(numbers, 2);
    std::vector<CacheKey> keys = {cacheKey(all, {}), cacheKey(viewOf(numbers, 4), {})};
    // The same numbers behind the positions, as streams of other names.
    const auto add = [&](const std::function<void(VertexBufferView&)>& change) {
        MeshView view = all;
        change(view.vertexBuffers[0]);
        keys.push_back(cacheKey(view, {}));
    };
    add([=](VertexBufferView& buffer) { buffer.normals = {data, 12}; });
    add([=](VertexBufferView& buffer) { buffer.offsets = {{data, 12}}; });
    add([=](VertexBufferView& buffer) { buffer.poses = {{data, 12}}; });
    add([=](VertexBufferView& buffer) { buffer.uvSets = {{{data, 12}, 3}}; });
    add([=](VertexBufferView& buffer) { buffer.uvSets = {{{data, 8}, 2}, {{data, 4}, 1}}; });
    add([=](VertexBufferView& buffer) { buffer.uvSets = {{{data, 4}, 1}, {{data, 8}, 2}}; });
    add([=](VertexBufferView& buffer) { buffer.uvSets = {{{}, 2}}; });
    add([=](VertexBufferView& buffer) { buffer.colours = {data, 16}; });
    add([=](VertexBufferView& buffer) { buffer.importance = {data, 4}; });
    expectAllDifferent(keys);
}

TEST(CacheKey, whichSubMeshATriangleIsInIsPartOfIt)
{
    const std::vector<float> numbers(36, 0.0f);
    const std::vector<std::uint32_t> indices(9, 0);
    std::vector<CacheKey> keys;
    for (const std::vector<std::uint32_t>& counts :
         std::vector<std::vector<std::uint32_t>>{{9}, {9, 0}, {0, 9}, {6, 3}, {3, 6}, {3, 3, 3}, {}}) {
        MeshView view = viewOf(numbers, 4);
        for (const std::uint32_t count : counts)
            view.subMeshes.push_back({0, indices.data(), count, 4});
        keys.push_back(cacheKey(view, {}));
    }
    expectAllDifferent(keys);
}

TEST(CacheKey, whatIsDoneAfterwardsIsPartOfIt)
{
    const SimplifyCase input = fullCase();
    const MeshView view = input.mesh.view();
    expectAllDifferent({cacheKey(view, input.targets), cacheKey(view, input.targets, {}, "order"),
                        cacheKey(view, input.targets, {}, "other")});
    EXPECT_EQ(cacheKey(view, input.targets, {}, ""), cacheKey(view, input.targets));
}

TEST(CacheKey, isWrittenInHexadecimal)
{
    CacheKey key;
    EXPECT_EQ(toHex(key), std::string(32, '0'));
    key.bytes = {0x01, 0x23, 0x45, 0x67, 0x89, 0xab, 0xcd, 0xef, 0, 0, 0, 0, 0, 0, 0, 0xff};
    EXPECT_EQ(toHex(key), "0123456789abcdef00000000000000ff");
    EXPECT_NE(key, CacheKey());
}

TEST(CacheKey, malformedViewsAreMisuse)
{
    const AssertHandler before =
        setAssertHandler([](const char*, const char* message, const char*, int) { throw std::logic_error(message); });
    const std::vector<std::uint32_t> indices(3, 0);
    MeshView view = viewOf({}, 0);
    view.subMeshes.push_back({1, indices.data(), 3, 4});
    EXPECT_THROW(cacheKey(view, {}), std::logic_error);
    view.subMeshes[0] = {0, indices.data(), 3, 1};
    EXPECT_THROW(cacheKey(view, {}), std::logic_error);
    view.subMeshes[0] = {0, nullptr, 3, 4};
    EXPECT_THROW(cacheKey(view, {}), std::logic_error);
    view.subMeshes.clear();
    view.vertexBuffers[0].vertexCount = 1;
    view.vertexBuffers[0].positions = {};
    EXPECT_THROW(cacheKey(view, {}), std::logic_error);
    setAssertHandler(before);
}

} // namespace lodsmith
