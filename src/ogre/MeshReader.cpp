#include <lodsmith/ogre/MeshReader.h>

#include "IndexReader.h"
#include "MainThread.h"
#include "OgreGuard.h"
#include "PoseReader.h"
#include "VertexReader.h"

#include <lodsmith/core/Assert.h>

#include <OgreSubMesh.h>

#include <algorithm>

namespace lodsmith {

namespace {

/// Finds out which vertices a submesh draws; null when it has none.
VertexSource vertexSourceOf(const Ogre::Mesh& mesh, std::size_t subMeshNumber)
{
    const Ogre::SubMesh& subMesh = *mesh.getSubMesh(subMeshNumber);
    if (subMesh.useSharedVertices)
        return VertexSource{mesh.sharedVertexData, &mesh.getBoneAssignments(), 0};
    return VertexSource{subMesh.vertexData, &subMesh.getBoneAssignments(),
                        static_cast<unsigned short>(subMeshNumber + 1)};
}

/// Gathers the parts of one mesh.
class Reading {
public:
    Reading(const Ogre::Mesh& mesh, MeshView& view, Blocks& blocks, std::vector<std::string>& notes)
        : mMesh(mesh), mView(view), mBlocks(blocks), mNotes(notes)
    {
    }

    /// The number of the submesh's view, -1 when it is left alone.
    Result<int> readSubMesh(std::size_t number)
    {
        const Ogre::SubMesh& subMesh = *mMesh.getSubMesh(number);
        const std::string reason = reasonToLeaveAlone(subMesh);
        if (!reason.empty()) {
            mNotes.push_back(place(number) + reason + ", left as it is");
            return -1;
        }
        const Result<std::uint32_t> buffer = vertexBufferOf(number);
        if (!buffer)
            return buffer.error();
        const Result<TriangleList> list = readTriangles(*subMesh.indexData, subMesh.operationType,
                                                        mView.vertexBuffers[buffer.value()].vertexCount, mBlocks);
        if (!list)
            return list.error();
        noteConversion(number);
        const TriangleList& triangles = list.value();
        mView.subMeshes.push_back(
            SubMeshView{buffer.value(), triangles.indices, triangles.count, triangles.indexBytes});
        return static_cast<int>(mView.subMeshes.size()) - 1;
    }

    const OffsetMoments& offsets() const { return mOffsets; }

private:
    static std::string place(std::size_t number) { return "submesh " + std::to_string(number) + ": "; }

    void noteConversion(std::size_t number)
    {
        const Ogre::SubMesh& subMesh = *mMesh.getSubMesh(number);
        if (subMesh.operationType == Ogre::RenderOperation::OT_TRIANGLE_STRIP)
            mNotes.push_back(place(number) + "a triangle strip, read as a list");
        else if (subMesh.operationType == Ogre::RenderOperation::OT_TRIANGLE_FAN)
            mNotes.push_back(place(number) + "a triangle fan, read as a list");
        else if (subMesh.indexData->indexCount % 3 != 0)
            mNotes.push_back(place(number) + "the last indices make no whole triangle and were ignored");
    }

    /// The number of the view of the submesh's vertices, which are read when they are met for the first time.
    Result<std::uint32_t> vertexBufferOf(std::size_t number)
    {
        const VertexSource source = vertexSourceOf(mMesh, number);
        if (!source.vertices)
            return Error{ErrorCode::InvalidGeometry, "the submesh has indices but no vertices"};
        if (source.handle == 0 && mShared >= 0)
            return static_cast<std::uint32_t>(mShared);
        const std::size_t firstNote = mNotes.size();
        Result<ReadVertices> vertices = readVertices(mMesh, source, mBlocks, mNotes);
        if (!vertices)
            return vertices.error();
        for (std::size_t i = firstNote; i < mNotes.size(); ++i)
            mNotes[i] = (source.handle == 0 ? std::string("shared vertices: ") : place(number)) + mNotes[i];
        mView.vertexBuffers.push_back(std::move(vertices.value().view));
        mOffsets.push_back(std::move(vertices.value().offsets));
        const auto last = static_cast<std::uint32_t>(mView.vertexBuffers.size()) - 1;
        if (source.handle == 0)
            mShared = static_cast<int>(last);
        return last;
    }

    const Ogre::Mesh& mMesh;
    MeshView& mView;
    Blocks& mBlocks;
    std::vector<std::string>& mNotes;
    OffsetMoments mOffsets;
    int mShared = -1;
};

void raiseImportance(const SubMeshView& subMesh, float importance, float* ofVertex)
{
    for (std::uint32_t i = 0; i < subMesh.indexCount; ++i) {
        float& raised = ofVertex[subMesh.index(i)];
        raised = std::max(raised, importance);
    }
}

/// Gives vertex buffers that an important submesh uses a stream of importance.
void addImportance(const std::vector<float>& ofSubMesh, const std::vector<int>& viewOf, MeshView& view, Blocks& blocks)
{
    std::vector<float*> streams(view.vertexBuffers.size(), nullptr);
    for (std::size_t i = 0; i < std::min(ofSubMesh.size(), viewOf.size()); ++i) {
        if (viewOf[i] < 0 || ofSubMesh[i] == 0.0f)
            continue;
        const SubMeshView& subMesh = view.subMeshes[static_cast<std::size_t>(viewOf[i])];
        VertexBufferView& buffer = view.vertexBuffers[subMesh.vertexBuffer];
        float*& stream = streams[subMesh.vertexBuffer];
        if (!stream) {
            stream = addBlock<float>(blocks, buffer.vertexCount);
            std::fill_n(stream, buffer.vertexCount, 0.0f);
            buffer.importance = FloatStream{stream, sizeof(float)};
        }
        raiseImportance(subMesh, ofSubMesh[i], stream);
    }
}

} // namespace

void MeshData::releaseArrays()
{
    mBlocks.clear();
    for (VertexBufferView& buffer : mView.vertexBuffers) {
        const std::uint32_t count = buffer.vertexCount;
        buffer = {};
        buffer.vertexCount = count;
    }
    for (SubMeshView& subMesh : mView.subMeshes)
        subMesh.indices = nullptr;
}

Result<MeshData> MeshReader::read(const Ogre::Mesh& mesh, const std::vector<float>& subMeshImportance,
                                  const std::vector<PoseMoment>* poses)
{
    assertMainThread();
    LODSMITH_ASSERT(std::all_of(subMeshImportance.begin(), subMeshImportance.end(),
                                [](float importance) { return importance >= 0.0f && importance <= 1.0f; }),
                    "the importance of a submesh is from 0 to 1");
    return guarded(mesh.getName(), [&]() -> Result<MeshData> {
        if (mesh.getNumSubMeshes() == 0)
            return Error{ErrorCode::Unsupported, "the mesh has no submeshes (is it loaded?)"};
        MeshData data;
        Reading reading(mesh, data.mView, data.mBlocks, data.mNotes);
        for (std::size_t i = 0; i < mesh.getNumSubMeshes(); ++i) {
            const Result<int> view = reading.readSubMesh(i);
            if (!view) {
                Error error = view.error();
                error.subMesh = static_cast<int>(i);
                return error;
            }
            data.mSubMeshOf.push_back(view.value());
        }
        data.mPoses = readPoses(mesh, reading.offsets(), poses, data.mView, data.mBlocks, data.mNotes);
        addImportance(subMeshImportance, data.mSubMeshOf, data.mView, data.mBlocks);
        return data;
    });
}

} // namespace lodsmith
