#include "OgreMeshBuilder.h"

#include <OgreHardwareBufferManager.h>
#include <OgreLodStrategy.h>
#include <OgreMeshManager.h>
#include <OgrePose.h>
#include <OgreSubMesh.h>

#include <algorithm>
#include <cmath>

namespace lodsmith::test {

namespace {

/// Adds a stream of `components` floats a vertex to a declaration and to the interleaved floats of a buffer.
struct Interleaver {
    Ogre::VertexDeclaration& declaration;
    std::vector<std::pair<const std::vector<float>*, std::size_t>> streams;
    std::size_t floats = 0;

    void add(Ogre::VertexElementSemantic semantic, Ogre::VertexElementType type, const std::vector<float>& stream,
             unsigned short index = 0)
    {
        if (stream.empty())
            return;
        const std::size_t components = Ogre::VertexElement::getTypeCount(type);
        declaration.addElement(0, floats * sizeof(float), type, semantic, index);
        streams.emplace_back(&stream, components);
        floats += components;
    }

    std::vector<float> interleave(std::size_t vertexCount) const
    {
        std::vector<float> all;
        for (std::size_t vertex = 0; vertex < vertexCount; ++vertex)
            for (const auto& [stream, components] : streams)
                all.insert(all.end(), stream->begin() + static_cast<std::ptrdiff_t>(vertex * components),
                           stream->begin() + static_cast<std::ptrdiff_t>((vertex + 1) * components));
        return all;
    }
};

Ogre::VertexData* makeVertexData(const TestBuffer& buffer)
{
    auto* data = OGRE_NEW Ogre::VertexData();
    data->vertexCount = buffer.vertexCount();
    Interleaver interleaver{*data->vertexDeclaration, {}, 0};
    interleaver.add(Ogre::VES_POSITION, Ogre::VET_FLOAT3, buffer.positions);
    interleaver.add(Ogre::VES_NORMAL, Ogre::VET_FLOAT3, buffer.normals);
    for (std::size_t set = 0; set < buffer.uvSets.size(); ++set)
        interleaver.add(Ogre::VES_TEXTURE_COORDINATES, Ogre::VET_FLOAT2, buffer.uvSets[set],
                        static_cast<unsigned short>(set));
    interleaver.add(Ogre::VES_COLOUR, Ogre::VET_FLOAT4, buffer.colours);
    const std::vector<float> floats = interleaver.interleave(data->vertexCount);
    auto vertices = Ogre::HardwareBufferManager::getSingleton().createVertexBuffer(
        interleaver.floats * sizeof(float), data->vertexCount, Ogre::HardwareBuffer::HBU_STATIC_WRITE_ONLY);
    vertices->writeData(0, floats.size() * sizeof(float), floats.data());
    data->vertexBufferBinding->setBinding(0, vertices);
    return data;
}

template <class Owner>
void addBones(Owner& owner, const TestBuffer& buffer)
{
    for (std::size_t vertex = 0; vertex < buffer.bones.size(); ++vertex)
        for (int i = 0; i < 4; ++i)
            if (buffer.bones[vertex].weight[i] > 0.0f)
                owner.addBoneAssignment(
                    {static_cast<unsigned>(vertex), buffer.bones[vertex].bone[i], buffer.bones[vertex].weight[i]});
}

void addPoses(Ogre::Mesh& mesh, const TestBuffer& buffer, unsigned short target)
{
    for (const std::vector<float>& offsets : buffer.offsets) {
        Ogre::Pose* pose = mesh.createPose(target);
        for (std::size_t vertex = 0; vertex < offsets.size() / 3; ++vertex) {
            const Ogre::Vector3 offset(&offsets[3 * vertex]);
            if (offset != Ogre::Vector3::ZERO)
                pose->addVertex(vertex, offset);
        }
    }
}

void setBounds(Ogre::Mesh& mesh, const TestMesh& from)
{
    Ogre::AxisAlignedBox box;
    Ogre::Real radius = 0;
    for (const TestBuffer& buffer : from.buffers) {
        for (std::size_t i = 0; i + 2 < buffer.positions.size(); i += 3) {
            const Ogre::Vector3 point(&buffer.positions[i]);
            box.merge(point);
            radius = std::max(radius, point.length());
        }
    }
    mesh._setBounds(box);
    mesh._setBoundingSphereRadius(radius);
}

std::string levelName(std::size_t subMesh, std::size_t level)
{
    return "submesh " + std::to_string(subMesh) + ", level " + std::to_string(level) + ": ";
}

bool wholeTriangles(const std::vector<std::uint32_t>& indices)
{
    if (indices.size() % 3 != 0 || indices.empty())
        return false;
    if (indices.size() == 3 && indices[0] == indices[1] && indices[1] == indices[2])
        return true;
    for (std::size_t i = 0; i < indices.size(); i += 3)
        if (indices[i] == indices[i + 1] || indices[i + 1] == indices[i + 2] || indices[i + 2] == indices[i])
            return false;
    return true;
}

void checkFaces(const Ogre::Mesh& mesh, std::size_t number, std::size_t level, std::vector<std::string>& broken)
{
    const Ogre::SubMesh& subMesh = *mesh.getSubMesh(number);
    const Ogre::IndexData& whole = *subMesh.indexData;
    const Ogre::IndexData& faces = *subMesh.mLodFaceList[level - 1];
    const std::string place = levelName(number, level);
    if (!faces.indexBuffer) {
        broken.push_back(place + "no index buffer");
        return;
    }
    if (faces.indexStart + faces.indexCount > faces.indexBuffer->getNumIndexes()) {
        broken.push_back(place + "draws beyond its index buffer");
        return;
    }
    if (whole.indexBuffer
        && (faces.indexBuffer->getType() != whole.indexBuffer->getType()
            || faces.indexBuffer->getUsage() != whole.indexBuffer->getUsage()
            || faces.indexBuffer->hasShadowBuffer() != whole.indexBuffer->hasShadowBuffer()))
        broken.push_back(place + "another kind of index buffer than level 0");
    const std::vector<std::uint32_t> indices = indicesOf(faces);
    const std::size_t vertexCount =
        (subMesh.useSharedVertices ? mesh.sharedVertexData : subMesh.vertexData)->vertexCount;
    if (std::any_of(indices.begin(), indices.end(), [&](std::uint32_t index) { return index >= vertexCount; }))
        broken.push_back(place + "an index without a vertex");
    if (subMesh.operationType == Ogre::RenderOperation::OT_TRIANGLE_LIST && whole.indexCount > 0
        && !wholeTriangles(indices))
        broken.push_back(place + "not made of whole triangles");
}

} // namespace

Ogre::MeshPtr makeOgreMesh(const std::string& name, const TestMesh& from, const OgreMeshOptions& options)
{
    Ogre::MeshPtr mesh =
        Ogre::MeshManager::getSingleton().createManual(name, Ogre::ResourceGroupManager::DEFAULT_RESOURCE_GROUP_NAME);
    if (options.shared) {
        mesh->sharedVertexData = makeVertexData(from.buffers[0]);
        addBones(*mesh, from.buffers[0]);
        addPoses(*mesh, from.buffers[0], 0);
    }
    for (std::size_t i = 0; i < from.subMeshes.size(); ++i) {
        Ogre::SubMesh* subMesh = mesh->createSubMesh();
        subMesh->useSharedVertices = options.shared;
        if (!options.shared) {
            const TestBuffer& buffer = from.buffers[from.subMeshes[i].vertexBuffer];
            subMesh->vertexData = makeVertexData(buffer);
            addBones(*subMesh, buffer);
            addPoses(*mesh, buffer, static_cast<unsigned short>(i + 1));
        }
        setIndices(*subMesh, from.subMeshes[i].indices, Ogre::RenderOperation::OT_TRIANGLE_LIST, options.wideIndices);
    }
    setBounds(*mesh, from);
    mesh->load();
    return mesh;
}

Ogre::IndexData* makeIndexData(const std::vector<std::uint32_t>& indices, bool wide, std::size_t before)
{
    auto* data = OGRE_NEW Ogre::IndexData();
    data->indexStart = before;
    data->indexCount = indices.size();
    if (indices.empty())
        return data;
    std::vector<std::uint32_t> all(before, 0);
    all.insert(all.end(), indices.begin(), indices.end());
    data->indexBuffer = Ogre::HardwareBufferManager::getSingleton().createIndexBuffer(
        wide ? Ogre::HardwareIndexBuffer::IT_32BIT : Ogre::HardwareIndexBuffer::IT_16BIT, all.size(),
        Ogre::HardwareBuffer::HBU_STATIC_WRITE_ONLY);
    const std::vector<std::uint16_t> narrow(all.begin(), all.end());
    data->indexBuffer->writeData(0, data->indexBuffer->getSizeInBytes(),
                                 wide ? static_cast<const void*>(all.data()) : narrow.data());
    return data;
}

void setIndices(Ogre::SubMesh& subMesh, const std::vector<std::uint32_t>& indices,
                Ogre::RenderOperation::OperationType type, bool wide, std::size_t before)
{
    OGRE_DELETE subMesh.indexData;
    subMesh.indexData = makeIndexData(indices, wide, before);
    subMesh.operationType = type;
}

std::vector<std::uint32_t> indicesOf(const Ogre::IndexData& data)
{
    std::vector<std::uint32_t> indices(data.indexCount);
    if (indices.empty())
        return indices;
    const Ogre::HardwareBufferLockGuard lock(data.indexBuffer, Ogre::HardwareBuffer::HBL_READ_ONLY);
    for (std::size_t i = 0; i < indices.size(); ++i)
        indices[i] = data.indexBuffer->getType() == Ogre::HardwareIndexBuffer::IT_16BIT
                         ? static_cast<const std::uint16_t*>(lock.pData)[data.indexStart + i]
                         : static_cast<const std::uint32_t*>(lock.pData)[data.indexStart + i];
    return indices;
}

LodChain shortenedChain(const MeshView& mesh, const std::vector<double>& shares)
{
    LodChain chain;
    for (const double share : shares) {
        LodChainLevel level;
        for (const SubMeshView& subMesh : mesh.subMeshes) {
            const auto triangles = static_cast<std::size_t>(std::floor(share * (subMesh.indexCount / 3)));
            level.indices.emplace_back();
            for (std::size_t i = 0; i < 3 * triangles; ++i)
                level.indices.back().push_back(subMesh.index(i));
            level.triangles += static_cast<std::uint32_t>(triangles);
        }
        chain.levels.push_back(std::move(level));
    }
    return chain;
}

LodConfig proportional(const Ogre::MeshPtr& mesh, const std::vector<double>& removed)
{
    LodConfig config;
    config.mesh = mesh;
    for (std::size_t i = 0; i < removed.size(); ++i)
        config.levels.push_back(
            {static_cast<Ogre::Real>(10 * (i + 1)), {LevelTarget::Kind::Proportional, removed[i]}, {}});
    return config;
}

void setHandMadeLevels(Ogre::Mesh& mesh, const std::vector<std::string>& names)
{
    mesh._setLodInfo(static_cast<unsigned short>(names.size() + 1));
    for (std::size_t i = 0; i < names.size(); ++i) {
        Ogre::MeshLodUsage usage;
        usage.userValue = static_cast<Ogre::Real>(10 * (i + 1));
        usage.value = mesh.getLodStrategy()->transformUserValue(usage.userValue);
        usage.manualName = names[i];
        mesh._setLodUsage(static_cast<unsigned short>(i + 1), usage);
    }
}

void setHandMadeLevel(Ogre::Mesh& mesh, const std::string& name)
{
    setHandMadeLevels(mesh, {name});
}

std::vector<std::string> brokenLevels(const Ogre::Mesh& mesh)
{
    std::vector<std::string> broken;
    const std::size_t levels = mesh.getNumLodLevels();
    for (std::size_t number = 0; number < mesh.getNumSubMeshes(); ++number) {
        const auto& lists = mesh.getSubMesh(number)->mLodFaceList;
        if (lists.size() != levels - 1) {
            broken.push_back("submesh " + std::to_string(number) + ": " + std::to_string(lists.size()) + " lists for "
                             + std::to_string(levels) + " levels");
            continue;
        }
        for (std::size_t level = 1; level < levels; ++level) {
            if (!lists[level - 1])
                broken.push_back(levelName(number, level) + "no index data");
            else if (!mesh._isManualLodLevel(static_cast<unsigned short>(level)))
                checkFaces(mesh, number, level, broken);
        }
    }
    const Ogre::LodStrategy& strategy = *mesh.getLodStrategy();
    if (mesh.getLodLevel(0).value != strategy.getBaseValue())
        broken.emplace_back("level 0 has another value than the strategy's base");
    Ogre::Mesh::LodValueList values;
    for (std::size_t level = 0; level < levels; ++level)
        values.push_back(mesh.getLodLevel(static_cast<unsigned short>(level)).value);
    if (!strategy.isSorted(values))
        broken.emplace_back("the values are not in order");
    return broken;
}

} // namespace lodsmith::test
