#include <lodsmith/ogre/MeshWriter.h>

#include "IndexReader.h"
#include "LivingEntities.h"
#include "LodPlan.h"
#include "MainThread.h"
#include "OgreGuard.h"

#include <lodsmith/core/Assert.h>

#include <OgreEntity.h>
#include <OgreHardwareBufferManager.h>
#include <OgreSubMesh.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <optional>

namespace lodsmith {

namespace {

using IndexDataPtr = std::unique_ptr<Ogre::IndexData>;

IndexDataPtr makeIndexData(const Ogre::HardwareIndexBufferSharedPtr& buffer, std::size_t start, std::size_t count)
{
    IndexDataPtr data(OGRE_NEW Ogre::IndexData());
    data->indexBuffer = buffer;
    data->indexStart = start;
    data->indexCount = count;
    return data;
}

/// An index buffer of the same width, usage and shadow as level 0 has, or as the mesh asks for when that has none.
Ogre::HardwareIndexBufferSharedPtr makeBuffer(Ogre::Mesh& mesh, const Ogre::SubMesh& subMesh, std::size_t count)
{
    const auto& model = subMesh.indexData->indexBuffer;
    return mesh.getHardwareBufferManager()->createIndexBuffer(
        model ? model->getType() : Ogre::HardwareIndexBuffer::IT_16BIT, count,
        model ? model->getUsage() : mesh.getIndexBufferUsage(),
        model ? model->hasShadowBuffer() : mesh.isIndexBufferShadowed());
}

const std::vector<std::uint32_t> kNoTriangle;
const std::vector<std::uint32_t> kPointTriangle = {0, 0, 0};

/// Fills a buffer with lists of indices, one behind the other. Render systems crash over empty lists, hence an empty one
/// becomes a triangle without area. Returns the index data of each list.
std::vector<IndexDataPtr> storeLists(Ogre::Mesh& mesh, const Ogre::SubMesh& subMesh,
                                     const std::vector<const std::vector<std::uint32_t>*>& lists)
{
    std::size_t total = 0;
    for (const auto* list : lists)
        total += list->empty() ? kPointTriangle.size() : list->size();

    const Ogre::HardwareIndexBufferSharedPtr buffer = makeBuffer(mesh, subMesh, total);
    const Ogre::HardwareBufferLockGuard lock(buffer, Ogre::HardwareBuffer::HBL_DISCARD);
    const bool narrow = buffer->getType() == Ogre::HardwareIndexBuffer::IT_16BIT;
    std::vector<IndexDataPtr> stored;
    std::size_t start = 0;
    for (const auto* list : lists) {
        const std::vector<std::uint32_t>& indices = list->empty() ? kPointTriangle : *list;
        if (narrow)
            std::transform(indices.begin(), indices.end(), static_cast<std::uint16_t*>(lock.pData) + start,
                           [](std::uint32_t index) { return static_cast<std::uint16_t>(index); });
        else
            std::memcpy(static_cast<std::uint32_t*>(lock.pData) + start, indices.data(), 4 * indices.size());
        stored.push_back(makeIndexData(buffer, start, indices.size()));
        start += indices.size();
    }
    return stored;
}

/// What a submesh that was left alone draws at a level: the same as at level 0. Without indices OGRE draws the plain vertices
/// when the level's index count is 0, and its serializer wants a buffer all the same.
IndexDataPtr repeatLevelZero(Ogre::Mesh& mesh, const Ogre::SubMesh& subMesh)
{
    const Ogre::IndexData& whole = *subMesh.indexData;
    if (whole.indexBuffer)
        return makeIndexData(whole.indexBuffer, whole.indexStart, whole.indexCount);
    IndexDataPtr data = std::move(storeLists(mesh, subMesh, {&kNoTriangle}).front());
    data->indexCount = 0;
    return data;
}

/// Everything that will be attached to the mesh, complete before the mesh is touched.
struct PreparedLevels {
    /// Of levels 1 and up: the level of the configuration it comes from.
    std::vector<std::size_t> sources;
    /// Of levels 1 and up: one for each submesh; empty index data in a manual level.
    std::vector<std::vector<IndexDataPtr>> faces;
    /// One for each submesh: its level 0 as a list, when OGRE would draw the levels as strips or fans.
    std::vector<IndexDataPtr> convertedLevelZero;
};

class LevelBuilder {
public:
    LevelBuilder(const LodConfig& config, const MeshData& data, const LodChain& chain)
        : mConfig(config), mMesh(*config.mesh), mData(data), mChain(chain)
    {
    }

    /// Errors: those of readTriangles(), without a file.
    Result<PreparedLevels> build()
    {
        chooseLevels();
        mPrepared.faces.resize(mPrepared.sources.size());
        for (auto& faces : mPrepared.faces)
            faces.resize(mMesh.getNumSubMeshes());
        for (std::size_t subMesh = 0; subMesh < mMesh.getNumSubMeshes(); ++subMesh) {
            buildSubMesh(subMesh);
            if (auto error = convertLevelZero(subMesh)) {
                error->subMesh = static_cast<int>(subMesh);
                return *error;
            }
        }
        return std::move(mPrepared);
    }

private:
    /// A generated level that is stored.
    struct Generated {
        std::size_t level;              ///< in PreparedLevels
        const LodChainLevel* triangles; ///< in the chain
    };

    void chooseLevels()
    {
        auto next = mChain.levels.begin();
        for (std::size_t i = 0; i < mConfig.levels.size(); ++i) {
            if (!mConfig.levels[i].isManual()) {
                const LodChainLevel& level = *next++;
                if (level.skipped)
                    continue;
                mGenerated.push_back(Generated{mPrepared.sources.size(), &level});
            }
            mPrepared.sources.push_back(i);
        }
    }

    void buildSubMesh(std::size_t number)
    {
        const Ogre::SubMesh& subMesh = *mMesh.getSubMesh(number);
        const int view = mData.subMeshOf()[number];
        const std::size_t perBuffer = mConfig.shareIndexBuffers ? 2 : 1;
        for (std::size_t first = 0; first < mGenerated.size(); first += perBuffer) {
            const std::size_t last = std::min(first + perBuffer, mGenerated.size());
            if (view >= 0)
                storeGenerated(number, static_cast<std::size_t>(view), first, last);
            else
                for (std::size_t i = first; i < last; ++i)
                    mPrepared.faces[mGenerated[i].level][number] = repeatLevelZero(mMesh, subMesh);
        }
        for (auto& faces : mPrepared.faces)
            if (!faces[number])
                faces[number] = makeIndexData({}, 0, 0);
    }

    void storeGenerated(std::size_t number, std::size_t view, std::size_t first, std::size_t last)
    {
        std::vector<const std::vector<std::uint32_t>*> lists;
        for (std::size_t i = first; i < last; ++i)
            lists.push_back(&mGenerated[i].triangles->indices[view]);
        std::vector<IndexDataPtr> stored = storeLists(mMesh, *mMesh.getSubMesh(number), lists);
        for (std::size_t i = first; i < last; ++i)
            mPrepared.faces[mGenerated[i].level][number] = std::move(stored[i - first]);
    }

    /// One operation type goes for all levels of a submesh, so that strips and fans have to go once there are lists.
    std::optional<Error> convertLevelZero(std::size_t number)
    {
        mPrepared.convertedLevelZero.push_back(nullptr);
        const Ogre::SubMesh& subMesh = *mMesh.getSubMesh(number);
        const int view = mData.subMeshOf()[number];
        if (view < 0 || mGenerated.empty() || subMesh.operationType == Ogre::RenderOperation::OT_TRIANGLE_LIST)
            return std::nullopt;
        const MeshView& read = mData.view();
        Blocks blocks;
        const Result<TriangleList> list = readTriangles(
            *subMesh.indexData, subMesh.operationType,
            read.vertexBuffers[read.subMeshes[static_cast<std::size_t>(view)].vertexBuffer].vertexCount, blocks);
        if (!list)
            return list.error();
        const SubMeshView triangles{0, list.value().indices, list.value().count, list.value().indexBytes};
        std::vector<std::uint32_t> indices(triangles.indexCount);
        for (std::size_t i = 0; i < indices.size(); ++i)
            indices[i] = triangles.index(i);
        mPrepared.convertedLevelZero.back() = std::move(storeLists(mMesh, subMesh, {&indices}).front());
        return std::nullopt;
    }

    const LodConfig& mConfig;
    Ogre::Mesh& mMesh;
    const MeshData& mData;
    const LodChain& mChain;
    std::vector<Generated> mGenerated;
    PreparedLevels mPrepared;
};

const Ogre::VertexData* verticesOf(const Ogre::Mesh& mesh, const Ogre::SubMesh& subMesh)
{
    return subMesh.useSharedVertices ? mesh.sharedVertexData : subMesh.vertexData;
}

/// Whether a submesh still is what was read: the levels index its vertices.
bool matches(const Ogre::Mesh& mesh, std::size_t number, const MeshData& data)
{
    const int view = data.subMeshOf()[number];
    if (view < 0)
        return true;
    const Ogre::SubMesh& subMesh = *mesh.getSubMesh(number);
    const Ogre::VertexData* vertices = verticesOf(mesh, subMesh);
    const SubMeshView& read = data.view().subMeshes[static_cast<std::size_t>(view)];
    return vertices && vertices->vertexCount == data.view().vertexBuffers[read.vertexBuffer].vertexCount
           && subMesh.indexData && subMesh.indexData->indexBuffer
           && subMesh.indexData->indexBuffer->getIndexSize() == static_cast<std::size_t>(read.indexBytes);
}

std::optional<Error> checkUnchanged(const Ogre::Mesh& mesh, const MeshData& data)
{
    const Error changed{ErrorCode::InvalidGeometry, "the mesh has changed since it was read"};
    if (mesh.getNumSubMeshes() != data.subMeshOf().size())
        return changed;
    for (std::size_t i = 0; i < mesh.getNumSubMeshes(); ++i)
        if (!matches(mesh, i, data))
            return changed;
    return std::nullopt;
}

void assertChainFits(const LodConfig& config, const MeshData& data, const LodChain& chain)
{
    const auto generated = std::count_if(config.levels.begin(), config.levels.end(),
                                         [](const LodLevel& level) { return !level.isManual(); });
    LODSMITH_ASSERT(chain.levels.size() == static_cast<std::size_t>(generated),
                    "the chain needs one level for each generated level of the configuration");
    const MeshView& view = data.view();
    for (const LodChainLevel& level : chain.levels) {
        if (level.skipped)
            continue;
        LODSMITH_ASSERT(level.indices.size() == view.subMeshes.size(), "the chain is not of this mesh");
        for (std::size_t i = 0; i < level.indices.size(); ++i) {
            std::uint32_t highest = 0;
            for (const std::uint32_t index : level.indices[i])
                highest = std::max(highest, index);
            LODSMITH_ASSERT(level.indices[i].size() % 3 == 0
                                && (level.indices[i].empty()
                                    || highest < view.vertexBuffers[view.subMeshes[i].vertexBuffer].vertexCount),
                            "the chain has indices that the mesh has no vertices for");
        }
    }
}

/// Frees the edge lists, which OGRE demands before any change to the levels. Files of format 1.3 and later turn building on
/// demand off, because they may bring the lists with them; a mesh that had some must get them back when asked.
void freeEdgeLists(Ogre::Mesh& mesh)
{
    if (!mesh.isEdgeListBuilt())
        return;
    mesh.freeEdgeList();
    mesh.setAutoBuildEdgeLists(true);
}

/// Keeps the object, which renderables may point to.
void replaceLevelZero(Ogre::SubMesh& subMesh, const Ogre::IndexData& list)
{
    subMesh.indexData->indexBuffer = list.indexBuffer;
    subMesh.indexData->indexStart = list.indexStart;
    subMesh.indexData->indexCount = list.indexCount;
    subMesh.operationType = Ogre::RenderOperation::OT_TRIANGLE_LIST;
}

/// OGRE makes the entities of hand-made levels anew, and tells them of the node only when the entity itself comes to one.
void initialiseAgain(Ogre::Entity& entity)
{
    entity._initialise(true);
    if (Ogre::Node* const node = entity.getParentNode()) {
        const bool isBone = entity.isParentTagPoint();
        entity._notifyAttached(nullptr);
        entity._notifyAttached(node, isBone);
    }
}

void attach(const LodConfig& config, const LodPlan& plan, PreparedLevels prepared)
{
    Ogre::Mesh& mesh = *config.mesh;
    freeEdgeLists(mesh);
    mesh.removeLodLevels();
    mesh.setLodStrategy(plan.strategy);
    mesh._setLodInfo(static_cast<Ogre::ushort>(prepared.sources.size() + 1));
    for (std::size_t i = 0; i < prepared.sources.size(); ++i) {
        const auto level = static_cast<Ogre::ushort>(i + 1);
        // Before the usage: OGRE refuses faces for a level that is known to be manual, but clones and saves need some.
        for (std::size_t subMesh = 0; subMesh < prepared.faces[i].size(); ++subMesh)
            mesh._setSubMeshLodFaceList(static_cast<Ogre::ushort>(subMesh), level,
                                        prepared.faces[i][subMesh].release());
        Ogre::MeshLodUsage usage;
        usage.userValue = config.levels[prepared.sources[i]].value;
        usage.value = plan.values[prepared.sources[i]];
        usage.manualName = config.levels[prepared.sources[i]].manualMeshName;
        usage.manualMesh = plan.manualMeshes[prepared.sources[i]];
        mesh._setLodUsage(level, usage);
    }
    for (std::size_t i = 0; i < prepared.convertedLevelZero.size(); ++i)
        if (prepared.convertedLevelZero[i])
            replaceLevelZero(*mesh.getSubMesh(i), *prepared.convertedLevelZero[i]);
    // Entities hold one entity a level as soon as the mesh has, or ever had, a manual one. One that is not initialised may be
    // about to be, having loaded the mesh for that.
    if (config.reinitialiseEntities && mesh.hasManualLodLevel())
        for (Ogre::Entity* entity : livingEntities(mesh))
            if (entity->isInitialised())
                initialiseAgain(*entity);
}

} // namespace

Result<Done> MeshWriter::write(const LodConfig& config, const MeshData& data, const LodChain& chain)
{
    assertMainThread();
    LODSMITH_ASSERT(config.mesh, "MeshWriter::write() needs a mesh");
    assertChainFits(config, data, chain);
    return guarded(config.mesh->getName(), [&]() -> Result<Done> {
        const Result<LodPlan> plan = planLods(config);
        if (!plan)
            return plan.error();
        if (auto error = checkUnchanged(*config.mesh, data))
            return *error;
        Result<PreparedLevels> levels = LevelBuilder(config, data, chain).build();
        if (!levels)
            return levels.error();
        attach(config, plan.value(), std::move(levels).value());
        return Done{};
    });
}

void MeshWriter::removeLevels(Ogre::Mesh& mesh)
{
    assertMainThread();
    freeEdgeLists(mesh);
    mesh.removeLodLevels();
}

} // namespace lodsmith
