#include "LeafForms.h"

#include <algorithm>
#include <array>
#include <utility>

namespace lodsmith::generators {

namespace {

/// The vertices of one leaf alone: simplify() takes time for each vertex of a buffer, used or not.
class LeafMesh {
public:
    LeafMesh(const MeshView& mesh, const Leaf& leaf) : mLeaf(leaf)
    {
        for (const LeafTriangle& triangle : leaf.forms[0])
            mVertices.insert(mVertices.end(), triangle.vertex.begin(), triangle.vertex.end());
        std::sort(mVertices.begin(), mVertices.end());
        mVertices.erase(std::unique(mVertices.begin(), mVertices.end()), mVertices.end());
        for (const LeafTriangle& triangle : leaf.forms[0])
            for (const std::uint32_t vertex : triangle.vertex)
                mIndices.push_back(static_cast<std::uint32_t>(
                    std::lower_bound(mVertices.begin(), mVertices.end(), vertex) - mVertices.begin()));
        gather(mesh.vertexBuffers[mesh.subMeshes[leaf.forms[0][0].subMesh].vertexBuffer]);
    }

    MeshView view() const
    {
        return {{mBuffer}, {SubMeshView{0, mIndices.data(), static_cast<std::uint32_t>(mIndices.size()), 4}}};
    }

    /// A level of this mesh in terms of the whole one.
    std::vector<LeafTriangle> form(const std::vector<std::uint32_t>& indices) const
    {
        std::vector<LeafTriangle> triangles(indices.size() / 3);
        for (std::size_t i = 0; i < indices.size(); ++i) {
            LeafTriangle& triangle = triangles[i / 3];
            triangle.subMesh = mLeaf.forms[0][0].subMesh;
            triangle.vertex[i % 3] = mVertices[indices[i]];
            float position[3];
            mBuffer.positions.read(indices[i], 3, position);
            triangle.corner[i % 3] = {position[0], position[1], position[2]};
        }
        return triangles;
    }

private:
    FloatStream gather(const FloatStream& from, int count)
    {
        if (!from)
            return {};
        mStreams.emplace_back(mVertices.size() * static_cast<std::size_t>(count));
        std::vector<float>& to = mStreams.back();
        for (std::size_t i = 0; i < mVertices.size(); ++i)
            from.read(mVertices[i], count, &to[i * static_cast<std::size_t>(count)]);
        return {to.data(), sizeof(float) * static_cast<std::size_t>(count)};
    }

    void gather(const VertexBufferView& from)
    {
        mBuffer.vertexCount = static_cast<std::uint32_t>(mVertices.size());
        mBuffer.positions = gather(from.positions, 3);
        mBuffer.normals = gather(from.normals, 3);
        mBuffer.colours = gather(from.colours, 4);
        for (const UvStream& uvs : from.uvSets)
            mBuffer.uvSets.push_back({gather(uvs.stream, uvs.components), uvs.components});
        for (const FloatStream& offsets : from.offsets)
            mBuffer.offsets.push_back(gather(offsets, 3));
        if (from.bones) {
            for (const std::uint32_t vertex : mVertices)
                mBones.push_back(from.bones[vertex]);
            mBuffer.bones = mBones.data();
        }
    }

    const Leaf& mLeaf;
    std::vector<std::uint32_t> mVertices; // of the whole mesh's buffer
    std::vector<std::uint32_t> mIndices;
    std::vector<std::vector<float>> mStreams;
    std::vector<BoneInfluences> mBones;
    VertexBufferView mBuffer;
};

} // namespace

Result<Done> addForms(const MeshView& mesh, const SimplifyOptions& options, Leaf& leaf)
{
    const std::vector<LeafTriangle>& whole = leaf.forms[0];
    const bool isOfOneSubMesh = std::all_of(
        whole.begin(), whole.end(), [&](const LeafTriangle& triangle) { return triangle.subMesh == whole[0].subMesh; });
    if (!isOfOneSubMesh || whole.size() == 1)
        return Done{};
    std::vector<LevelTarget> targets;
    for (std::size_t count = whole.size(); count > 1;) {
        count = (count + 1) / 2;
        targets.push_back({LevelTarget::Kind::Triangles, static_cast<double>(count)});
    }
    const LeafMesh alone(mesh, leaf);
    Result<LodChain> chain = simplify(alone.view(), targets, options);
    if (!chain) {
        Error error = chain.error();
        error.subMesh = -1;
        error.item = -1;
        return error;
    }
    for (const LodChainLevel& level : chain.value().levels)
        if (!level.skipped && level.triangles > 0)
            leaf.forms.push_back(alone.form(level.indices[0]));
    return Done{};
}

} // namespace lodsmith::generators
