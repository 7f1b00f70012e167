#include "MeshInfo.h"

#include "../src/ogre/TrianglesIn.h"
#include <lodsmith/lua/Numbers.h>

#include <lodsmith/ogre/MeshReader.h>

#include <OgreHardwareBufferManager.h>
#include <OgreSkeleton.h>
#include <OgreSubMesh.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <vector>

namespace lodsmith::lua {

namespace {

std::size_t vertexBytes(const Ogre::VertexData* vertices)
{
    std::size_t bytes = 0;
    if (vertices)
        for (const auto& [source, buffer] : vertices->vertexBufferBinding->getBindings())
            bytes += buffer->getSizeInBytes();
    return bytes;
}

std::size_t indexSize(const Ogre::IndexData* indices)
{
    return indices && indices->indexBuffer ? indices->indexBuffer->getIndexSize() : 2;
}

/// What one way to draw a mesh is made of: level 0 or a generated level.
struct Drawn {
    std::size_t triangles = 0;
    std::size_t vertices = 0; ///< in the buffers, those that are referenced
    std::size_t indices = 0;
    std::size_t bytes = 0; ///< of the indices
};

const Ogre::IndexData* indicesOf(const Ogre::SubMesh& subMesh, std::size_t level)
{
    return level == 0                                ? subMesh.indexData
           : level - 1 < subMesh.mLodFaceList.size() ? subMesh.mLodFaceList[level - 1]
                                                     : nullptr;
}

/// Marks the vertices that are drawn; `first` is the place of the submesh's vertex 0.
void markVertices(const Ogre::IndexData& data, std::size_t first, std::vector<bool>& isUsed)
{
    if (data.indexCount == 0 || !data.indexBuffer
        || data.indexStart + data.indexCount > data.indexBuffer->getNumIndexes())
        return;
    const Ogre::HardwareBufferLockGuard lock(data.indexBuffer, Ogre::HardwareBuffer::HBL_READ_ONLY);
    const bool narrow = data.indexBuffer->getType() == Ogre::HardwareIndexBuffer::IT_16BIT;
    for (std::size_t i = data.indexStart; i < data.indexStart + data.indexCount; ++i) {
        const std::size_t vertex = first
                                   + (narrow ? static_cast<const std::uint16_t*>(lock.pData)[i]
                                             : static_cast<const std::uint32_t*>(lock.pData)[i]);
        if (vertex < isUsed.size())
            isUsed[vertex] = true;
    }
}

std::size_t bufferVertices(const Ogre::Mesh& mesh)
{
    std::size_t vertices = mesh.sharedVertexData ? mesh.sharedVertexData->vertexCount : 0;
    for (const Ogre::SubMesh* subMesh : mesh.getSubMeshes())
        if (!subMesh->useSharedVertices && subMesh->vertexData)
            vertices += subMesh->vertexData->vertexCount;
    return vertices;
}

Drawn drawn(const Ogre::Mesh& mesh, std::size_t level)
{
    Drawn result;
    std::vector<bool> isUsed(bufferVertices(mesh));
    // The shared buffer first, then those of the submeshes, one behind the other.
    std::size_t next = mesh.sharedVertexData ? mesh.sharedVertexData->vertexCount : 0;
    for (const Ogre::SubMesh* subMesh : mesh.getSubMeshes()) {
        const std::size_t first = subMesh->useSharedVertices ? 0 : next;
        if (!subMesh->useSharedVertices && subMesh->vertexData)
            next += subMesh->vertexData->vertexCount;
        const Ogre::IndexData* data = indicesOf(*subMesh, level);
        if (!data)
            continue;
        result.triangles += trianglesIn(subMesh->operationType, data->indexCount);
        result.indices += data->indexCount;
        result.bytes += data->indexCount * indexSize(data);
        markVertices(*data, first, isUsed);
    }
    result.vertices = static_cast<std::size_t>(std::count(isUsed.begin(), isUsed.end(), true));
    return result;
}

std::string nameOf(const Ogre::Mesh& mesh, std::size_t subMesh)
{
    for (const auto& [name, number] : mesh.getSubMeshNameMap())
        if (number == subMesh)
            return name;
    return {};
}

Table subMeshTable(const Ogre::Mesh& mesh, std::size_t number)
{
    const Ogre::SubMesh& subMesh = *mesh.getSubMesh(number);
    const Ogre::VertexData* vertices = subMesh.useSharedVertices ? mesh.sharedVertexData : subMesh.vertexData;
    const std::size_t indices = subMesh.indexData ? subMesh.indexData->indexCount : 0;
    Table table;
    table.set("name", nameOf(mesh, number))
        .set("material", subMesh.getMaterialName())
        .set("triangles", trianglesIn(subMesh.operationType, indices))
        .set("vertices", vertices ? vertices->vertexCount : 0)
        .set("indices", indices)
        .set("shared", subMesh.useSharedVertices)
        .set("indexBytes", indexSize(subMesh.indexData));
    return table;
}

Table generatedLevelTable(const Ogre::Mesh& mesh, std::size_t level)
{
    const Drawn figures = drawn(mesh, level);
    Table table;
    table.set("triangles", figures.triangles)
        .set("vertices", figures.vertices)
        .set("indices", figures.indices)
        .set("bytes", figures.bytes)
        .set("handMade", false);
    return table;
}

/// Without figures when the mesh cannot be had.
Table handMadeLevelTable(const Ogre::MeshLodUsage& usage)
{
    Table table;
    table.set("handMade", true).set("mesh", usage.manualName);
    if (usage.manualMesh) {
        const Drawn figures = drawn(*usage.manualMesh, 0);
        table.set("triangles", figures.triangles)
            .set("vertices", figures.vertices)
            .set("indices", figures.indices)
            .set("bytes", figures.bytes);
    }
    return table;
}

Table levelTables(const Ogre::Mesh& mesh)
{
    Table levels;
    for (Ogre::ushort level = 1; level < mesh.getNumLodLevels(); ++level) {
        const Ogre::MeshLodUsage& usage = mesh.getLodLevel(level);
        Table table = usage.manualName.empty() ? generatedLevelTable(mesh, level) : handMadeLevelTable(usage);
        levels.add(std::move(table.set("value", usage.userValue)));
    }
    return levels;
}

std::size_t meshBytes(const Ogre::Mesh& mesh)
{
    std::size_t bytes = vertexBytes(mesh.sharedVertexData);
    for (const Ogre::SubMesh* subMesh : mesh.getSubMeshes()) {
        if (!subMesh->useSharedVertices)
            bytes += vertexBytes(subMesh->vertexData);
        if (subMesh->indexData)
            bytes += subMesh->indexData->indexCount * indexSize(subMesh->indexData);
    }
    return bytes;
}

/// A position as bits, so that any numbers can be compared; -0 is 0.
std::array<std::uint32_t, 3> positionBits(const FloatStream& positions, std::size_t vertex)
{
    float position[3];
    positions.read(vertex, 3, position);
    for (float& coordinate : position)
        coordinate += 0.0f;
    std::array<std::uint32_t, 3> bits = {};
    std::memcpy(bits.data(), position, sizeof position);
    return bits;
}

/// Different positions among the vertices that triangles use.
std::size_t uniqueVertices(const MeshView& mesh)
{
    std::vector<std::vector<bool>> isUsed;
    for (const VertexBufferView& buffer : mesh.vertexBuffers)
        isUsed.emplace_back(buffer.vertexCount);
    for (const SubMeshView& subMesh : mesh.subMeshes)
        for (std::uint32_t i = 0; i < subMesh.indexCount; ++i)
            isUsed[subMesh.vertexBuffer][subMesh.index(i)] = true;
    std::vector<std::array<std::uint32_t, 3>> positions;
    for (std::size_t buffer = 0; buffer < isUsed.size(); ++buffer)
        for (std::size_t vertex = 0; vertex < isUsed[buffer].size(); ++vertex)
            if (isUsed[buffer][vertex])
                positions.push_back(positionBits(mesh.vertexBuffers[buffer].positions, vertex));
    std::sort(positions.begin(), positions.end());
    return static_cast<std::size_t>(std::unique(positions.begin(), positions.end()) - positions.begin());
}

/// Of the skeleton and of the vertices.
std::size_t animationCount(const Ogre::Mesh& mesh)
{
    const Ogre::SkeletonPtr& skeleton = mesh.getSkeleton();
    return std::size_t(mesh.getNumAnimations()) + (skeleton ? skeleton->getNumAnimations() : 0);
}

} // namespace

Result<Table> meshInfo(const Ogre::Mesh& mesh)
{
    const Result<MeshData> data = MeshReader::read(mesh);
    if (!data)
        return data.error();
    const Drawn figures = drawn(mesh, 0);
    const Ogre::Vector3 size = mesh.getBounds().isFinite() ? mesh.getBounds().getSize() : Ogre::Vector3::ZERO;
    Table table;
    table.set("triangles", figures.triangles)
        .set("vertices", bufferVertices(mesh))
        .set("uniqueVertices", uniqueVertices(data.value().view()))
        .set("indices", figures.indices)
        .set("bytes", meshBytes(mesh))
        .set("radius", mesh.getBoundingSphereRadius())
        .set("size", std::move(Table().set("x", size.x).set("y", size.y).set("z", size.z)))
        .set("edgeLists", mesh.isEdgeListBuilt())
        .set("skeleton", mesh.hasSkeleton() ? Value(mesh.getSkeletonName()) : Value())
        .set("animations", animationCount(mesh))
        .set("poses", mesh.getPoseList().size())
        .set("notes", Table(data.value().notes()));
    Table subMeshes;
    for (std::size_t i = 0; i < mesh.getNumSubMeshes(); ++i)
        subMeshes.add(subMeshTable(mesh, i));
    table.set("submeshes", std::move(subMeshes)).set("levels", levelTables(mesh));
    return table;
}

Result<std::size_t> trianglesOfLevel(const Ogre::Mesh& mesh, double level)
{
    // Levels begin at 0 and end one below their number.
    const Result<std::size_t> position = positionFrom(level + 1, mesh.getNumLodLevels(), "level");
    if (!position)
        return Error{ErrorCode::NotFound, "there is no level " + numberText(level) + " on the mesh", mesh.getName()};
    const Ogre::MeshLodUsage& usage = mesh.getLodLevel(static_cast<Ogre::ushort>(position.value()));
    if (usage.manualName.empty())
        return drawn(mesh, position.value()).triangles;
    if (!usage.manualMesh)
        return Error{ErrorCode::NotFound, "the mesh \"" + usage.manualName + "\" cannot be had", mesh.getName()};
    return drawn(*usage.manualMesh, 0).triangles;
}

} // namespace lodsmith::lua
