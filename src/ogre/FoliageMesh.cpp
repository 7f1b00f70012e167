#include <lodsmith/ogre/FoliageMesh.h>

#include "LivingEntities.h"
#include "MainThread.h"
#include "OgreGuard.h"

#include <lodsmith/core/Assert.h>
#include <lodsmith/ogre/MeshWriter.h>

#include <OgreAnimation.h>
#include <OgreAnimationTrack.h>
#include <OgreHardwareBufferManager.h>
#include <OgreKeyFrame.h>
#include <OgreMeshManager.h>
#include <OgrePose.h>
#include <OgreSubMesh.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <utility>
#include <vector>

namespace lodsmith {

namespace {

constexpr std::uint32_t kGone = 0xffffffffu;

/// One set of vertices of a clone, on its way from those of the original to those that the level uses.
struct VertexSet {
    Ogre::VertexData* vertices = nullptr;
    unsigned short handle = 0; ///< as poses and animations name it: 0 for the shared ones, else submesh number + 1
    std::uint32_t view = 0;    ///< number of its VertexBufferView
    std::vector<std::uint32_t> kept;     ///< vertices of the view, rising
    std::vector<std::uint32_t> numberOf; ///< by vertex of the view: its place in `kept`, or kGone
};

using BufferPtr = Ogre::HardwareVertexBufferSharedPtr;

/// The kept vertices of a buffer, in a buffer like it.
BufferPtr gather(Ogre::Mesh& mesh, const BufferPtr& from, std::size_t start, const std::vector<std::uint32_t>& kept)
{
    const std::size_t size = from->getVertexSize();
    const BufferPtr to = mesh.getHardwareBufferManager()->createVertexBuffer(size, kept.size(), from->getUsage(),
                                                                             from->hasShadowBuffer());
    const Ogre::HardwareBufferLockGuard read(from, Ogre::HardwareBuffer::HBL_READ_ONLY);
    const Ogre::HardwareBufferLockGuard write(to, Ogre::HardwareBuffer::HBL_DISCARD);
    for (std::size_t i = 0; i < kept.size(); ++i)
        std::memcpy(static_cast<unsigned char*>(write.pData) + i * size,
                    static_cast<const unsigned char*>(read.pData) + (start + kept[i]) * size, size);
    return to;
}

/// Writes three floats into each vertex of a buffer; value(i, axis) is that of the i-th.
template <class Value>
void writeVectors(const BufferPtr& buffer, std::size_t offset, Value&& value)
{
    const Ogre::HardwareBufferLockGuard lock(buffer, Ogre::HardwareBuffer::HBL_NORMAL);
    for (std::size_t i = 0; i < buffer->getNumVertices(); ++i) {
        const float vector[3] = {value(i, 0), value(i, 1), value(i, 2)};
        std::memcpy(static_cast<unsigned char*>(lock.pData) + i * buffer->getVertexSize() + offset, vector,
                    sizeof vector);
    }
}

/// Makes the clone of a mesh the level.
class LevelShaper {
public:
    LevelShaper(Ogre::Mesh& clone, const MeshData& data, const FoliageLevel& level)
        : mMesh(clone), mData(data), mLevel(level)
    {
    }

    Result<Done> shape()
    {
        for (std::size_t i = 0; i < mMesh.getNumSubMeshes(); ++i)
            if (mData.subMeshOf()[i] >= 0)
                useVertices(i);
        for (auto& [vertices, set] : mSets) {
            finish(set);
            if (auto moved = shapeVertices(set); !moved)
                return moved;
            shapePoses(set);
            shapeMorphs(set);
        }
        for (std::size_t i = 0; i < mMesh.getNumSubMeshes(); ++i)
            if (mData.subMeshOf()[i] >= 0)
                shapeSubMesh(i);
        widenBounds();
        return Done{};
    }

private:
    Ogre::VertexData* verticesOf(std::size_t subMesh)
    {
        Ogre::SubMesh* const of = mMesh.getSubMesh(subMesh);
        return of->useSharedVertices ? mMesh.sharedVertexData : of->vertexData;
    }

    const std::vector<std::uint32_t>& indicesOf(std::size_t subMesh) const
    {
        return mLevel.indices[static_cast<std::size_t>(mData.subMeshOf()[subMesh])];
    }

    void useVertices(std::size_t subMesh)
    {
        VertexSet& set = mSets[verticesOf(subMesh)];
        set.vertices = verticesOf(subMesh);
        set.handle = static_cast<unsigned short>(mMesh.getSubMesh(subMesh)->useSharedVertices ? 0 : subMesh + 1);
        set.view = mData.view().subMeshes[static_cast<std::size_t>(mData.subMeshOf()[subMesh])].vertexBuffer;
        set.kept.insert(set.kept.end(), indicesOf(subMesh).begin(), indicesOf(subMesh).end());
    }

    /// Submeshes that were left alone go on with the vertices as they are.
    bool isUsedOtherwise(const VertexSet& set)
    {
        for (std::size_t i = 0; i < mMesh.getNumSubMeshes(); ++i)
            if (mData.subMeshOf()[i] < 0 && verticesOf(i) == set.vertices)
                return true;
        return false;
    }

    void finish(VertexSet& set)
    {
        const std::uint32_t count = mData.view().vertexBuffers[set.view].vertexCount;
        if (set.kept.empty())
            set.kept.push_back(0); // render systems have no empty buffers
        if (isUsedOtherwise(set))
            for (std::uint32_t i = 0; i < count; ++i)
                set.kept.push_back(i);
        std::sort(set.kept.begin(), set.kept.end());
        set.kept.erase(std::unique(set.kept.begin(), set.kept.end()), set.kept.end());
        set.numberOf.assign(count, kGone);
        for (std::size_t i = 0; i < set.kept.size(); ++i)
            set.numberOf[set.kept[i]] = static_cast<std::uint32_t>(i);
    }

    Result<Done> shapeVertices(const VertexSet& set)
    {
        Ogre::VertexData& vertices = *set.vertices;
        const Ogre::VertexElement* position = vertices.vertexDeclaration->findElementBySemantic(Ogre::VES_POSITION);
        if (position->getType() != Ogre::VET_FLOAT3)
            return Error{ErrorCode::Unsupported, "positions of another type than three floats cannot be moved"};
        const auto bindings = vertices.vertexBufferBinding->getBindings();
        for (const auto& [source, buffer] : bindings)
            vertices.vertexBufferBinding->setBinding(source, gather(mMesh, buffer, vertices.vertexStart, set.kept));
        const std::vector<float>& places = mLevel.positions[set.view];
        writeVectors(vertices.vertexBufferBinding->getBuffer(position->getSource()), position->getOffset(),
                     [&](std::size_t i, std::size_t axis) { return places[3 * std::size_t(set.kept[i]) + axis]; });
        shapeBones(set);
        mOldStart[set.vertices] = vertices.vertexStart;
        vertices.vertexStart = 0;
        vertices.vertexCount = set.kept.size();
        return Done{};
    }

    void shapeBones(const VertexSet& set)
    {
        Ogre::SubMesh* const subMesh = set.handle == 0 ? nullptr : mMesh.getSubMesh(set.handle - 1u);
        const auto assignments = subMesh ? subMesh->getBoneAssignments() : mMesh.getBoneAssignments();
        subMesh ? subMesh->clearBoneAssignments() : mMesh.clearBoneAssignments();
        for (const auto& [key, assignment] : assignments) {
            const std::size_t vertex = assignment.vertexIndex - set.vertices->vertexStart;
            if (vertex >= set.numberOf.size() || set.numberOf[vertex] == kGone)
                continue;
            Ogre::VertexBoneAssignment moved = assignment;
            moved.vertexIndex = set.numberOf[vertex];
            subMesh ? subMesh->addBoneAssignment(moved) : mMesh.addBoneAssignment(moved);
        }
    }

    /// Poses come first among the offsets, each that has any; see MeshReader.
    void shapePoses(const VertexSet& set)
    {
        const auto& offsets = mLevel.offsets[set.view];
        std::size_t next = 0;
        for (Ogre::Pose* pose : mMesh.getPoseList()) {
            if (pose->getTarget() != set.handle || pose->getVertexOffsets().empty())
                continue;
            const std::vector<float>& moved = offsets[next++];
            const Ogre::Pose::NormalsMap normals = pose->getNormals();
            pose->clearVertices();
            for (std::size_t i = 0; i < set.kept.size(); ++i) {
                const float* offset = &moved[3 * std::size_t(set.kept[i])];
                const auto normal = normals.find(mOldStart[set.vertices] + set.kept[i]);
                if (offset[0] == 0.0f && offset[1] == 0.0f && offset[2] == 0.0f && normal == normals.end())
                    continue;
                const Ogre::Vector3 vector(offset[0], offset[1], offset[2]);
                if (normals.empty())
                    pose->addVertex(i, vector);
                else
                    pose->addVertex(i, vector, normal == normals.end() ? Ogre::Vector3::ZERO : normal->second);
            }
        }
        mFirstMorph[set.vertices] = next;
    }

    /// Morph frames follow, each that moves anything.
    void shapeMorphs(const VertexSet& set)
    {
        std::size_t next = mFirstMorph[set.vertices];
        for (unsigned short i = 0; i < mMesh.getNumAnimations(); ++i)
            for (const auto& [handle, track] : mMesh.getAnimation(i)->_getVertexTrackList()) {
                if (handle != set.handle || track->getAnimationType() != Ogre::VAT_MORPH)
                    continue;
                for (unsigned short frame = 0; frame < track->getNumKeyFrames(); ++frame)
                    shapeFrame(set, *track->getVertexMorphKeyFrame(frame), next);
            }
    }

    void shapeFrame(const VertexSet& set, Ogre::VertexMorphKeyFrame& frame, std::size_t& next)
    {
        const bool moves = !isAtRest(set, frame.getVertexBuffer());
        const BufferPtr buffer = gather(mMesh, frame.getVertexBuffer(), 0, set.kept);
        const std::vector<float>& places = mLevel.positions[set.view];
        const std::vector<float>* offsets = moves ? &mLevel.offsets[set.view][next++] : nullptr;
        writeVectors(buffer, 0, [&](std::size_t i, std::size_t axis) {
            const std::size_t at = 3 * std::size_t(set.kept[i]) + axis;
            return offsets ? places[at] + (*offsets)[at] : places[at];
        });
        frame.setVertexBuffer(buffer);
    }

    bool isAtRest(const VertexSet& set, const BufferPtr& frame) const
    {
        const VertexBufferView& view = mData.view().vertexBuffers[set.view];
        const Ogre::HardwareBufferLockGuard lock(frame, Ogre::HardwareBuffer::HBL_READ_ONLY);
        for (std::uint32_t i = 0; i < view.vertexCount; ++i) {
            float rest[3];
            view.positions.read(i, 3, rest);
            if (std::memcmp(static_cast<const unsigned char*>(lock.pData) + i * frame->getVertexSize(), rest,
                            sizeof rest)
                != 0)
                return false;
        }
        return true;
    }

    /// A list at the width of the original's indices. Render systems crash over empty ones, hence a triangle without
    /// area.
    void shapeSubMesh(std::size_t number)
    {
        Ogre::SubMesh& subMesh = *mMesh.getSubMesh(number);
        const VertexSet& set = mSets.at(verticesOf(number));
        std::vector<std::uint32_t> indices;
        for (const std::uint32_t vertex : indicesOf(number))
            indices.push_back(set.numberOf[vertex]);
        if (indices.empty())
            indices = {0, 0, 0};
        const auto& model = subMesh.indexData->indexBuffer;
        const auto buffer = mMesh.getHardwareBufferManager()->createIndexBuffer(
            model->getType(), indices.size(), model->getUsage(), model->hasShadowBuffer());
        const Ogre::HardwareBufferLockGuard lock(buffer, Ogre::HardwareBuffer::HBL_DISCARD);
        if (model->getType() == Ogre::HardwareIndexBuffer::IT_16BIT)
            std::transform(indices.begin(), indices.end(), static_cast<std::uint16_t*>(lock.pData),
                           [](std::uint32_t index) { return static_cast<std::uint16_t>(index); });
        else
            std::memcpy(lock.pData, indices.data(), 4 * indices.size());
        subMesh.indexData->indexBuffer = buffer;
        subMesh.indexData->indexStart = 0;
        subMesh.indexData->indexCount = indices.size();
        subMesh.operationType = Ogre::RenderOperation::OT_TRIANGLE_LIST;
    }

    void widenBounds()
    {
        Ogre::AxisAlignedBox bounds = mMesh.getBounds();
        Ogre::Real radius = mMesh.getBoundingSphereRadius();
        for (const auto& [vertices, set] : mSets)
            for (const std::uint32_t vertex : set.kept) {
                const float* place = &mLevel.positions[set.view][3 * std::size_t(vertex)];
                const Ogre::Vector3 point(place[0], place[1], place[2]);
                bounds.merge(point);
                radius = std::max(radius, point.length());
            }
        mMesh._setBounds(bounds, false);
        mMesh._setBoundingSphereRadius(radius);
    }

    Ogre::Mesh& mMesh;
    const MeshData& mData;
    const FoliageLevel& mLevel;
    std::map<const Ogre::VertexData*, VertexSet> mSets; // each is shaped on its own, in whatever order
    std::map<const Ogre::VertexData*, std::size_t> mOldStart;
    std::map<const Ogre::VertexData*, std::size_t> mFirstMorph;
};

} // namespace

Result<Ogre::MeshPtr> makeFoliageMesh(Ogre::Mesh& mesh, const MeshData& data, const FoliageLevel& level,
                                      const Ogre::String& name)
{
    assertMainThread();
    LODSMITH_ASSERT(level.made, "makeFoliageMesh() needs a level that was made");
    return guarded(name, [&]() -> Result<Ogre::MeshPtr> {
        auto& meshes = Ogre::MeshManager::getSingleton();
        if (meshes.getByName(name, mesh.getGroup()))
            return Error{ErrorCode::InvalidSetting, "there is a mesh of this name"};
        const Ogre::MeshPtr clone = mesh.clone(name, mesh.getGroup());
        MeshWriter::removeLevels(*clone);
        const Result<Done> shaped = LevelShaper(*clone, data, level).shape();
        if (!shaped) {
            meshes.remove(clone);
            return shaped.error();
        }
        return clone;
    });
}

Result<Done> replaceLevel(Ogre::Mesh& mesh, unsigned level, const Ogre::MeshPtr& handMade)
{
    assertMainThread();
    LODSMITH_ASSERT(handMade, "replaceLevel() needs a mesh");
    return guarded(mesh.getName(), [&]() -> Result<Done> {
        if (level == 0 || level >= mesh.getNumLodLevels())
            return Error{ErrorCode::InvalidSetting, "the mesh has no level " + std::to_string(level)};
        if (handMade.get() == &mesh)
            return Error{ErrorCode::InvalidSetting, "a mesh is no level of itself"};
        if (!livingEntities(mesh).empty())
            return Error{ErrorCode::Unsupported, "the mesh has living entities"};
        // Clones and saves need index data there all the same.
        for (Ogre::SubMesh* subMesh : mesh.getSubMeshes()) {
            OGRE_DELETE subMesh->mLodFaceList[level - 1];
            subMesh->mLodFaceList[level - 1] = OGRE_NEW Ogre::IndexData();
        }
        Ogre::MeshLodUsage usage = mesh.getLodLevel(static_cast<Ogre::ushort>(level));
        usage.manualName = handMade->getName();
        usage.manualMesh = handMade;
        mesh._setLodUsage(static_cast<Ogre::ushort>(level), usage);
        return Done{};
    });
}

} // namespace lodsmith
