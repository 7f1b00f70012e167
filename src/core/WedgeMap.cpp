#include "WedgeMap.h"

namespace lodsmith {

bool WedgeMap::build(const CollapseMesh& mesh, const OneRing& ring, std::uint32_t neighbour)
{
    const std::uint32_t destination = ring.neighbours[neighbour].vertex;
    mCount = 1;
    mFrom[0] = ring.faces[0].wedge[0];
    mTo[0] = destination;
    if (!ring.isSeam && !mesh.vertices[destination].hasSeam)
        return mesh.bufferOf(mFrom[0]) == mesh.bufferOf(destination);
    if (!mesh.wedgeMotion.empty() && !motionAllows(mesh, ring, neighbour))
        return false;
    mCount = 0;
    for (std::uint32_t i = 0; i < ring.faceCount; ++i) {
        const std::uint32_t wedge = ring.faces[i].wedge[0];
        bool known = false;
        for (std::uint32_t k = 0; k < mCount && !known; ++k)
            known = mFrom[k] == wedge;
        if (known)
            continue;
        std::uint32_t to = matched(mesh, ring, neighbour, wedge);
        if (to == kNone)
            to = nearest(mesh, destination, wedge);
        if (to == kNone)
            return false;
        mFrom[mCount] = wedge;
        mTo[mCount++] = to;
    }
    return true;
}

std::uint32_t WedgeMap::matched(const CollapseMesh& mesh, const OneRing& ring, std::uint32_t neighbour, std::uint32_t wedge) const
{
    std::uint32_t best = kNone;
    for (std::uint32_t i = 0; i < ring.faceCount; ++i) {
        const OneRing::RingFace& face = ring.faces[i];
        if (face.wedge[0] != wedge || !ring.contains(face, neighbour))
            continue;
        const std::uint32_t there = face.second == neighbour ? face.wedge[1] : face.wedge[2];
        if (mesh.bufferOf(there) != mesh.bufferOf(wedge))
            continue;
        if (best == kNone || (best != there && mesh.attributeDistance(wedge, there) < mesh.attributeDistance(wedge, best)))
            best = there;
    }
    return best;
}

std::uint32_t WedgeMap::nearest(const CollapseMesh& mesh, std::uint32_t vertex, std::uint32_t wedge)
{
    std::uint32_t best = kNone;
    double bestDistance = 0.0;
    for (std::uint32_t there = vertex; there != kNone; there = mesh.nextWedge[there]) {
        if (mesh.bufferOf(there) != mesh.bufferOf(wedge))
            continue;
        const double distance = mesh.attributeDistance(wedge, there);
        if (best == kNone || distance < bestDistance) {
            best = there;
            bestDistance = distance;
        }
    }
    return best;
}

/// Where wedges of one position move apart, a collapse has to run along that split on every side of it: each face must
/// reach the destination through faces of its own motion.
bool WedgeMap::motionAllows(const CollapseMesh& mesh, const OneRing& ring, std::uint32_t neighbour)
{
    const auto destinationOf = [&](std::uint32_t motion) {
        std::uint32_t found = kNone;
        for (std::uint32_t i = 0; i < ring.faceCount; ++i) {
            const OneRing::RingFace& face = ring.faces[i];
            if (!ring.contains(face, neighbour) || mesh.motionOf(face.wedge[0]) != motion)
                continue;
            const std::uint32_t there = mesh.motionOf(face.second == neighbour ? face.wedge[1] : face.wedge[2]);
            if (found != kNone && found != there)
                return kNone;
            found = there;
        }
        return found;
    };
    for (std::uint32_t i = 0; i < ring.faceCount; ++i)
        if (destinationOf(mesh.motionOf(ring.faces[i].wedge[0])) == kNone)
            return false;
    return true;
}

} // namespace lodsmith
