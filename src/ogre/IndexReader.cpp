#include "IndexReader.h"

#include <OgreVertexIndexData.h>

#include <algorithm>
#include <cstring>
#include <limits>

namespace lodsmith {

namespace {

template <class Index>
TriangleList copyList(const Index* from, std::size_t count, Blocks& blocks)
{
    const std::size_t whole = count - count % 3;
    Index* out = addBlock<Index>(blocks, whole);
    std::memcpy(out, from, whole * sizeof(Index));
    return TriangleList{out, static_cast<std::uint32_t>(whole), sizeof(Index)};
}

template <class Index>
TriangleList expand(const Index* from, std::size_t count, bool fan, Blocks& blocks)
{
    const std::size_t triangles = count < 3 ? 0 : count - 2;
    Index* out = addBlock<Index>(blocks, 3 * triangles);
    std::uint32_t written = 0;
    for (std::size_t i = 0; i < triangles; ++i) {
        // Every second triangle of a strip runs the other way round.
        const bool turned = !fan && i % 2 == 1;
        const Index a = fan ? from[0] : from[turned ? i + 1 : i];
        const Index b = fan ? from[i + 1] : from[turned ? i : i + 1];
        const Index c = from[i + 2];
        if (a == b || b == c || c == a)
            continue;
        out[written++] = a;
        out[written++] = b;
        out[written++] = c;
    }
    return TriangleList{out, written, sizeof(Index)};
}

/// A plain loop, since compilers vectorise it and not std::max_element.
template <class Index>
Index highest(const Index* from, std::size_t count)
{
    Index result = 0;
    for (std::size_t i = 0; i < count; ++i)
        result = std::max(result, from[i]);
    return result;
}

template <class Index>
Result<TriangleList> readIndices(const Index* from, std::size_t count, Ogre::RenderOperation::OperationType type,
                                 std::uint32_t vertexCount, Blocks& blocks)
{
    if (highest(from, count) >= vertexCount) {
        const Index* bad = std::find_if(from, from + count, [&](Index index) { return index >= vertexCount; });
        return Error{ErrorCode::IndexOutOfRange,
                     "index " + std::to_string(*bad) + " names no vertex, there are " + std::to_string(vertexCount),
                     {},
                     -1,
                     -1,
                     bad - from};
    }
    if (type == Ogre::RenderOperation::OT_TRIANGLE_LIST)
        return copyList(from, count, blocks);
    return expand(from, count, type == Ogre::RenderOperation::OT_TRIANGLE_FAN, blocks);
}

} // namespace

std::string reasonToLeaveAlone(const Ogre::SubMesh& subMesh)
{
    switch (subMesh.operationType) {
    case Ogre::RenderOperation::OT_TRIANGLE_LIST:
    case Ogre::RenderOperation::OT_TRIANGLE_STRIP:
    case Ogre::RenderOperation::OT_TRIANGLE_FAN: break;
    case Ogre::RenderOperation::OT_POINT_LIST: return "a point list";
    case Ogre::RenderOperation::OT_LINE_LIST: return "a line list";
    case Ogre::RenderOperation::OT_LINE_STRIP: return "a line strip";
    default: return "neither points, lines nor triangles";
    }
    if (subMesh.indexData->indexCount == 0)
        return "without indices";
    return {};
}

Result<TriangleList> readTriangles(const Ogre::IndexData& data, Ogre::RenderOperation::OperationType type,
                                   std::uint32_t vertexCount, Blocks& blocks)
{
    if (!data.indexBuffer)
        return Error{ErrorCode::InvalidGeometry, "the submesh has an index count but no index buffer"};
    const std::size_t size = data.indexBuffer->getNumIndexes();
    if (data.indexStart > size || data.indexCount > size - data.indexStart)
        return Error{
            ErrorCode::IndexOutOfRange,     "the submesh draws indices beyond the end of its index buffer", {}, -1, -1,
            static_cast<std::int64_t>(size)};
    if (data.indexCount > std::numeric_limits<std::uint32_t>::max() / 3)
        return Error{ErrorCode::Unsupported, "more than 1431655765 indices in one submesh"};

    const Ogre::HardwareBufferLockGuard lock(data.indexBuffer, Ogre::HardwareBuffer::HBL_READ_ONLY);
    if (data.indexBuffer->getType() == Ogre::HardwareIndexBuffer::IT_16BIT)
        return readIndices(static_cast<const std::uint16_t*>(lock.pData) + data.indexStart, data.indexCount, type,
                           vertexCount, blocks);
    return readIndices(static_cast<const std::uint32_t*>(lock.pData) + data.indexStart, data.indexCount, type,
                       vertexCount, blocks);
}

} // namespace lodsmith
