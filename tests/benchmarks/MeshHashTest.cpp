#include "MeshHash.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

namespace lodsmith::benchmarks {

namespace {

/// A square with normals, as arrays that a view can be made of in several ways.
struct Square {
    std::vector<float> positions{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
    std::vector<float> normals{0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1};
    std::vector<std::uint16_t> indices{0, 1, 2, 0, 2, 3};

    MeshView view() const
    {
        MeshView view;
        VertexBufferView& buffer = view.vertexBuffers.emplace_back();
        buffer.vertexCount = 4;
        buffer.positions = {positions.data(), 3 * sizeof(float)};
        buffer.normals = {normals.data(), 3 * sizeof(float)};
        view.subMeshes.push_back({0, indices.data(), std::uint32_t(indices.size()), 2});
        return view;
    }
};

TEST(MeshHash, isThatOfTheNumbersAndNotOfTheirLayout)
{
    const Square square;
    std::vector<float> interleaved;
    for (std::size_t i = 0; i < 4; ++i) {
        interleaved.insert(interleaved.end(), &square.positions[3 * i], &square.positions[3 * i] + 3);
        interleaved.insert(interleaved.end(), &square.normals[3 * i], &square.normals[3 * i] + 3);
    }
    const std::vector<std::uint32_t> wide(square.indices.begin(), square.indices.end());
    MeshView other = square.view();
    other.vertexBuffers[0].positions = {interleaved.data(), 6 * sizeof(float)};
    other.vertexBuffers[0].normals = {interleaved.data() + 3, 6 * sizeof(float)};
    other.subMeshes[0].indices = wide.data();
    other.subMeshes[0].indexBytes = 4;
    EXPECT_EQ(meshHash(other), meshHash(square.view()));
    EXPECT_EQ(meshHash(other).size(), 32U);
}

TEST(MeshHash, changesWithEveryPartOfAMesh)
{
    const Square square;
    std::set<std::string> hashes{meshHash(square.view())};
    Square moved = square;
    moved.positions[4] = 0.5f;
    hashes.insert(meshHash(moved.view()));
    Square turned = square;
    turned.normals[5] = -1.0f;
    hashes.insert(meshHash(turned.view()));
    Square flipped = square;
    flipped.indices = {0, 2, 1, 0, 2, 3};
    hashes.insert(meshHash(flipped.view()));
    MeshView bare = square.view();
    bare.vertexBuffers[0].normals = {};
    hashes.insert(meshHash(bare));
    MeshView split = square.view();
    split.subMeshes[0].indexCount = 3;
    split.subMeshes.push_back({0, square.indices.data() + 3, 3, 2});
    hashes.insert(meshHash(split));
    MeshView important = square.view();
    important.vertexBuffers[0].importance = {square.normals.data(), 3 * sizeof(float)};
    hashes.insert(meshHash(important));
    EXPECT_EQ(hashes.size(), 7U);
}

} // namespace

} // namespace lodsmith::benchmarks
