#include "MeshFromBytes.h"

#include <cmath>
#include <cstring>

namespace lodsmith::test {

namespace {

TestMesh soup(ByteSource& bytes)
{
    TestMesh mesh;
    mesh.buffers.resize(1);
    mesh.subMeshes.resize(1 + bytes.below(3));
    const std::uint32_t vertices = 1 + bytes.below(24);
    for (std::uint32_t vertex = 0; vertex < vertices; ++vertex) {
        const std::uint8_t place = bytes.byte();
        mesh.buffers[0].addPosition(place % 4, place / 4 % 4, place / 16 % 4);
    }
    const std::uint32_t triangles = bytes.below(64);
    for (std::uint32_t i = 0; i < triangles; ++i) {
        TestSubMesh& subMesh = mesh.subMeshes[bytes.below(static_cast<std::uint32_t>(mesh.subMeshes.size()))];
        const std::uint32_t a = bytes.below(vertices), b = bytes.below(vertices);
        subMesh.addTriangle(a, b, bytes.below(vertices));
    }
    return mesh;
}

TestMesh builtMesh(ByteSource& bytes)
{
    const std::uint32_t kind = bytes.below(16);
    const std::uint32_t size = 1 + bytes.below(5);
    switch (kind) {
    case 0: return makeGrid(size, 1 + bytes.below(5));
    case 1: return makeUvSphere(size + 2, 2 + bytes.below(4));
    case 2: return makeIcosphere(size % 3);
    case 3: return makeTorus(size + 2, 3 + bytes.below(4));
    case 4: return makeCylinder(size + 2, 1 + bytes.below(4));
    case 5: return makeCube(size);
    case 6: return makeTwoSidedWall(size);
    case 7: return makeClosedLips(size);
    case 8: return makeSkinnedLips(size);
    case 9: return makeBook(size);
    case 10: return makeIslands(size);
    case 11: return makeLeafCards(size);
    case 12: return makeTwoMaterials(size, bytes.flag());
    case 13: return makeSkinnedTube(size + 2, 1 + bytes.below(4));
    case 14: return makeBentTube(size + 2, 1 + bytes.below(4), {90.0 * bytes.coarse(), 150.0 * bytes.coarse()});
    default: return soup(bytes);
    }
}

void moveVertex(TestMesh& mesh, ByteSource& bytes)
{
    TestBuffer& buffer = mesh.buffers[bytes.below(static_cast<std::uint32_t>(mesh.buffers.size()))];
    if (buffer.positions.empty())
        return;
    float* position = &buffer.positions[3 * bytes.below(buffer.vertexCount())];
    const float* other = &buffer.positions[3 * bytes.below(buffer.vertexCount())];
    if (bytes.flag()) // onto another one, so that positions coincide
        std::memmove(position, other, 3 * sizeof(float));
    else
        for (int i = 0; i < 3; ++i)
            position[i] += bytes.coarse();
}

/// Repeats, turns over, bends or takes away one triangle.
void changeTriangle(TestMesh& mesh, ByteSource& bytes)
{
    TestSubMesh& subMesh = mesh.subMeshes[bytes.below(static_cast<std::uint32_t>(mesh.subMeshes.size()))];
    if (subMesh.indices.empty())
        return;
    const std::size_t first = 3 * (bytes.byte() % (subMesh.indices.size() / 3));
    const std::uint32_t corners[3] = {subMesh.indices[first], subMesh.indices[first + 1], subMesh.indices[first + 2]};
    switch (bytes.below(5)) {
    case 0: subMesh.addTriangle(corners[1], corners[2], corners[0]); break;
    case 1: subMesh.addTriangle(corners[0], corners[2], corners[1]); break;
    case 2: std::swap(subMesh.indices[first], subMesh.indices[first + 1]); break;
    case 3: subMesh.indices[first] = bytes.below(mesh.buffers[subMesh.vertexBuffer].vertexCount()); break;
    default:
        subMesh.indices.erase(subMesh.indices.begin() + static_cast<std::ptrdiff_t>(first),
                              subMesh.indices.begin() + static_cast<std::ptrdiff_t>(first) + 3);
    }
}

std::vector<float> randomStream(ByteSource& bytes, std::size_t count)
{
    std::vector<float> values(count);
    for (float& value : values)
        value = static_cast<float>(bytes.below(4)) / 3.0f;
    return values;
}

/// Everything drawn out or together, and some vertices elsewhere.
std::vector<float> posed(const TestBuffer& buffer, ByteSource& bytes)
{
    std::vector<float> positions = buffer.positions;
    const float stretch = bytes.coarse() + 1.0f;
    for (std::size_t i = 0; i < positions.size(); i += 3)
        positions[i] *= stretch;
    for (std::uint32_t moved = bytes.below(32); moved > 0 && !positions.empty(); --moved)
        positions[bytes.byte() % positions.size()] += bytes.coarse();
    return positions;
}

void addAttributes(TestBuffer& buffer, ByteSource& bytes)
{
    const std::uint8_t which = bytes.byte();
    const std::size_t count = buffer.vertexCount();
    if (which & 1)
        buffer.normals = randomStream(bytes, 3 * count);
    if (which & 2)
        buffer.uvSets.push_back(randomStream(bytes, 2 * count));
    if (which & 4)
        buffer.colours = randomStream(bytes, 4 * count);
    if (which & 8)
        buffer.offsets.push_back(randomStream(bytes, 3 * count));
    if (which & 16)
        buffer.importance = randomStream(bytes, count);
    if (which & 32) {
        buffer.bones.resize(count);
        for (BoneInfluences& influences : buffer.bones) {
            influences.bone[0] = static_cast<std::uint16_t>(bytes.below(3));
            influences.weight[0] = 1.0f;
        }
    }
    for (std::uint8_t poses = which >> 6; poses > 0; --poses)
        buffer.poses.push_back(posed(buffer, bytes));
}

void scaleAll(TestMesh& mesh, ByteSource& bytes)
{
    constexpr double kScales[] = {1.0, 1e-30, 1e-10, 1e10, 1e16, 0.0};
    if (bytes.below(8) == 7)
        mesh = scaled(std::move(mesh), kScales[bytes.below(6)]);
}

LevelTarget validTarget(ByteSource& bytes)
{
    const double share = bytes.byte() / 255.0;
    switch (bytes.below(5)) {
    case 0: return {LevelTarget::Kind::Proportional, share};
    case 1: return {LevelTarget::Kind::Constant, share < 0.9 ? std::floor(share * 100) : 1e9};
    case 2: return {LevelTarget::Kind::Triangles, std::floor(share * 100)};
    case 3: return {LevelTarget::Kind::Deviation, share};
    default: return {LevelTarget::Kind::CollapseCost, share};
    }
}

void spoilMesh(TestMesh& mesh, ByteSource& bytes)
{
    TestBuffer& buffer = mesh.buffers[0];
    std::vector<float>* const streams[] = {&buffer.positions, &buffer.normals, &buffer.colours, &buffer.importance};
    std::vector<float>& stream = *streams[bytes.below(4)];
    if (!stream.empty())
        stream[bytes.byte() % stream.size()] = bytes.anything();
    std::vector<std::uint32_t>& indices = mesh.subMeshes[0].indices;
    if (bytes.below(4) == 3 && !indices.empty())
        indices[bytes.byte() % indices.size()] = buffer.vertexCount() + bytes.byte();
}

void spoilSettings(SimplifyCase& result, ByteSource& bytes)
{
    if (bytes.flag() && !result.targets.empty())
        result.targets.front().amount = bytes.anything();
    if (bytes.flag())
        result.options.weights.normal = bytes.anything();
    if (bytes.flag())
        result.options.weights.uv = bytes.anything();
}

} // namespace

float ByteSource::anything()
{
    std::uint32_t bits = 0;
    for (int shift = 0; shift < 32; shift += 8)
        bits |= std::uint32_t{byte()} << shift;
    float value;
    std::memcpy(&value, &bits, sizeof value);
    return value;
}

SimplifyCase caseFromBytes(ByteSource& bytes, Trust trust)
{
    SimplifyCase result;
    const std::uint8_t settings = bytes.byte();
    result.options.metric = settings & 1 ? Metric::Curvature : Metric::Quadric;
    result.options.lockBorders = (settings & 6) == 6;
    result.options.lockSeams = (settings & 24) == 24;
    if (settings & 32)
        result.options.weights = {0.0f, 0.0f, 0.0f, 0.0f};
    for (std::uint32_t levels = bytes.below(4); levels-- > 0;)
        result.targets.push_back(validTarget(bytes));

    result.mesh = builtMesh(bytes);
    if (settings & 64)
        result.mesh = joined(result.mesh, builtMesh(bytes));
    if (settings & 128)
        result.mesh = flatShaded(result.mesh);
    for (TestBuffer& buffer : result.mesh.buffers) {
        if (bytes.flag())
            addAttributes(buffer, bytes);
    }
    scaleAll(result.mesh, bytes);
    for (std::uint32_t changes = bytes.below(24); changes-- > 0 && !bytes.empty();) {
        if (bytes.flag())
            moveVertex(result.mesh, bytes);
        else
            changeTriangle(result.mesh, bytes);
    }
    if (trust == Trust::Garbage && bytes.flag())
        spoilMesh(result.mesh, bytes);
    if (trust == Trust::Garbage && bytes.flag())
        spoilSettings(result, bytes);
    return result;
}

} // namespace lodsmith::test
