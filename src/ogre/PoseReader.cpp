#include "PoseReader.h"

#include "PoseChoice.h"
#include "ShapeChoice.h"
#include "SkeletonMoments.h"

#include <OgreBone.h>
#include <OgreSkeleton.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace lodsmith {

namespace {

constexpr double kLargest = 1e5; // times as large as at rest: what is drawn out farther is broken

/// The longest side of the box around all vertices; NaN or infinity when a coordinate is not finite.
double sizeOf(const FloatStream& positions, std::uint32_t count)
{
    double low[3], high[3], sum = 0.0, size = 0.0;
    std::fill(low, low + 3, std::numeric_limits<double>::max());
    std::fill(high, high + 3, std::numeric_limits<double>::lowest());
    for (std::uint32_t v = 0; v < count; ++v) {
        float position[3];
        positions.read(v, 3, position);
        for (std::size_t i = 0; i < 3; ++i) {
            low[i] = std::min<double>(low[i], position[i]);
            high[i] = std::max<double>(high[i], position[i]);
            sum += std::abs(double{position[i]});
        }
    }
    for (std::size_t i = 0; i < 3; ++i)
        size = std::max(size, high[i] - low[i]);
    return std::isfinite(sum) ? size : sum;
}

/// The bone with the highest number that moves anything, and one more; 0 when none does.
std::size_t bonesUsed(const MeshView& view)
{
    std::size_t used = 0;
    for (const VertexBufferView& buffer : view.vertexBuffers)
        for (std::uint32_t v = 0; buffer.bones && v < buffer.vertexCount; ++v)
            for (int i = 0; i < 4; ++i)
                if (buffer.bones[v].weight[i] > 0.0f)
                    used = std::max<std::size_t>(used, buffer.bones[v].bone[i] + 1u);
    return used;
}

/// Null when there is none to move the vertices, with a note if it should.
std::unique_ptr<SkeletonMoments> movableSkeleton(const Ogre::Mesh& mesh, const MeshView& view,
                                                 std::vector<std::string>& notes)
{
    const Ogre::SkeletonPtr& skeleton = mesh.getSkeleton();
    const std::size_t used = bonesUsed(view);
    if (used == 0)
        return nullptr;
    if (!skeleton || !skeleton->isLoaded() || skeleton->getNumBones() == 0) {
        if (mesh.hasSkeleton())
            notes.push_back("skeleton '" + mesh.getSkeletonName()
                            + "' is missing or damaged, so its animations do not count");
        return nullptr;
    }
    const auto& bones = skeleton->getBones();
    if (used <= bones.size() && std::find(bones.begin(), bones.end(), nullptr) == bones.end())
        return std::make_unique<SkeletonMoments>(skeleton);
    notes.emplace_back("vertices follow bones that the skeleton does not have, so its animations do not count");
    return nullptr;
}

/// As OGRE does it: a vertex without a bone, in a buffer that has some, follows the first one.
void skin(const VertexBufferView& buffer, const std::vector<Ogre::Affine3>& transforms, float* out)
{
    for (std::uint32_t v = 0; v < buffer.vertexCount; ++v, out += 3) {
        float position[3];
        buffer.positions.read(v, 3, position);
        BoneInfluences influences = buffer.bones[v];
        if (!(influences.weight[0] > 0.0f))
            influences.weight[0] = 1.0f;
        double sum[3] = {};
        for (std::size_t i = 0; i < 4 && influences.weight[i] > 0.0f; ++i) {
            const Ogre::Affine3& m = transforms[influences.bone[i]];
            for (std::size_t row = 0; row < 3; ++row)
                sum[row] += double{influences.weight[i]}
                            * (double{m[row][0]} * position[0] + double{m[row][1]} * position[1]
                               + double{m[row][2]} * position[2] + double{m[row][3]});
        }
        for (std::size_t row = 0; row < 3; ++row)
            out[row] = static_cast<float>(sum[row]);
    }
}

/// Gives a view one pose after the other.
class PoseAdder {
public:
    PoseAdder(const OffsetMoments& offsets, SkeletonMoments* skeleton, MeshView& view, Blocks& blocks)
        : mOffsets(offsets), mSkeleton(skeleton), mView(view), mBlocks(blocks)
    {
    }

    /// False, with the view as it was, when there is no such moment, or it draws something out too far.
    bool add(const PoseMoment& moment)
    {
        const std::size_t blocksBefore = mBlocks.size();
        if (moment.kind == PoseMoment::Kind::Skeleton && !(mSkeleton && mSkeleton->at(moment, mBones)))
            return false;
        bool moves = false, sound = true;
        for (std::size_t b = 0; b < mView.vertexBuffers.size(); ++b) {
            VertexBufferView& buffer = mView.vertexBuffers[b];
            buffer.poses.push_back(moment.kind == PoseMoment::Kind::Skeleton ? skinned(buffer)
                                                                             : shaped(buffer, mOffsets[b], moment));
            if (!buffer.poses.back())
                continue;
            moves = true;
            sound &= sizeOf(buffer.poses.back(), buffer.vertexCount)
                     <= kLargest * sizeOf(buffer.positions, buffer.vertexCount);
        }
        if (moves && sound)
            return true;
        for (VertexBufferView& buffer : mView.vertexBuffers)
            buffer.poses.pop_back();
        mBlocks.resize(blocksBefore);
        return false;
    }

private:
    FloatStream skinned(const VertexBufferView& buffer)
    {
        if (!buffer.bones)
            return {};
        float* positions = addBlock<float>(mBlocks, std::size_t(3) * buffer.vertexCount);
        skin(buffer, mBones.transforms, positions);
        return FloatStream{positions, 3 * sizeof(float)};
    }

    FloatStream shaped(const VertexBufferView& buffer, const std::vector<PoseMoment>& offsets, const PoseMoment& moment)
    {
        const std::size_t number =
            static_cast<std::size_t>(std::find(offsets.begin(), offsets.end(), moment) - offsets.begin());
        if (number == offsets.size())
            return {};
        float* positions = addBlock<float>(mBlocks, std::size_t(3) * buffer.vertexCount);
        for (std::uint32_t v = 0; v < buffer.vertexCount; ++v) {
            float rest[3], offset[3];
            buffer.positions.read(v, 3, rest);
            buffer.offsets[number].read(v, 3, offset);
            for (std::size_t i = 0; i < 3; ++i)
                positions[3 * std::size_t{v} + i] = rest[i] + offset[i];
        }
        return FloatStream{positions, 3 * sizeof(float)};
    }

    const OffsetMoments& mOffsets;
    SkeletonMoments* mSkeleton;
    MeshView& mView;
    Blocks& mBlocks;
    SkeletonMoments::Bones mBones;
};

std::vector<PoseMoment> chooseAll(const OffsetMoments& offsets, SkeletonMoments* skeleton, const MeshView& view)
{
    std::vector<PoseMoment> chosen;
    if (skeleton)
        chosen = choosePoses(view, *skeleton, kMostPoses);
    for (PoseMoment& moment : chooseShapes(view, offsets, kMostPoses))
        chosen.push_back(std::move(moment));
    return chosen;
}

} // namespace

std::vector<PoseMoment> readPoses(const Ogre::Mesh& mesh, const OffsetMoments& offsets,
                                  const std::vector<PoseMoment>* moments, MeshView& view, Blocks& blocks,
                                  std::vector<std::string>& notes)
{
    const std::unique_ptr<SkeletonMoments> skeleton = movableSkeleton(mesh, view, notes);
    const std::vector<PoseMoment> wanted = moments ? *moments : chooseAll(offsets, skeleton.get(), view);
    std::vector<PoseMoment> shown;
    PoseAdder adder(offsets, skeleton.get(), view, blocks);
    for (const PoseMoment& moment : wanted)
        if (adder.add(moment))
            shown.push_back(moment);
    if (!moments || shown.size() == wanted.size())
        return shown;
    for (VertexBufferView& buffer : view.vertexBuffers)
        buffer.poses.clear();
    return {};
}

} // namespace lodsmith
