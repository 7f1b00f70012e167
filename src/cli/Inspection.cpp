#include "Inspection.h"

#include "../files/AtomicFile.h"
#include "../ogre/MeshHeader.h"
#include "../ogre/TrianglesIn.h"
#include "MeshFile.h"
#include "OgreSession.h"

#include <lodsmith/analysis/MeshStatistics.h>
#include <lodsmith/ogre/MeshReader.h>

#include <OgreLodStrategy.h>
#include <OgreSkeleton.h>
#include <OgreSubMesh.h>

namespace lodsmith::cli {

namespace {

const char* operationName(Ogre::RenderOperation::OperationType type)
{
    switch (type) {
    case Ogre::RenderOperation::OT_POINT_LIST: return "point list";
    case Ogre::RenderOperation::OT_LINE_LIST: return "line list";
    case Ogre::RenderOperation::OT_LINE_STRIP: return "line strip";
    case Ogre::RenderOperation::OT_TRIANGLE_LIST: return "triangle list";
    case Ogre::RenderOperation::OT_TRIANGLE_STRIP: return "triangle strip";
    case Ogre::RenderOperation::OT_TRIANGLE_FAN: return "triangle fan";
    default: return "other";
    }
}

Json subMeshRecord(const Ogre::Mesh& mesh, const Ogre::SubMesh& subMesh)
{
    const Ogre::VertexData* vertices = subMesh.useSharedVertices ? mesh.sharedVertexData : subMesh.vertexData;
    const Ogre::IndexData& indices = *subMesh.indexData;
    const auto& bones = subMesh.useSharedVertices ? mesh.getBoneAssignments() : subMesh.getBoneAssignments();
    return Json{{"material", subMesh.getMaterialName()},
                {"operation", operationName(subMesh.operationType)},
                {"shared_vertices", subMesh.useSharedVertices},
                {"buffer_vertices", vertices ? vertices->vertexCount : 0},
                {"indices", indices.indexCount},
                {"index_bits", indices.indexBuffer ? Json(8 * indices.indexBuffer->getIndexSize()) : Json(nullptr)},
                {"bone_assignments", bones.size()}};
}

Json generatedLevelRecord(const Ogre::Mesh& mesh, std::size_t level)
{
    std::size_t triangles = 0, bytes = 0;
    for (const Ogre::SubMesh* subMesh : mesh.getSubMeshes()) {
        const Ogre::IndexData* data = level == 0 ? subMesh->indexData : subMesh->mLodFaceList[level - 1];
        if (!data || !data->indexBuffer)
            continue;
        bytes += data->indexCount * data->indexBuffer->getIndexSize();
        triangles += trianglesIn(subMesh->operationType, data->indexCount);
    }
    return Json{{"triangles", triangles}, {"bytes", bytes}, {"manual", nullptr}};
}

Json levelRecords(const Ogre::Mesh& mesh)
{
    Json levels = Json::array();
    for (Ogre::ushort level = 0; level < mesh.getNumLodLevels(); ++level) {
        const Ogre::MeshLodUsage& usage = mesh.getLodLevel(level);
        Json record{{"value", level == 0 ? Json(nullptr) : Json(usage.userValue)}};
        record.update(usage.manualName.empty()
                          ? generatedLevelRecord(mesh, level)
                          : Json{{"triangles", nullptr}, {"bytes", 0}, {"manual", usage.manualName}});
        levels.push_back(record);
    }
    return levels;
}

Json statisticsRecord(const MeshStatistics& statistics)
{
    return Json{{"vertices", statistics.vertices},
                {"buffer_vertices", statistics.bufferVertices},
                {"unreferenced_vertices", statistics.unreferencedVertices},
                {"triangles", statistics.triangles},
                {"degenerate_triangles", statistics.degenerateTriangles},
                {"repeated_triangles", statistics.repeatedTriangles},
                {"edges", statistics.edges},
                {"border_edges", statistics.borderEdges},
                {"non_manifold_edges", statistics.nonManifoldEdges},
                {"inconsistent_edges", statistics.inconsistentEdges},
                {"uv_seam_edges", statistics.uvSeamEdges},
                {"normal_seam_edges", statistics.normalSeamEdges},
                {"material_edges", statistics.materialEdges},
                {"components", statistics.components},
                {"radius", statistics.radius},
                {"surface_area", statistics.surfaceArea}};
}

Json meshRecord(const Ogre::Mesh& mesh)
{
    Json record{{"skeleton", mesh.hasSkeleton() ? Json(mesh.getSkeletonName()) : Json(nullptr)},
                {"bones", mesh.getSkeleton() ? Json(mesh.getSkeleton()->getNumBones()) : Json(nullptr)},
                {"poses", mesh.getPoseList().size()},
                {"animations", mesh.getNumAnimations()},
                {"edge_lists", mesh.isEdgeListBuilt()},
                {"strategy", mesh.getLodStrategy()->getName()},
                {"submeshes", Json::array()}};
    for (const Ogre::SubMesh* subMesh : mesh.getSubMeshes())
        record["submeshes"].push_back(subMeshRecord(mesh, *subMesh));
    record["levels"] = levelRecords(mesh);
    return record;
}

} // namespace

Result<Json> inspectFile(const std::filesystem::path& path)
{
    const Result<std::string> bytes = readFile(path);
    if (!bytes)
        return bytes.error();
    OgreSession session;
    const Result<Ogre::MeshPtr> mesh = session.load(path);
    if (!mesh)
        return mesh.error();
    const Result<MeshData> data = MeshReader::read(*mesh.value());
    if (!data)
        return data.error();
    const Result<MeshStatistics> statistics = meshStatistics(data.value().view());
    if (!statistics)
        return statistics.error();

    const MeshHeader header = parseMeshHeader(bytes.value()).value();
    Json record{{"format", header.version}, {"big_endian", header.bigEndian}, {"bytes", bytes.value().size()}};
    record["statistics"] = statisticsRecord(statistics.value());
    record.update(meshRecord(*mesh.value()));
    std::vector<std::string> notes = data.value().notes();
    findSkeleton(*mesh.value(), path, notes);
    record["notes"] = notes;
    return record;
}

} // namespace lodsmith::cli
