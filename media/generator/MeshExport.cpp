#include "MeshExport.h"

#include <OgreHardwareBufferManager.h>
#include <OgreImage.h>
#include <OgreMaterialManager.h>
#include <OgreMeshManager.h>
#include <OgreMeshSerializer.h>
#include <OgreSubMesh.h>

#include <cmath>
#include <fstream>
#include <iostream>
#include <stdexcept>

namespace lodsmith::media {

namespace {

/// The layout of Vertex in a buffer, without padding between its members.
Ogre::VertexData* makeVertexData(const std::vector<Vertex>& vertices)
{
    static_assert(sizeof(Vertex) == 8 * sizeof(float));
    auto* data = new Ogre::VertexData();
    data->vertexCount = vertices.size();
    std::size_t offset = 0;
    const std::pair<Ogre::VertexElementType, Ogre::VertexElementSemantic> elements[] = {
        {Ogre::VET_FLOAT3, Ogre::VES_POSITION},
        {Ogre::VET_FLOAT3, Ogre::VES_NORMAL},
        {Ogre::VET_FLOAT2, Ogre::VES_TEXTURE_COORDINATES}};
    for (const auto& [type, semantic] : elements)
        offset += data->vertexDeclaration->addElement(0, offset, type, semantic).getSize();
    auto buffer = Ogre::HardwareBufferManager::getSingleton().createVertexBuffer(
        sizeof(Vertex), vertices.size(), Ogre::HardwareBuffer::HBU_STATIC_WRITE_ONLY);
    buffer->writeData(0, buffer->getSizeInBytes(), vertices.data(), true);
    data->vertexBufferBinding->setBinding(0, buffer);
    return data;
}

void setIndices(Ogre::IndexData& data, const std::vector<std::uint32_t>& indices, std::size_t first)
{
    std::vector<std::uint16_t> narrow;
    for (const std::uint32_t index : indices) {
        if (first + index > 0xffff)
            throw std::runtime_error("too many vertices for 16-bit indices");
        narrow.push_back(static_cast<std::uint16_t>(first + index));
    }
    data.indexBuffer = Ogre::HardwareBufferManager::getSingleton().createIndexBuffer(
        Ogre::HardwareIndexBuffer::IT_16BIT, narrow.size(), Ogre::HardwareBuffer::HBU_STATIC_WRITE_ONLY);
    data.indexBuffer->writeData(0, data.indexBuffer->getSizeInBytes(), narrow.data(), true);
    data.indexCount = narrow.size();
}

void setBounds(Ogre::Mesh& mesh, const std::vector<Shape>& shapes)
{
    Ogre::AxisAlignedBox box;
    for (const Shape& shape : shapes)
        for (const Vertex& vertex : shape.vertices)
            box.merge(vertex.position);
    float radius = 0.0f;
    for (const Shape& shape : shapes)
        for (const Vertex& vertex : shape.vertices)
            radius = std::max(radius, vertex.position.length());
    mesh._setBounds(box);
    mesh._setBoundingSphereRadius(radius);
}

float lattice(int x, int y, std::uint32_t seed)
{
    std::uint32_t hash = std::uint32_t(x) * 374761393u + std::uint32_t(y) * 668265263u + seed * 2246822519u;
    hash = (hash ^ (hash >> 13)) * 1274126177u;
    return float((hash ^ (hash >> 16)) & 0xffff) / 32767.5f - 1.0f;
}

float eased(float t)
{
    return t * t * (3.0f - 2.0f * t);
}

} // namespace

Ogre::MeshPtr makeMesh(const std::string& name, const std::vector<Shape>& shapes, bool shared)
{
    Ogre::MeshPtr mesh = Ogre::MeshManager::getSingleton().createManual(name, Ogre::RGN_DEFAULT);
    std::vector<Vertex> all;
    for (const Shape& shape : shapes) {
        Ogre::SubMesh* subMesh = mesh->createSubMesh();
        // A submesh forgets the name of a material that does not exist.
        subMesh->setMaterial(Ogre::MaterialManager::getSingleton().create(shape.material, Ogre::RGN_DEFAULT));
        subMesh->useSharedVertices = shared;
        if (!shared)
            subMesh->vertexData = makeVertexData(shape.vertices);
        setIndices(*subMesh->indexData, shape.indices, shared ? all.size() : 0);
        all.insert(all.end(), shape.vertices.begin(), shape.vertices.end());
    }
    if (shared)
        mesh->sharedVertexData = makeVertexData(all);
    setBounds(*mesh, shapes);
    return mesh;
}

void exportMesh(const Ogre::Mesh& mesh, const std::filesystem::path& directory)
{
    const std::filesystem::path file = directory / mesh.getName();
    Ogre::MeshSerializer().exportMesh(&mesh, file.string());
    std::size_t triangles = 0, vertices = mesh.sharedVertexData ? mesh.sharedVertexData->vertexCount : 0;
    for (const Ogre::SubMesh* subMesh : mesh.getSubMeshes()) {
        triangles += subMesh->indexData->indexCount / 3;
        vertices += subMesh->vertexData ? subMesh->vertexData->vertexCount : 0;
    }
    std::cout << file.string() << ": " << mesh.getNumSubMeshes() << " submeshes, " << vertices << " vertices, "
              << triangles << " triangles, " << std::filesystem::file_size(file) << " bytes\n";
}

void writePicture(const std::filesystem::path& file, std::uint32_t size,
                  const std::function<Ogre::ColourValue(float u, float v)>& colour)
{
    Ogre::Image image(Ogre::PF_BYTE_RGBA, size, size);
    for (std::uint32_t y = 0; y < size; ++y)
        for (std::uint32_t x = 0; x < size; ++x) {
            Ogre::ColourValue value = colour((float(x) + 0.5f) / float(size), (float(y) + 0.5f) / float(size));
            value.saturate();
            image.setColourAt(value, x, y, 0);
        }
    image.save(file.string());
}

float tilingNoise(float x, float y, int period, std::uint32_t seed)
{
    const int left = int(std::floor(x)), top = int(std::floor(y));
    const auto wrap = [period](int value) { return ((value % period) + period) % period; };
    const float u = eased(x - float(left)), v = eased(y - float(top));
    const float upper = lattice(wrap(left), wrap(top), seed) * (1 - u) + lattice(wrap(left + 1), wrap(top), seed) * u;
    const float lower =
        lattice(wrap(left), wrap(top + 1), seed) * (1 - u) + lattice(wrap(left + 1), wrap(top + 1), seed) * u;
    return upper * (1 - v) + lower * v;
}

float fractalNoise(float u, float v, int period, int octaves, std::uint32_t seed)
{
    float sum = 0.0f, amplitude = 0.5f;
    for (int octave = 0; octave < octaves; ++octave) {
        sum += amplitude * tilingNoise(u * float(period), v * float(period), period, seed + std::uint32_t(octave));
        period *= 2;
        amplitude *= 0.5f;
    }
    return sum;
}

void writeText(const std::filesystem::path& file, const std::string& text)
{
    std::ofstream stream(file);
    stream << text;
    if (!stream.flush())
        throw std::runtime_error(file.string() + " cannot be written");
}

} // namespace lodsmith::media
