#include <lodsmith/ogre/LevelReader.h>

#include "IndexReader.h"
#include "LevelCheck.h"
#include "MainThread.h"
#include "OgreGuard.h"

#include <lodsmith/core/Assert.h>

#include <OgreSubMesh.h>

#include <string>
#include <utility>

namespace lodsmith {

namespace {

std::string nameOf(unsigned level)
{
    return "level " + std::to_string(level);
}

/// Render systems crash over empty lists, hence the writer stores a triangle without area instead.
bool standsForNothing(const SubMeshView& list)
{
    return list.indexCount == 3 && list.index(0) == list.index(1) && list.index(1) == list.index(2);
}

/// Puts the triangles of a generated level into the view of one submesh.
Result<Done> readSubMesh(const Ogre::SubMesh& subMesh, unsigned level, std::uint32_t vertexCount, SubMeshView& view,
                         Blocks& blocks)
{
    const Ogre::IndexData* data = level <= subMesh.mLodFaceList.size() ? subMesh.mLodFaceList[level - 1] : nullptr;
    if (!data)
        return Error{ErrorCode::Unsupported, nameOf(level) + " is missing"};
    view.indexCount = 0;
    if (data->indexCount == 0)
        return Done{};
    const Result<TriangleList> list = readTriangles(*data, subMesh.operationType, vertexCount, blocks);
    if (!list) {
        Error error = list.error();
        error.message = nameOf(level) + ": " + error.message;
        return error;
    }
    view.indices = list.value().indices;
    view.indexCount = list.value().count;
    view.indexBytes = list.value().indexBytes;
    if (standsForNothing(view))
        view.indexCount = 0;
    return Done{};
}

Result<Done> readGenerated(const Ogre::Mesh& mesh, const MeshData& levelZero, unsigned level, MeshView& view,
                           Blocks& blocks)
{
    if (levelZero.subMeshOf().size() != mesh.getNumSubMeshes())
        return Error{ErrorCode::InvalidGeometry, "the mesh has changed since it was read"};
    for (std::size_t number = 0; number < mesh.getNumSubMeshes(); ++number) {
        const int place = levelZero.subMeshOf()[number];
        if (place < 0)
            continue;
        SubMeshView& subMesh = view.subMeshes[static_cast<std::size_t>(place)];
        const std::uint32_t vertexCount = view.vertexBuffers[subMesh.vertexBuffer].vertexCount;
        const Result<Done> read = readSubMesh(*mesh.getSubMesh(number), level, vertexCount, subMesh, blocks);
        if (!read) {
            Error error = read.error();
            error.subMesh = static_cast<int>(number);
            return error;
        }
    }
    return Done{};
}

} // namespace

Result<std::shared_ptr<const MeshData>> LevelReader::readLevelZero(const Ogre::Mesh& mesh,
                                                                   const std::vector<PoseMoment>* poses)
{
    Result<MeshData> data = MeshReader::read(mesh, {}, poses);
    if (!data)
        return data.error();
    return std::shared_ptr<const MeshData>(std::make_shared<MeshData>(std::move(data).value()));
}

Result<LevelData> LevelReader::read(const Ogre::Mesh& mesh, const std::shared_ptr<const MeshData>& levelZero,
                                    unsigned level)
{
    assertMainThread();
    LODSMITH_ASSERT(levelZero, "a level is read with level 0");
    return guarded(mesh.getName(), [&]() -> Result<LevelData> {
        const Result<Done> checked = checkLevel(mesh, level);
        if (!checked)
            return checked.error();
        LevelData data;
        data.mVertices = levelZero;
        const Ogre::MeshLodUsage& usage = mesh.getLodLevel(static_cast<Ogre::ushort>(level));
        const bool handMade = !usage.manualName.empty();
        if (handMade) {
            if (!usage.manualMesh)
                return Error{ErrorCode::NotFound, nameOf(level) + ": the mesh '" + usage.manualName + "' is not there"};
            const auto other = readLevelZero(*usage.manualMesh, &levelZero->poses());
            if (!other)
                return other.error();
            data.mVertices = other.value();
        }
        data.mView = data.mVertices->view();
        if (level == 0 || handMade)
            return data;
        const Result<Done> read = readGenerated(mesh, *levelZero, level, data.mView, data.mBlocks);
        if (!read)
            return read.error();
        return data;
    });
}

} // namespace lodsmith
