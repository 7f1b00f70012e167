#include "WedgeMap.h"

#include <algorithm>
#include <limits>

namespace lodsmith {

bool WedgeMap::build(const CollapseMesh& mesh, const OneRing& ring, std::uint32_t neighbour)
{
    const std::uint32_t destination = ring.neighbours[neighbour].vertex;
    mCount = 1;
    mFrom[0] = ring.faces[0].wedge[0];
    mTo[0] = destination;
    if (!mesh.wedgeMotion.empty() && !motionAllows(mesh, ring, neighbour))
        return false;
    if (!ring.isSeam && !mesh.vertices[destination].hasSeam)
        return mesh.subMeshOfWedge(mFrom[0]) == mesh.subMeshOfWedge(destination);
    mCount = 0;
    for (std::uint32_t i = 0; i < ring.faceCount; ++i) {
        const std::uint32_t wedge = ring.faces[i].wedge[0];
        if (std::find(mFrom, mFrom + mCount, wedge) != mFrom + mCount)
            continue;
        std::uint32_t to = matched(mesh, ring, neighbour, wedge);
        if (to == kNone)
            to = nearest(mesh, destination, wedge, motionThere(mesh, ring, neighbour, wedge));
        if (to == kNone)
            return false;
        mFrom[mCount] = wedge;
        mTo[mCount++] = to;
    }
    return true;
}

std::uint32_t WedgeMap::matched(const CollapseMesh& mesh, const OneRing& ring, std::uint32_t neighbour,
                                std::uint32_t wedge)
{
    const OneRing::Neighbour& destination = ring.neighbours[neighbour];
    std::uint32_t best = kNone;
    const std::uint32_t first = std::min(destination.firstFace, destination.lastFace),
                        last = std::max(destination.firstFace, destination.lastFace);
    const std::uint32_t step =
        destination.faces == 2 && first != last ? last - first : 1; // most edges have these two faces only
    for (std::uint32_t i = first; i <= last; i += step) {
        const OneRing::RingFace& face = ring.faces[i];
        if (face.wedge[0] != wedge || !ring.contains(face, neighbour))
            continue;
        const std::uint32_t there = ring.wedgeOf(face, neighbour);
        if (mesh.subMeshOfWedge(there) != mesh.subMeshOfWedge(wedge) || there == best)
            continue;
        if (best == kNone || mesh.attributeDistance(wedge, there) < mesh.attributeDistance(wedge, best))
            best = there;
    }
    return best;
}

std::uint32_t WedgeMap::nearest(const CollapseMesh& mesh, std::uint32_t vertex, std::uint32_t wedge,
                                std::uint32_t motion)
{
    const std::uint32_t subMesh = mesh.subMeshOfWedge(wedge);
    std::uint32_t best = kNone;
    float bestDistance = std::numeric_limits<float>::infinity();
    for (std::uint32_t there = vertex; there != kNone; there = mesh.nextWedge[there]) {
        if (mesh.subMeshOfWedge(there) != subMesh || mesh.motionOf(there) != motion)
            continue;
        const float distance = mesh.attributeDistance(wedge, there);
        if (best == kNone || distance < bestDistance) {
            best = there;
            bestDistance = distance;
        }
    }
    return best;
}

/// The motion that a wedge takes on at the destination: that of the faces on the edge with its own motion; kNone without any.
std::uint32_t WedgeMap::motionThere(const CollapseMesh& mesh, const OneRing& ring, std::uint32_t neighbour,
                                    std::uint32_t wedge)
{
    if (mesh.wedgeMotion.empty())
        return mesh.motionOf(wedge);
    for (std::uint32_t i = 0; i < ring.faceCount; ++i)
        if (ring.contains(ring.faces[i], neighbour) && mesh.motionOf(ring.faces[i].wedge[0]) == mesh.motionOf(wedge))
            return mesh.motionOf(ring.wedgeOf(ring.faces[i], neighbour));
    return kNone;
}

/// Where wedges of one position move apart, the split between them is left along itself only, and its ends stay.
bool WedgeMap::motionAllows(const CollapseMesh& mesh, const OneRing& ring, std::uint32_t neighbour)
{
    const auto isSplit = [&](std::uint32_t i) {
        const OneRing::RingFace &a = ring.faces[ring.neighbours[i].firstFace],
                                &b = ring.faces[ring.neighbours[i].lastFace];
        return mesh.motionOf(a.wedge[0]) != mesh.motionOf(b.wedge[0])
               || mesh.motionOf(ring.wedgeOf(a, i)) != mesh.motionOf(ring.wedgeOf(b, i));
    };
    std::uint32_t splits = 0;
    for (std::uint32_t i = 0; i < ring.neighbourCount; ++i)
        splits += isSplit(i);
    return splits == 0 || (splits == 2 && isSplit(neighbour));
}

} // namespace lodsmith
