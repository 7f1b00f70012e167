#include "support/CheckedSimplify.h"
#include "support/MeshBuilders.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

namespace lodsmith {

namespace {

using namespace test;

/// Counts are those of the input; no level is asked for.
LodChain counted(const TestMesh& mesh)
{
    return simplifyChecked(mesh.view(), {});
}

/// Two triangles on a common edge, each with its own three vertices.
TestMesh makeUnweldedQuad()
{
    TestMesh mesh;
    mesh.buffers.resize(1);
    mesh.subMeshes.resize(1);
    mesh.buffers[0].positions = {0, 0, 0, 1, 0, 0, 1, 1, 0, /**/ 0, 0, 0, 1, 1, 0, 0, 1, 0};
    mesh.subMeshes[0].indices = {0, 1, 2, 3, 4, 5};
    return mesh;
}

TEST(Weld, EqualPositionsAreOneVertex)
{
    const LodChain chain = counted(makeUnweldedQuad());
    EXPECT_EQ(chain.vertices, 4u);
    EXPECT_EQ(chain.bufferVertices, 6u);
    EXPECT_EQ(chain.triangles, 2u);
}

TEST(Weld, NegativeZeroIsZero)
{
    TestMesh mesh = makeUnweldedQuad();
    mesh.buffers[0].positions[9] = -0.0f;
    mesh.buffers[0].positions[10] = -0.0f;
    mesh.buffers[0].positions[14] = -0.0f;
    EXPECT_EQ(counted(mesh).vertices, 4u);
}

TEST(Weld, PositionsOneStepApartAreTwoVertices)
{
    TestMesh mesh = makeUnweldedQuad();
    mesh.buffers[0].positions[12] = std::nextafter(1.0f, 2.0f);
    EXPECT_EQ(counted(mesh).vertices, 5u);
}

TEST(Weld, CrossesBuffersAndSubMeshes)
{
    const LodChain chain = counted(makeTwoMaterials(4, false));
    EXPECT_EQ(chain.vertices, 9u * 5u);
    EXPECT_EQ(chain.bufferVertices, 2u * 9u * 5u);
}

TEST(Weld, UnreferencedVerticesDoNotCount)
{
    TestMesh mesh = makeGrid(2, 2);
    mesh.buffers[0].addPosition(5, 5, 5);
    mesh.buffers[0].addNormal(0, 0, 1);
    mesh.buffers[0].addUv(0, 0);
    const LodChain chain = counted(mesh);
    EXPECT_EQ(chain.vertices, 9u);
    EXPECT_EQ(chain.bufferVertices, 10u);
    EXPECT_EQ(chain.cleaned.unreferencedVertices, 1u);
    EXPECT_NEAR(chain.radius, std::sqrt(0.5), 1e-6) << "the unreferenced vertex counts in the radius";
}

TEST(Weld, CoincidentUnreferencedVerticesAreHarmless)
{
    TestMesh mesh = makeGrid(4, 4);
    TestBuffer& buffer = mesh.buffers[0];
    for (int i = 0; i < 20; ++i) {
        buffer.addPosition(buffer.positions[3 * i], buffer.positions[3 * i + 1], buffer.positions[3 * i + 2]);
        buffer.addNormal(0, 0, 1);
        buffer.addUv(0.5, 0.5);
    }
    const LodChain chain = simplifyChecked(mesh.view(), {removedShare(0.5)});
    EXPECT_EQ(chain.vertices, 25u);
    EXPECT_EQ(chain.cleaned.unreferencedVertices, 20u);
}

TEST(Weld, UnusedRestOfAHalfUsedBufferIsNotCounted)
{
    TestMesh mesh = makeTwoMaterials(4, false);
    mesh.subMeshes.pop_back();
    const LodChain chain = counted(mesh);
    EXPECT_EQ(chain.vertices, 5u * 5u);
    EXPECT_EQ(chain.cleaned.unreferencedVertices, 9u * 5u + 4u * 5u);
}

TEST(Weld, EqualAttributesAreNoSeam)
{
    const TestMesh smooth = makeGrid(6, 6);
    TestMesh split;
    split.buffers.resize(1);
    split.subMeshes.resize(1);
    for (const std::uint32_t index : smooth.subMeshes[0].indices) {
        const TestBuffer& from = smooth.buffers[0];
        split.subMeshes[0].indices.push_back(split.buffers[0].addPosition(
            from.positions[3 * index], from.positions[3 * index + 1], from.positions[3 * index + 2]));
        split.buffers[0].addNormal(0, 0, 1);
        split.buffers[0].addUv(from.uvSets[0][2 * index], from.uvSets[0][2 * index + 1]);
    }
    SimplifyOptions options;
    options.lockSeams = true;
    const std::vector<LevelTarget> targets = {removedShare(0.5), removedShare(0.9)};
    const LodChain chain = simplifyChecked(split.view(), targets, options);
    const LodChain expected = simplifyChecked(smooth.view(), targets, options);
    EXPECT_EQ(chain.vertices, 49u);
    for (std::size_t i = 0; i < targets.size(); ++i)
        EXPECT_EQ(chain.levels[i].vertices, expected.levels[i].vertices);
}

TEST(Weld, DegenerateTrianglesAreLeftOutAndCounted)
{
    TestMesh mesh = makeUnweldedQuad();
    mesh.subMeshes[0].addTriangle(0, 3, 1); // two vertices, one position
    mesh.subMeshes[0].addTriangle(2, 2, 2);
    const LodChain chain = simplifyChecked(mesh.view(), {removedVertices(1)});
    EXPECT_EQ(chain.triangles, 4u);
    EXPECT_EQ(chain.cleaned.degenerateTriangles, 2u);
    EXPECT_EQ(chain.levels[0].triangles, 1u);
}

TEST(Weld, RepeatedTrianglesAreLeftOutAndCounted)
{
    TestMesh mesh = makeGrid(3, 3);
    TestSubMesh& subMesh = mesh.subMeshes[0];
    subMesh.addTriangle(subMesh.indices[1], subMesh.indices[2], subMesh.indices[0]);
    subMesh.addTriangle(subMesh.indices[3], subMesh.indices[4], subMesh.indices[5]);
    const LodChain chain = simplifyChecked(mesh.view(), {removedVertices(4)});
    EXPECT_EQ(chain.cleaned.repeatedTriangles, 2u);
}

TEST(Weld, TheOtherWindingAndTheOtherSubMeshAreNoRepetition)
{
    TestMesh mesh = makeGrid(3, 3);
    mesh.subMeshes.push_back(mesh.subMeshes[0]);
    TestSubMesh& first = mesh.subMeshes[0];
    first.addTriangle(first.indices[0], first.indices[2], first.indices[1]);
    const LodChain chain = counted(mesh);
    EXPECT_EQ(chain.cleaned.repeatedTriangles, 0u);
    EXPECT_EQ(chain.triangles, 37u);
}

TEST(Weld, SixteenBitIndicesAreTheSame)
{
    const TestMesh mesh = makeTerrain(12);
    const std::vector<std::uint16_t> narrow(mesh.subMeshes[0].indices.begin(), mesh.subMeshes[0].indices.end());
    MeshView view = mesh.view();
    view.subMeshes[0].indices = narrow.data();
    view.subMeshes[0].indexBytes = 2;
    const LodChain chain = simplifyChecked(view, {removedShare(0.7)});
    const LodChain wide = simplifyChecked(mesh.view(), {removedShare(0.7)});
    EXPECT_EQ(chain.levels[0].indices, wide.levels[0].indices);
}

TEST(Weld, StridesAndAlignmentAreTheCallers)
{
    const TestMesh mesh = makeTerrain(12);
    const TestBuffer& buffer = mesh.buffers[0];
    constexpr std::size_t kStride = 37; // odd on purpose
    std::vector<char> packed(1 + kStride * buffer.vertexCount());
    for (std::size_t i = 0; i < buffer.vertexCount(); ++i) {
        char* vertex = packed.data() + 1 + kStride * i;
        std::memcpy(vertex, &buffer.positions[3 * i], 12);
        std::memcpy(vertex + 12, &buffer.normals[3 * i], 12);
        std::memcpy(vertex + 24, &buffer.uvSets[0][2 * i], 8);
    }
    MeshView view = mesh.view();
    view.vertexBuffers[0].positions = {packed.data() + 1, kStride};
    view.vertexBuffers[0].normals = {packed.data() + 13, kStride};
    view.vertexBuffers[0].uvSets[0].stream = {packed.data() + 25, kStride};
    const LodChain chain = simplifyChecked(view, {removedShare(0.7)});
    EXPECT_EQ(chain.levels[0].indices, simplifyChecked(mesh.view(), {removedShare(0.7)}).levels[0].indices);
}

} // namespace

} // namespace lodsmith
