#include "MemoryNeed.h"

#include "PoseReader.h"
#include "VertexElements.h"

#include <lodsmith/core/MeshView.h>

#include <OgreAnimation.h>
#include <OgreAnimationTrack.h>
#include <OgrePose.h>
#include <OgreSubMesh.h>

#include <algorithm>
#include <functional>

namespace lodsmith {

namespace {

std::size_t floatsOf(const Ogre::VertexElement& element)
{
    switch (element.getSemantic()) {
    case Ogre::VES_POSITION:
    case Ogre::VES_NORMAL: return 3;
    case Ogre::VES_COLOUR: return 4;
    case Ogre::VES_TEXTURE_COORDINATES: return static_cast<std::size_t>(componentCount(element.getType()));
    default: return 0;
    }
}

/// Poses and morph frames that move the vertices of this number (see VertexSource::handle).
std::size_t offsetSets(const Ogre::Mesh& mesh, unsigned short handle)
{
    const auto& poses = mesh.getPoseList();
    auto sets = static_cast<std::size_t>(std::count_if(
        poses.begin(), poses.end(), [handle](const Ogre::Pose* pose) { return pose->getTarget() == handle; }));
    for (unsigned short i = 0; i < mesh.getNumAnimations(); ++i)
        for (const auto& [target, track] : mesh.getAnimation(i)->_getVertexTrackList())
            if (target == handle && track->getAnimationType() == Ogre::VAT_MORPH)
                sets += track->getNumKeyFrames();
    return sets;
}

std::size_t bytesOfVertices(const Ogre::Mesh& mesh, const Ogre::VertexData* vertices, bool skinned, bool weighed,
                            unsigned short handle)
{
    if (!vertices)
        return 0;
    const std::size_t offsets = offsetSets(mesh, handle);
    std::size_t floats = 3 * (offsets + std::min(offsets, kMostPoses) + (skinned ? kMostPoses : 0));
    for (const Ogre::VertexElement& element : vertices->vertexDeclaration->getElements())
        floats += floatsOf(element);
    floats += weighed ? 1 : 0;
    return vertices->vertexCount * (floats * sizeof(float) + (skinned ? sizeof(BoneInfluences) : 0));
}

std::size_t indicesAsList(const Ogre::SubMesh& subMesh)
{
    const bool list = subMesh.operationType == Ogre::RenderOperation::OT_TRIANGLE_LIST;
    return subMesh.indexData->indexCount * (list ? 1 : 3);
}

} // namespace

std::size_t memoryNeed(const LodConfig& config)
{
    const Ogre::Mesh& mesh = *config.mesh;
    const auto levels = static_cast<std::size_t>(
        std::count_if(config.levels.begin(), config.levels.end(), std::not_fn(std::mem_fn(&LodLevel::isManual))));
    const bool weighed = !config.subMeshImportance.empty();
    std::size_t bytes = bytesOfVertices(mesh, mesh.sharedVertexData, !mesh.getBoneAssignments().empty(), weighed, 0);
    for (std::size_t i = 0; i < mesh.getNumSubMeshes(); ++i) {
        const Ogre::SubMesh& subMesh = *mesh.getSubMesh(i);
        if (!subMesh.useSharedVertices)
            bytes += bytesOfVertices(mesh, subMesh.vertexData, !subMesh.getBoneAssignments().empty(), weighed,
                                     static_cast<unsigned short>(i + 1));
        bytes += indicesAsList(subMesh) * sizeof(std::uint32_t) * (levels + 1);
    }
    return bytes;
}

} // namespace lodsmith
