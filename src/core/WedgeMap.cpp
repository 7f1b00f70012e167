#include "WedgeMap.h"

#include <algorithm>
#include <limits>

namespace lodsmith {

namespace {

/// Whether walking on from face to face around the vertex comes by every face once.
bool isClosedFan(const OneRing& ring, std::uint32_t start)
{
    std::uint32_t at = start, face = ring.neighbours[start].firstFace, faces = 0;
    do {
        at = ring.apexOf(ring.faces[face], at);
        const OneRing::Neighbour& end = ring.neighbours[at];
        if (end.faces != 2)
            return false;
        face = end.firstFace == face ? end.lastFace : end.firstFace;
        ++faces;
    } while (at != start);
    return faces == ring.faceCount;
}

/// Whether no more than two faces lie between two vertices; of a hub, which would take long to look through, never.
bool isOrdinaryEdge(const CollapseMesh& mesh, std::uint32_t a, std::uint32_t b)
{
    const CollapseMesh::Vertex& vertex = mesh.vertices[a];
    if (vertex.liveFaces > OneRing::kMaxFaces)
        return false;
    std::uint32_t between = 0;
    for (std::uint32_t i = 0; i < vertex.faceSlots; ++i) {
        const CollapseMesh::Face& face = mesh.faces[mesh.faceList(a)[i]];
        if (!mesh.isGone(face))
            for (std::uint32_t wedge : face.wedge)
                between += mesh.vertexOf(wedge) == b;
    }
    return between <= 2;
}

} // namespace

bool WedgeMap::build(const CollapseMesh& mesh, const OneRing& ring, std::uint32_t neighbour)
{
    const std::uint32_t destination = ring.neighbours[neighbour].vertex;
    mTo[0] = destination;
    if (!mesh.wedgeMotion.empty() && !motionAllows(mesh, ring, neighbour))
        return false;
    if (!ring.isSeam() && !mesh.vertices[destination].hasSeam)
        return mesh.subMeshOfWedge(ring.wedges[0]) == mesh.subMeshOfWedge(destination);
    match(mesh, ring, neighbour);
    for (std::uint32_t i = 0; i < ring.wedgeCount; ++i) {
        if (mTo[i] == kNone)
            mTo[i] = nearest(mesh, destination, ring.wedges[i], motionThere(mesh, ring, neighbour, ring.wedges[i]));
        if (mTo[i] == kNone)
            return false;
    }
    return true;
}

/// Wedges with a face on the edge; kNone for the others.
void WedgeMap::match(const CollapseMesh& mesh, const OneRing& ring, std::uint32_t neighbour)
{
    std::fill(mTo, mTo + ring.wedgeCount, kNone);
    const OneRing::Neighbour& end = ring.neighbours[neighbour];
    if (end.faces <= 2) {
        match(mesh, ring, ring.faces[end.firstFace], neighbour);
        match(mesh, ring, ring.faces[end.lastFace], neighbour);
        return;
    }
    for (std::uint32_t i = 0; i < ring.faceCount; ++i)
        if (ring.contains(ring.faces[i], neighbour))
            match(mesh, ring, ring.faces[i], neighbour);
}

void WedgeMap::match(const CollapseMesh& mesh, const OneRing& ring, const OneRing::RingFace& face,
                     std::uint32_t neighbour)
{
    const std::uint32_t wedge = face.wedge[0], there = ring.wedgeOf(face, neighbour);
    std::uint32_t& best = mTo[face.own];
    if (there == best || mesh.subMeshOfWedge(there) != mesh.subMeshOfWedge(wedge))
        return;
    if (best == kNone || mesh.attributeDistance(wedge, there) < mesh.attributeDistance(wedge, best))
        best = there;
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

/// Whether the faces on an edge disagree about how its ends move.
bool WedgeMap::isSplit(const CollapseMesh& mesh, const OneRing& ring, std::uint32_t neighbour)
{
    const OneRing::Neighbour& end = ring.neighbours[neighbour];
    const OneRing::RingFace& first = ring.faces[end.firstFace];
    const auto differs = [&](const OneRing::RingFace& face) {
        return mesh.motionOf(face.wedge[0]) != mesh.motionOf(first.wedge[0])
               || mesh.motionOf(ring.wedgeOf(face, neighbour)) != mesh.motionOf(ring.wedgeOf(first, neighbour));
    };
    if (end.faces <= 2)
        return differs(ring.faces[end.lastFace]);
    return std::any_of(ring.faces, ring.faces + ring.faceCount,
                       [&](const OneRing::RingFace& face) { return ring.contains(face, neighbour) && differs(face); });
}

/// Where wedges of one position move apart, the split between them is left along itself only, and its ends stay. For a split
/// to pass through the vertex, the faces around it have to be one closed fan with two halves, each with a motion of its
/// own: then all that moves together goes to where it moves together again, and no edge comes apart.
bool WedgeMap::motionAllows(const CollapseMesh& mesh, const OneRing& ring, std::uint32_t neighbour)
{
    std::uint32_t splits = 0, onward = neighbour; // where the split goes on to
    for (std::uint32_t i = 0; i < ring.neighbourCount; ++i)
        if (isSplit(mesh, ring, i)) {
            ++splits;
            onward = i != neighbour ? i : onward;
        }
    if (splits == 0)
        return true;
    const OneRing::Neighbour& end = ring.neighbours[neighbour];
    const OneRing::RingFace &a = ring.faces[end.firstFace], &b = ring.faces[end.lastFace];
    if (splits != 2 || !isSplit(mesh, ring, neighbour) || !isClosedFan(ring, neighbour)
        || mesh.motionOf(a.wedge[0]) == mesh.motionOf(b.wedge[0]))
        return false;
    // A half of one face goes as a whole, and the other half takes its place on the edge across from the vertex.
    const bool halfGoes = ring.contains(a, onward) != ring.contains(b, onward);
    return !halfGoes || isOrdinaryEdge(mesh, end.vertex, ring.neighbours[onward].vertex);
}

} // namespace lodsmith
