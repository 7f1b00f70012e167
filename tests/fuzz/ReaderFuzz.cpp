// libFuzzer target for the OGRE adapter: a mesh is built in memory from any bytes, with any vertex declaration and any index
// data, then read, simplified and given its levels. It has to end in a named error or in levels that OGRE can draw.

#include "support/MeshFromBytes.h"
#include "support/OgreMeshBuilder.h"
#include "support/OgreSession.h"

#include <lodsmith/ogre/ProgressiveMeshGenerator.h>

#include <OgreHardwareBufferManager.h>
#include <OgreMeshManager.h>
#include <OgreSubMesh.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <string>
#include <vector>

namespace {

using namespace lodsmith;
using test::ByteSource;

constexpr Ogre::VertexElementSemantic kSemantics[] = {
    Ogre::VES_POSITION, Ogre::VES_NORMAL, Ogre::VES_TEXTURE_COORDINATES, Ogre::VES_DIFFUSE, Ogre::VES_TANGENT};
constexpr Ogre::VertexElementType kTypes[] = {
    Ogre::VET_FLOAT3,       Ogre::VET_FLOAT1,      Ogre::VET_FLOAT2,     Ogre::VET_FLOAT4,  Ogre::VET_COLOUR,
    Ogre::VET_SHORT2,       Ogre::VET_SHORT4,      Ogre::VET_UBYTE4,     Ogre::VET_DOUBLE3, Ogre::VET_INT3,
    Ogre::VET_USHORT4_NORM, Ogre::VET_SHORT2_NORM, Ogre::VET_UBYTE4_NORM};

/// Mostly small numbers, sometimes any bits, so that most positions are finite.
float number(ByteSource& bytes)
{
    return bytes.below(64) == 63 ? bytes.anything() : bytes.coarse();
}

void fill(Ogre::HardwareBuffer& buffer, ByteSource& bytes, bool floats)
{
    std::vector<unsigned char> content(buffer.getSizeInBytes());
    for (std::size_t i = 0; i < content.size(); i += floats ? sizeof(float) : 1) {
        const float value = number(bytes);
        if (floats && i + sizeof value <= content.size())
            std::memcpy(&content[i], &value, sizeof value);
        else
            content[i] = bytes.byte();
    }
    buffer.writeData(0, content.size(), content.data());
}

Ogre::VertexData* makeVertices(ByteSource& bytes)
{
    auto* data = OGRE_NEW Ogre::VertexData();
    data->vertexStart = bytes.below(8) == 7 ? bytes.below(4) : 0;
    data->vertexCount = bytes.below(32);
    std::size_t size = 0;
    const std::uint32_t elements = 1 + bytes.below(5);
    for (std::uint32_t i = 0; i < elements; ++i) {
        const bool plain = i == 0 && bytes.below(4) != 3;
        const Ogre::VertexElementType type = plain ? Ogre::VET_FLOAT3 : kTypes[bytes.below(std::size(kTypes))];
        const Ogre::VertexElementSemantic semantic =
            plain ? Ogre::VES_POSITION : kSemantics[bytes.below(std::size(kSemantics))];
        const auto source = static_cast<unsigned short>(bytes.below(16) == 15 ? 1 : 0);
        data->vertexDeclaration->addElement(source, size, type, semantic, static_cast<unsigned short>(i / 2));
        size += Ogre::VertexElement::getTypeSize(type);
    }
    const std::size_t cut =
        bytes.below(16) == 15 ? bytes.below(8) : 0; // the declaration may promise more than there is
    const std::size_t rows = data->vertexCount + 1 - (bytes.below(16) == 15 ? 1 : 0);
    if (rows == 0 || size <= cut)
        return data;
    auto buffer = Ogre::HardwareBufferManager::getSingleton().createVertexBuffer(
        size - cut, rows, Ogre::HardwareBuffer::HBU_STATIC_WRITE_ONLY);
    fill(*buffer, bytes, true);
    if (bytes.below(16) != 15)
        data->vertexBufferBinding->setBinding(0, buffer);
    return data;
}

void makeSubMesh(Ogre::Mesh& mesh, ByteSource& bytes)
{
    Ogre::SubMesh* subMesh = mesh.createSubMesh();
    subMesh->useSharedVertices = bytes.flag();
    if (!subMesh->useSharedVertices && bytes.below(16) != 15)
        subMesh->vertexData = makeVertices(bytes);
    subMesh->operationType = bytes.below(4) == 3 ? static_cast<Ogre::RenderOperation::OperationType>(1 + bytes.below(6))
                                                 : Ogre::RenderOperation::OT_TRIANGLE_LIST;
    const bool wide = bytes.flag();
    const std::uint32_t count = bytes.below(96);
    std::vector<std::uint32_t> indices(count);
    const bool anywhere = bytes.below(8) == 7;
    for (std::uint32_t& index : indices)
        index = anywhere ? bytes.byte() : bytes.below(16);
    if (count == 0 && bytes.flag())
        return;
    test::setIndices(*subMesh, indices, subMesh->operationType, wide, bytes.below(4));
    if (bytes.below(8) == 7)
        subMesh->indexData->indexStart += bytes.below(8);
    if (bytes.below(8) == 7)
        subMesh->indexData->indexCount += bytes.below(8);
}

Ogre::MeshPtr makeMesh(ByteSource& bytes)
{
    Ogre::MeshPtr mesh = Ogre::MeshManager::getSingleton().createManual("fuzzed", Ogre::RGN_DEFAULT);
    mesh->load(); // while it is empty: OGRE itself does not survive the loading of submeshes without vertices
    if (bytes.flag())
        mesh->sharedVertexData = makeVertices(bytes);
    for (std::uint32_t subMeshes = bytes.below(4); subMeshes-- > 0;)
        makeSubMesh(*mesh, bytes);
    mesh->_setBounds(Ogre::AxisAlignedBox(-1, -1, -1, 1, 1, 1));
    return mesh;
}

LodConfig makeConfig(const Ogre::MeshPtr& mesh, ByteSource& bytes)
{
    LodConfig config;
    config.mesh = mesh;
    config.shareIndexBuffers = bytes.flag();
    const std::uint32_t levels = 1 + bytes.below(3);
    for (std::uint32_t level = 0; level < levels; ++level)
        config.levels.push_back({10.0f * (level + 1), {LevelTarget::Kind::Proportional, bytes.byte() / 255.0}, ""});
    return config;
}

void generate(ByteSource& bytes)
{
    const Ogre::MeshPtr mesh = makeMesh(bytes);
    const Result<LodReport> report = ProgressiveMeshGenerator().generateLodLevels(makeConfig(mesh, bytes));
    if (report.ok() && report.value().notes.empty()) { // a submesh that was left alone keeps whatever is wrong in it
        for (const std::string& sentence : test::brokenLevels(*mesh)) {
            std::fprintf(stderr, "%s\n", sentence.c_str());
            std::abort();
        }
    } else if (!report.ok() && report.error().message.empty()) {
        std::abort();
    }
    Ogre::MeshManager::getSingleton().remove(mesh);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    static test::OgreSession session;
    ByteSource bytes(data, size);
    generate(bytes);
    return 0;
}
