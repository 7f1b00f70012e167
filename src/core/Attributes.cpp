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
        mStride = (mChannels + 1) / 2 * 2;
        mWedges = mMesh.nextWedge.size();
        mMesh.attributes.resize(mWedges * mStride);
        for (std::uint32_t wedge = 0; wedge < mWedges; ++wedge)
            readRow(wedge, rowOf(wedge));
        for (std::size_t set = 0; set < mUvSets; ++set)
            scaleUv(2 * set);
        keepChannels(varyingChannels());
    }

private:
    Source sourceOf(std::uint32_t wedge) const
    {
        return {&mView.vertexBuffers[mView.subMeshes[mMesh.subMeshOfWedge(wedge)].vertexBuffer],
                mMesh.wedgeSource[wedge]};
    }

    float* rowOf(std::size_t wedge) { return mMesh.attributes.data() + wedge * mStride; }

    void planChannels()
    {
        for (const VertexBufferView& buffer : mView.vertexBuffers) {
            if (mWeights.uv > 0.0f)
                mUvSets = std::max(mUvSets, buffer.uvSets.size());
            mPoses = std::max(mPoses, buffer.offsets.size());
            mHasNormals |= static_cast<bool>(buffer.normals) && mWeights.normal > 0.0f;
            mHasColours |= static_cast<bool>(buffer.colours) && mWeights.colour > 0.0f;
            mHasBones |= buffer.bones != nullptr && mWeights.bone > 0.0f;
        }
        const double radius = mMesh.summary.radius * mMesh.scale;
        mNormalScale = static_cast<float>(mWeights.normal * radius);
        mColourScale = static_cast<float>(mWeights.colour * radius);
        mBoneScale = static_cast<float>(mWeights.bone * radius / std::sqrt(static_cast<double>(kProjected)));
        mChannels = 2 * mUvSets + (mHasNormals ? 3 : 0) + (mHasColours ? 4 : 0) + (mHasBones ? kProjected : 0)
                    + std::min<std::size_t>(3 * mPoses, kProjected);
    }

    /// Scales a texture coordinate set, whose two channels have been read, by the length that one unit of it stands for: from
    /// the mesh's mean texel density.
    void scaleUv(std::size_t channel)
    {
        double texture = 0.0;
        for (const CollapseMesh::Face& face : mMesh.faces) {
            const float *a = rowOf(face.wedge[0]) + channel, *b = rowOf(face.wedge[1]) + channel,
                        *c = rowOf(face.wedge[2]) + channel;
            const double doubled = (b[0] - a[0]) * double{c[1] - a[1]} - (b[1] - a[1]) * double{c[0] - a[0]};
            texture += 0.5 * std::abs(doubled);
        }
        const float scale = texture > 0.0 ? static_cast<float>(mWeights.uv * std::sqrt(mMesh.area / texture)) : 0.0f;
        for (std::size_t wedge = 0; wedge < mWedges; ++wedge) {
            rowOf(wedge)[channel] *= scale;
            rowOf(wedge)[channel + 1] *= scale;
        }
    }

    /// All channels of a wedge, in the order uv sets, normal, colour, bones, offsets, into a row of zeros. Texture
    /// coordinates are scaled afterwards.
    void readRow(std::uint32_t wedge, float* out) const
    {
        const Source source = sourceOf(wedge);
        const std::size_t uvSets = std::min(mUvSets, source.buffer->uvSets.size());
        for (std::size_t set = 0; set < uvSets; ++set)
            readUv(source.buffer->uvSets[set], source.index, out + 2 * set);
        out += 2 * mUvSets;
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
        if (mPoses != 0)
            readOffsets(source, out);
    }

    static void readUv(const UvStream& uv, std::uint32_t index, float* out)
    {
        if (uv.stream && uv.components == 1)
            uv.stream.read(index, 1, out);
        else if (uv.stream)
            uv.stream.read(index, 2, out);
    }

    void readNormal(const Source& source, float* out) const
    {
        if (!source.buffer->normals)
            return;
        source.buffer->normals.read(source.index, 3, out);
        const double size = std::sqrt(double{out[0]} * out[0] + double{out[1]} * out[1] + double{out[2]} * out[2]);
        for (int i = 0; i < 3; ++i)
            out[i] = size > 0.0 ? static_cast<float>(out[i] / size * mNormalScale) : 0.0f;
    }

    void readColour(const Source& source, float* out) const
    {
        if (!source.buffer->colours)
            return;
        source.buffer->colours.read(source.index, 4, out);
        for (int i = 0; i < 4; ++i)
            out[i] *= mColourScale;
    }

    void readBones(const Source& source, float* out) const
    {
        if (!source.buffer->bones)
            return;
        const BoneInfluences& bones = source.buffer->bones[source.index];
        for (int entry = 0; entry < 4; ++entry)
            for (int i = 0; i < kProjected; ++i)
                out[i] += signAt(bones.bone[entry], static_cast<std::uint32_t>(i)) * bones.weight[entry] * mBoneScale;
    }

    void readOffsets(const Source& source, float* out) const
    {
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

    /// Few rows have to be looked at: most channels vary, and soon.
    std::vector<std::size_t> varyingChannels()
    {
        std::vector<std::size_t> varying;
        for (std::size_t channel = 0; channel < mChannels; ++channel) {
            std::size_t wedge = 1;
            while (wedge < mWedges && rowOf(wedge)[channel] == rowOf(0)[channel])
                ++wedge;
            if (wedge < mWedges)
                varying.push_back(channel);
        }
        return varying;
    }

    /// Packs the kept channels, padded with zeros to pairs.
    void keepChannels(const std::vector<std::size_t>& kept)
    {
        mMesh.attributeStride = (kept.size() + 1) / 2 * 2;
        if (kept.size() == mChannels)
            return;
        std::vector<float> packed(mWedges * mMesh.attributeStride, 0.0f);
        float* out = packed.data();
        for (std::size_t wedge = 0; wedge < mWedges; ++wedge, out += mMesh.attributeStride)
            for (std::size_t i = 0; i < kept.size(); ++i)
                out[i] = rowOf(wedge)[kept[i]];
        mMesh.attributes.swap(packed);
    }

    CollapseMesh& mMesh;
    const MeshView& mView;
    const AttributeWeights& mWeights;
    std::size_t mUvSets = 0, mPoses = 0;
    std::size_t mChannels = 0, mStride = 0, mWedges = 0; ///< a row of the channels, padded to pairs, for each wedge
    bool mHasNormals = false, mHasColours = false, mHasBones = false;
    float mNormalScale = 0.0f, mColourScale = 0.0f, mBoneScale = 0.0f;
};

} // namespace

void buildAttributes(CollapseMesh& mesh, const MeshView& view, const AttributeWeights& weights)
{
    AttributeBuilder(mesh, view, weights).build();
}

} // namespace lodsmith
