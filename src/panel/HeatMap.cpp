#include "HeatMap.h"

#include <OgreManualObject.h>
#include <OgreSceneManager.h>
#include <OgreSceneNode.h>

#include <algorithm>

namespace lodsmith {

namespace {

Ogre::Vector3 vectorAt(const FloatStream& stream, std::size_t index)
{
    float numbers[3];
    stream.read(index, 3, numbers);
    return Ogre::Vector3(numbers[0], numbers[1], numbers[2]);
}

/// Those of a buffer; where it has none, the mean of the faces around each vertex, by their areas.
std::vector<Ogre::Vector3> normalsOf(const MeshView& mesh, std::uint32_t buffer)
{
    const VertexBufferView& vertices = mesh.vertexBuffers[buffer];
    std::vector<Ogre::Vector3> normals(vertices.vertexCount, Ogre::Vector3::ZERO);
    if (vertices.normals) {
        for (std::size_t i = 0; i < normals.size(); ++i)
            normals[i] = vectorAt(vertices.normals, i);
        return normals;
    }
    for (const SubMeshView& part : mesh.subMeshes)
        for (std::uint32_t i = 0; part.vertexBuffer == buffer && i + 2 < part.indexCount; i += 3) {
            const std::uint32_t corners[3] = {part.index(i), part.index(i + 1), part.index(i + 2)};
            const Ogre::Vector3 a = vectorAt(vertices.positions, corners[0]);
            const Ogre::Vector3 face = (vectorAt(vertices.positions, corners[1]) - a)
                                           .crossProduct(vectorAt(vertices.positions, corners[2]) - a);
            for (const std::uint32_t corner : corners)
                normals[corner] += face;
        }
    for (Ogre::Vector3& normal : normals)
        normal.normalise();
    return normals;
}

} // namespace

Ogre::ColourValue heatColour(float share)
{
    using Colour = Ogre::ColourValue;
    static const Colour kColours[] = {Colour(0.10f, 0.25f, 0.95f), Colour(0.10f, 0.80f, 0.25f),
                                      Colour(0.98f, 0.90f, 0.10f), Colour(0.95f, 0.10f, 0.05f)};
    const float place = 3 * std::clamp(share, 0.0f, 1.0f);
    const int below = std::min(static_cast<int>(place), 2);
    const float above = place - static_cast<float>(below);
    return kColours[below] * (1 - above) + kColours[below + 1] * above;
}

HeatMap::HeatMap(Ogre::SceneNode& node, const Ogre::MaterialPtr& material)
    : mScene(*node.getCreator()), mMaterial(material), mObject(mScene.createManualObject())
{
    node.attachObject(mObject);
}

HeatMap::~HeatMap()
{
    mScene.destroyManualObject(mObject);
}

void HeatMap::setVisible(bool visible)
{
    mObject->setVisible(visible);
}

void HeatMap::paint(const MeshView& mesh, const std::vector<std::vector<float>>& values, double scale)
{
    mObject->clear();
    mObject->begin(mMaterial, Ogre::RenderOperation::OT_TRIANGLE_LIST);
    std::vector<std::uint32_t> first; // of each buffer, in the one that all share
    std::uint32_t count = 0;
    for (std::uint32_t buffer = 0; buffer < mesh.vertexBuffers.size(); ++buffer) {
        const std::vector<Ogre::Vector3> normals = normalsOf(mesh, buffer);
        for (std::size_t i = 0; i < normals.size(); ++i) {
            mObject->position(vectorAt(mesh.vertexBuffers[buffer].positions, i));
            mObject->normal(normals[i]);
            mObject->colour(heatColour(scale > 0 ? static_cast<float>(values[buffer][i] / scale) : 0.0f));
        }
        first.push_back(count);
        count += mesh.vertexBuffers[buffer].vertexCount;
    }
    for (const SubMeshView& part : mesh.subMeshes)
        for (std::uint32_t i = 0; i < part.indexCount; ++i)
            mObject->index(first[part.vertexBuffer] + part.index(i));
    mObject->end();
}

} // namespace lodsmith
