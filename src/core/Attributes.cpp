#include "Attributes.h"

#include <algorithm>
#include <cmath>

namespace lodsmith {

namespace {

constexpr int kProjected = 4; // dimensions that bone weights, and pose offsets, are projected to

/// A pseudo-random sign for entry (row, column) of a projection matrix; the same on every machine.
float signAt(std::uint32_t row, std::uint32_t column)
{
    std::uint32_t h = row * 0x9E3779B1u + column * 0x85EBCA77u + 0x27D4EB2Fu;
    h = (h ^ (h >> 15)) * 0x2C1B3C6Du;
    h = (h ^ (h >> 12)) * 0x297A2D39u;
    return (h ^ (h >> 15)) & 1u ? 1.0f : -1.0f;
}

/// Where one buffer's wedges are, and what to read of them.
struct Source {
    const VertexBufferView* buffer;
    std::uint32_t index;
};

class AttributeBuilder {
public:
    AttributeBuilder(CollapseMesh& mesh, const MeshView& view, const AttributeWeights& weights)
        : mMesh(mesh), mView(view), mWeights(weights)
    {
    }

    void build()
    {
        planChannels();
        if (mChannels == 0)
            return;
        const std::size_t wedges = mMesh.nextWedge.size();
        mMesh.attributes.resize(wedges * mChannels);
        for (std::uint32_t wedge = 0; wedge < wedges; ++wedge)
            readRow(wedge, mMesh.attributes.data() + wedge * mChannels);
        keepChannels(varyingChannels(), wedges);
    }

private:
    Source sourceOf(std::uint32_t wedge) const
    {
        return {&mView.vertexBuffers[mView.subMeshes[mMesh.subMeshOfWedge(wedge)].vertexBuffer],
                mMesh.wedgeSource[wedge]};
    }

    void planChannels()
    {
        std::size_t uvSets = 0;
        for (const VertexBufferView& buffer : mView.vertexBuffers) {
            uvSets = std::max(uvSets, buffer.uvSets.size());
            mPoses = std::max(mPoses, buffer.offsets.size());
            mHasNormals |= static_cast<bool>(buffer.normals) && mWeights.normal > 0.0f;
            mHasColours |= static_cast<bool>(buffer.colours) && mWeights.colour > 0.0f;
            mHasBones |= buffer.bones != nullptr && mWeights.bone > 0.0f;
        }
        if (mWeights.uv > 0.0f)
            for (std::size_t set = 0; set < uvSets; ++set)
                mUvScales.push_back(uvScale(set));
        const double radius = mMesh.summary.radius * mMesh.scale;
        mNormalScale = static_cast<float>(mWeights.normal * radius);
        mColourScale = static_cast<float>(mWeights.colour * radius);
        mBoneScale = static_cast<float>(mWeights.bone * radius / std::sqrt(static_cast<double>(kProjected)));
        mChannels = 2 * mUvScales.size() + (mHasNormals ? 3 : 0) + (mHasColours ? 4 : 0) + (mHasBones ? kProjected : 0)
                    + std::min<std::size_t>(3 * mPoses, kProjected);
    }

    /// Length that one unit of a texture coordinate set stands for: from the mesh's mean texel density.
    float uvScale(std::size_t set) const
    {
        double surface = 0.0, texture = 0.0;
        for (const CollapseMesh::Face& face : mMesh.faces) {
            float uv[3][2];
            for (int corner = 0; corner < 3; ++corner)
                readUv(sourceOf(face.wedge[corner]), set, uv[corner]);
            const double doubled = (uv[1][0] - uv[0][0]) * double{uv[2][1] - uv[0][1]}
                                   - (uv[1][1] - uv[0][1]) * double{uv[2][0] - uv[0][0]};
            texture += 0.5 * std::abs(doubled);
            surface += face.area;
        }
        return texture > 0.0 ? static_cast<float>(mWeights.uv * std::sqrt(surface / texture)) : 0.0f;
    }

    static void readUv(const Source& source, std::size_t set, float* out)
    {
        out[0] = out[1] = 0.0f;
        if (set < source.buffer->uvSets.size() && source.buffer->uvSets[set].stream)
            source.buffer->uvSets[set].stream.read(source.index, std::min(2, source.buffer->uvSets[set].components),
                                                   out);
    }

    /// All channels of a wedge, in the order uv sets, normal, colour, bones, offsets.
    void readRow(std::uint32_t wedge, float* out) const
    {
        const Source source = sourceOf(wedge);
        for (std::size_t set = 0; set < mUvScales.size(); ++set, out += 2) {
            readUv(source, set, out);
            out[0] *= mUvScales[set];
            out[1] *= mUvScales[set];
        }
        if (mHasNormals) {
            readNormal(source, out);
            out += 3;
        }
        if (mHasColours) {
            readColour(source, out);
            out += 4;
        }
        if (mHasBones) {
            readBones(source, out);
            out += kProjected;
        }
        readOffsets(source, out);
    }

    void readNormal(const Source& source, float* out) const
    {
        std::fill(out, out + 3, 0.0f);
        if (!source.buffer->normals)
            return;
        source.buffer->normals.read(source.index, 3, out);
        const double size = std::sqrt(double{out[0]} * out[0] + double{out[1]} * out[1] + double{out[2]} * out[2]);
        for (int i = 0; i < 3; ++i)
            out[i] = size > 0.0 ? static_cast<float>(out[i] / size * mNormalScale) : 0.0f;
    }

    void readColour(const Source& source, float* out) const
    {
        std::fill(out, out + 4, 0.0f);
        if (source.buffer->colours)
            source.buffer->colours.read(source.index, 4, out);
        for (int i = 0; i < 4; ++i)
            out[i] *= mColourScale;
    }

    void readBones(const Source& source, float* out) const
    {
        std::fill(out, out + kProjected, 0.0f);
        if (!source.buffer->bones)
            return;
        const BoneInfluences& bones = source.buffer->bones[source.index];
        for (int entry = 0; entry < 4; ++entry)
            for (int i = 0; i < kProjected; ++i)
                out[i] += signAt(bones.bone[entry], static_cast<std::uint32_t>(i)) * bones.weight[entry] * mBoneScale;
    }

    void readOffsets(const Source& source, float* out) const
    {
        std::fill(out, out + std::min<std::size_t>(3 * mPoses, kProjected), 0.0f);
        const float single = static_cast<float>(mMesh.scale);
        const float projected = static_cast<float>(mMesh.scale / std::sqrt(static_cast<double>(kProjected)));
        for (std::size_t pose = 0; pose < source.buffer->offsets.size(); ++pose) {
            float offset[3] = {0.0f, 0.0f, 0.0f};
            if (source.buffer->offsets[pose])
                source.buffer->offsets[pose].read(source.index, 3, offset);
            for (std::uint32_t axis = 0; axis < 3; ++axis) {
                if (mPoses == 1) {
                    out[axis] = offset[axis] * single;
                    continue;
                }
                for (std::uint32_t i = 0; i < kProjected; ++i)
                    out[i] += signAt(static_cast<std::uint32_t>(3 * pose) + axis, i) * offset[axis] * projected;
            }
        }
    }

    std::vector<std::size_t> varyingChannels() const
    {
        std::vector<char> varies(mChannels, 0);
        const float* first = mMesh.attributes.data();
        for (const float* row = first; row != first + mMesh.attributes.size(); row += mChannels)
            for (std::size_t i = 0; i < mChannels; ++i)
                varies[i] |= row[i] != first[i];
        std::vector<std::size_t> kept;
        for (std::size_t i = 0; i < mChannels; ++i)
            if (varies[i])
                kept.push_back(i);
        return kept;
    }

    /// Packs the kept channels, padded with zeros to pairs.
    void keepChannels(const std::vector<std::size_t>& kept, std::size_t wedges)
    {
        const std::size_t stride = (kept.size() + 1) / 2 * 2;
        std::vector<float> packed(wedges * stride, 0.0f);
        for (std::size_t wedge = 0; wedge < wedges; ++wedge)
            for (std::size_t i = 0; i < kept.size(); ++i)
                packed[wedge * stride + i] = mMesh.attributes[wedge * mChannels + kept[i]];
        mMesh.attributes.swap(packed);
        mMesh.attributeStride = stride;
    }

    CollapseMesh& mMesh;
    const MeshView& mView;
    const AttributeWeights& mWeights;
    std::size_t mChannels = 0, mPoses = 0;
    bool mHasNormals = false, mHasColours = false, mHasBones = false;
    std::vector<float> mUvScales; ///< of each set that counts
    float mNormalScale = 0.0f, mColourScale = 0.0f, mBoneScale = 0.0f;
};

} // namespace

void buildAttributes(CollapseMesh& mesh, const MeshView& view, const AttributeWeights& weights)
{
    AttributeBuilder(mesh, view, weights).build();
}

} // namespace lodsmith
