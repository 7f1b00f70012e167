#include "LodLevelView.h"

#include <OgreHardwareIndexBuffer.h>
#include <OgreSubMesh.h>

namespace lodsmith::cli {

namespace {

std::vector<std::uint32_t> copyIndices(const Ogre::IndexData& data)
{
    std::vector<std::uint32_t> indices(data.indexCount);
    if (!data.indexBuffer || data.indexCount == 0)
        return {};
    const Ogre::HardwareBufferLockGuard lock(data.indexBuffer, Ogre::HardwareBuffer::HBL_READ_ONLY);
    const bool narrow = data.indexBuffer->getType() == Ogre::HardwareIndexBuffer::IT_16BIT;
    for (std::size_t i = 0; i < indices.size(); ++i)
        indices[i] = narrow ? static_cast<const std::uint16_t*>(lock.pData)[data.indexStart + i]
                            : static_cast<const std::uint32_t*>(lock.pData)[data.indexStart + i];
    return indices;
}

bool standsForNothing(const std::vector<std::uint32_t>& indices)
{
    return indices.size() == 3 && indices[0] == indices[1] && indices[1] == indices[2];
}

Error badLevel(ErrorCode code, std::string message, std::size_t subMesh)
{
    Error error{code, std::move(message)};
    error.subMesh = static_cast<int>(subMesh);
    return error;
}

Result<std::vector<std::uint32_t>> readTriangles(const Ogre::SubMesh& subMesh, std::size_t number, std::size_t level,
                                                 std::uint32_t vertexCount)
{
    const std::string name = "level " + std::to_string(level);
    const Ogre::IndexData* data = level <= subMesh.mLodFaceList.size() ? subMesh.mLodFaceList[level - 1] : nullptr;
    if (!data)
        return badLevel(ErrorCode::Unsupported, name + " is missing", number);
    if (subMesh.operationType != Ogre::RenderOperation::OT_TRIANGLE_LIST)
        return badLevel(ErrorCode::Unsupported, name + " is no triangle list", number);
    if (data->indexBuffer && data->indexStart + data->indexCount > data->indexBuffer->getNumIndexes())
        return badLevel(ErrorCode::IndexOutOfRange, name + " goes beyond its index buffer", number);
    std::vector<std::uint32_t> indices = copyIndices(*data);
    if (standsForNothing(indices))
        indices.clear();
    indices.resize(indices.size() / 3 * 3);
    for (const std::uint32_t index : indices)
        if (index >= vertexCount)
            return badLevel(ErrorCode::IndexOutOfRange,
                            name + " names vertex " + std::to_string(index) + " of " + std::to_string(vertexCount),
                            number);
    return indices;
}

} // namespace

Result<LodLevelView> readLodLevel(const Ogre::Mesh& mesh, const MeshData& data, std::size_t level)
{
    LodLevelView result;
    result.view = data.view();
    result.indices.resize(result.view.subMeshes.size());
    for (std::size_t number = 0; number < data.subMeshOf().size(); ++number) {
        const int place = data.subMeshOf()[number];
        if (place < 0)
            continue;
        SubMeshView& subMesh = result.view.subMeshes[static_cast<std::size_t>(place)];
        Result<std::vector<std::uint32_t>> triangles = readTriangles(
            *mesh.getSubMesh(number), number, level, result.view.vertexBuffers[subMesh.vertexBuffer].vertexCount);
        if (!triangles)
            return triangles.error();
        std::vector<std::uint32_t>& indices = result.indices[static_cast<std::size_t>(place)];
        indices = std::move(triangles).value();
        subMesh.indices = indices.data();
        subMesh.indexCount = static_cast<std::uint32_t>(indices.size());
        subMesh.indexBytes = 4;
    }
    return result;
}

} // namespace lodsmith::cli
