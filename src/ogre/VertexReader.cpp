#include "VertexReader.h"

#include "VertexElements.h"

#include <OgreAnimation.h>
#include <OgreAnimationTrack.h>
#include <OgreConfig.h>
#include <OgreKeyFrame.h>
#include <OgrePose.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

namespace lodsmith {

namespace {

/// Buffers locked for reading until the end of a scope, each once however many elements lie in it.
class ReadLocks {
public:
    const unsigned char* lock(const Ogre::HardwareVertexBufferSharedPtr& buffer)
    {
        for (const auto& held : mLocks)
            if (held->pBuf == buffer.get())
                return static_cast<const unsigned char*>(held->pData);
        mLocks.push_back(std::make_unique<Ogre::HardwareBufferLockGuard>(buffer, Ogre::HardwareBuffer::HBL_READ_ONLY));
        return static_cast<const unsigned char*>(mLocks.back()->pData);
    }

private:
    std::vector<std::unique_ptr<Ogre::HardwareBufferLockGuard>> mLocks;
};

Error badVertices(std::string message)
{
    return Error{ErrorCode::InvalidGeometry, std::move(message), {}, -1, -1, -1};
}

/// Reads the elements of one set of vertices into a view.
class ElementReader {
public:
    ElementReader(const Ogre::VertexData& vertices, Blocks& blocks) : mVertices(vertices), mBlocks(blocks) {}

    /// Null when there is no such element or its type is unknown; then no error either.
    Result<FloatStream> read(Ogre::VertexElementSemantic semantic, unsigned short index, int components)
    {
        const Ogre::VertexElement* element = find(semantic, index);
        if (!element || componentCount(element->getType()) == 0 || mVertices.vertexCount == 0)
            return FloatStream{};
        Result<ElementSource> source = locate(*element);
        if (!source)
            return source.error();
        float* out = addBlock<float>(mBlocks, mVertices.vertexCount * static_cast<std::size_t>(components));
        if (semantic == Ogre::VES_COLOUR)
            copyColour(source.value(), mVertices.vertexCount, out);
        else
            copyElement(source.value(), mVertices.vertexCount, components, out);
        return FloatStream{out, sizeof(float) * static_cast<std::size_t>(components)};
    }

    const Ogre::VertexElement* find(Ogre::VertexElementSemantic semantic, unsigned short index = 0) const
    {
        return mVertices.vertexDeclaration->findElementBySemantic(semantic, index);
    }

private:
    Result<ElementSource> locate(const Ogre::VertexElement& element)
    {
        const unsigned short binding = element.getSource();
        if (!mVertices.vertexBufferBinding->isBufferBound(binding))
            return badVertices("no vertex buffer is bound to source " + std::to_string(binding));
        const Ogre::HardwareVertexBufferSharedPtr& buffer = mVertices.vertexBufferBinding->getBuffer(binding);
        const std::size_t stride = buffer->getVertexSize();
        if (element.getOffset() + element.getSize() > stride)
            return badVertices("a vertex element ends beyond its vertex in source " + std::to_string(binding));
        if (mVertices.vertexStart + mVertices.vertexCount > buffer->getNumVertices())
            return badVertices("the vertex buffer of source " + std::to_string(binding) + " holds "
                               + std::to_string(buffer->getNumVertices()) + " vertices, fewer than are declared");
        return ElementSource{mLocks.lock(buffer) + mVertices.vertexStart * stride + element.getOffset(), stride,
                             element.getType()};
    }

    const Ogre::VertexData& mVertices;
    Blocks& mBlocks;
    ReadLocks mLocks;
};

std::optional<Error> readUvSets(ElementReader& reader, VertexBufferView& view)
{
    for (unsigned short set = 0; set < OGRE_MAX_TEXTURE_COORD_SETS; ++set) {
        const Ogre::VertexElement* element = reader.find(Ogre::VES_TEXTURE_COORDINATES, set);
        if (!element)
            continue;
        const int components = componentCount(element->getType());
        const Result<FloatStream> stream = reader.read(Ogre::VES_TEXTURE_COORDINATES, set, components);
        if (!stream)
            return stream.error();
        if (stream.value())
            view.uvSets.push_back(UvStream{stream.value(), components});
    }
    return std::nullopt;
}

std::optional<Error> readStreams(const Ogre::VertexData& vertices, Blocks& blocks, VertexBufferView& view)
{
    ElementReader reader(vertices, blocks);
    const Ogre::VertexElement* position = reader.find(Ogre::VES_POSITION);
    if (!position)
        return badVertices("the vertices have no positions");
    if (componentCount(position->getType()) == 0)
        return Error{ErrorCode::Unsupported,
                     "positions of the element type " + std::to_string(position->getType()) + " cannot be read"};

    const std::pair<Ogre::VertexElementSemantic, FloatStream*> streams[] = {
        {Ogre::VES_POSITION, &view.positions}, {Ogre::VES_NORMAL, &view.normals}, {Ogre::VES_COLOUR, &view.colours}};
    for (const auto& [semantic, stream] : streams) {
        const Result<FloatStream> read = reader.read(semantic, 0, semantic == Ogre::VES_COLOUR ? 4 : 3);
        if (!read)
            return read.error();
        *stream = read.value();
    }
    return readUvSets(reader, view);
}

/// Notes of elements whose type is not known here; their streams are absent.
void noteUnreadElements(const Ogre::VertexData& vertices, std::vector<std::string>& notes)
{
    for (const Ogre::VertexElement& element : vertices.vertexDeclaration->getElements())
        if (componentCount(element.getType()) == 0)
            notes.push_back("a vertex element of the unknown type " + std::to_string(element.getType())
                            + " was not read");
}

/// Puts one more influence among the four heaviest of a vertex. On equal weight the earlier one stays.
void addInfluence(BoneInfluences& influences, std::uint16_t bone, float weight)
{
    int slot = 0;
    while (slot < 4 && influences.weight[slot] >= weight)
        ++slot;
    if (slot == 4)
        return;
    for (int i = 3; i > slot; --i) {
        influences.bone[i] = influences.bone[i - 1];
        influences.weight[i] = influences.weight[i - 1];
    }
    influences.bone[slot] = bone;
    influences.weight[slot] = weight;
}

void normaliseInfluences(BoneInfluences& influences)
{
    const float sum = influences.weight[0] + influences.weight[1] + influences.weight[2] + influences.weight[3];
    if (sum > 0.0f)
        for (float& weight : influences.weight)
            weight /= sum;
}

void readBones(const VertexSource& source, Blocks& blocks, VertexBufferView& view, std::vector<std::string>& notes)
{
    if (source.bones->empty() || view.vertexCount == 0)
        return;
    BoneInfluences* bones = addBlock<BoneInfluences>(blocks, view.vertexCount);
    std::uninitialized_fill_n(bones, view.vertexCount, BoneInfluences{});
    std::size_t astray = 0, weightless = 0;
    for (const auto& [key, assignment] : *source.bones) {
        const std::size_t vertex = assignment.vertexIndex - source.vertices->vertexStart;
        const auto weight = static_cast<float>(assignment.weight);
        if (vertex >= view.vertexCount)
            ++astray;
        else if (!std::isfinite(weight))
            ++weightless;
        else
            addInfluence(bones[vertex], assignment.boneIndex, weight);
    }
    std::for_each(bones, bones + view.vertexCount, normaliseInfluences);
    view.bones = bones;
    if (astray > 0)
        notes.push_back(std::to_string(astray) + " bone assignments name no vertex and were ignored");
    if (weightless > 0)
        notes.push_back(std::to_string(weightless)
                        + " bone assignments have a weight that is no number and were ignored");
}

float* addOffsets(PoseMoment moment, Blocks& blocks, ReadVertices& read)
{
    float* offsets = addBlock<float>(blocks, std::size_t(3) * read.view.vertexCount);
    read.view.offsets.push_back(FloatStream{offsets, 3 * sizeof(float)});
    read.offsets.push_back(std::move(moment));
    return offsets;
}

/// One without a name is called by its number, from 1.
std::string nameOf(const Ogre::Pose& pose, std::size_t number)
{
    return pose.getName().empty() ? "#" + std::to_string(number) : pose.getName();
}

std::optional<Error> readPoses(const Ogre::Mesh& mesh, const VertexSource& source, Blocks& blocks, ReadVertices& read)
{
    const std::uint32_t vertexCount = read.view.vertexCount;
    std::size_t number = 0;
    for (const Ogre::Pose* pose : mesh.getPoseList()) {
        ++number;
        if (pose->getTarget() != source.handle || pose->getVertexOffsets().empty())
            continue;
        float* offsets = addOffsets({PoseMoment::Kind::Pose, nameOf(*pose, number), 0.0f}, blocks, read);
        std::fill_n(offsets, std::size_t(3) * vertexCount, 0.0f);
        for (const auto& [index, offset] : pose->getVertexOffsets()) {
            const std::size_t vertex = index - source.vertices->vertexStart;
            if (vertex >= vertexCount)
                return Error{ErrorCode::IndexOutOfRange,
                             "pose \"" + pose->getName() + "\" moves a vertex that does not exist",
                             {},
                             -1,
                             -1,
                             static_cast<std::int64_t>(index)};
            for (int axis = 0; axis < 3; ++axis)
                offsets[3 * vertex + static_cast<std::size_t>(axis)] =
                    static_cast<float>(offset[static_cast<std::size_t>(axis)]);
        }
    }
    return std::nullopt;
}

/// One morph frame, as offsets from the rest position. A frame that moves nothing is left out.
std::optional<Error> readMorphFrame(const Ogre::HardwareVertexBufferSharedPtr& frame, PoseMoment moment, Blocks& blocks,
                                    ReadVertices& read)
{
    const VertexBufferView& view = read.view;
    if (!frame || frame->getNumVertices() < view.vertexCount || frame->getVertexSize() < 3 * sizeof(float))
        return badVertices("a morph frame holds fewer vertices than the mesh");
    const Ogre::HardwareBufferLockGuard lock(frame, Ogre::HardwareBuffer::HBL_READ_ONLY);
    const ElementSource source{static_cast<const unsigned char*>(lock.pData), frame->getVertexSize(), Ogre::VET_FLOAT3};
    const auto* rest = static_cast<const float*>(view.positions.data);
    const std::size_t floats = std::size_t(3) * view.vertexCount;

    float* offsets = addOffsets(std::move(moment), blocks, read);
    copyElement(source, view.vertexCount, 3, offsets);
    if (std::memcmp(offsets, rest, floats * sizeof(float)) == 0) {
        read.view.offsets.pop_back();
        read.offsets.pop_back();
        blocks.pop_back();
        return std::nullopt;
    }
    for (std::size_t i = 0; i < floats; ++i)
        offsets[i] -= rest[i];
    return std::nullopt;
}

std::optional<Error> readMorphs(const Ogre::Mesh& mesh, const VertexSource& source, Blocks& blocks, ReadVertices& read)
{
    for (unsigned short i = 0; i < mesh.getNumAnimations(); ++i) {
        const Ogre::String& name = mesh.getAnimation(i)->getName();
        for (const auto& [handle, track] : mesh.getAnimation(i)->_getVertexTrackList()) {
            if (handle != source.handle || track->getAnimationType() != Ogre::VAT_MORPH)
                continue;
            for (unsigned short frame = 0; frame < track->getNumKeyFrames(); ++frame) {
                const Ogre::VertexMorphKeyFrame& key = *track->getVertexMorphKeyFrame(frame);
                PoseMoment moment{PoseMoment::Kind::Morph, name, static_cast<float>(key.getTime())};
                if (auto error = readMorphFrame(key.getVertexBuffer(), std::move(moment), blocks, read))
                    return error;
            }
        }
    }
    return std::nullopt;
}

} // namespace

Result<ReadVertices> readVertices(const Ogre::Mesh& mesh, const VertexSource& source, Blocks& blocks,
                                  std::vector<std::string>& notes)
{
    if (source.vertices->vertexCount > std::numeric_limits<std::uint32_t>::max())
        return Error{ErrorCode::Unsupported, "more than 4294967295 vertices in one buffer"};
    ReadVertices read;
    VertexBufferView& view = read.view;
    view.vertexCount = static_cast<std::uint32_t>(source.vertices->vertexCount);
    if (auto error = readStreams(*source.vertices, blocks, view))
        return *error;
    noteUnreadElements(*source.vertices, notes);
    if (view.vertexCount == 0)
        return read;
    readBones(source, blocks, view, notes);
    if (auto error = readPoses(mesh, source, blocks, read))
        return *error;
    if (auto error = readMorphs(mesh, source, blocks, read))
        return *error;
    return read;
}

} // namespace lodsmith
