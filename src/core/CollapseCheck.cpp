#include "CollapseCheck.h"

#include "PosedRing.h"

#include <algorithm>
#include <utility>

namespace lodsmith {

namespace {

constexpr double kLeastCosine = 0.2; // a face may turn by up to 78 degrees in one collapse
// ... and never against the surface that there was at its corners: sum of three cosines
constexpr double kAgainst = 0.03 * CollapseMesh::kNormalSteps;
// ... or, in a pose, where mean normals of folds tell little: at -0.03 too the mean deviation rose by a sixth
constexpr double kAgainstInPose = 0.3 * CollapseMesh::kNormalSteps;
constexpr float kDrawnTogether = 1e-4f; // share of its area at rest below which a face has none in a pose
constexpr std::uint32_t kOrdinaryFaces = 8;
constexpr std::uint32_t kHubFaces = 64; // from here on it is cheaper to ask the neighbours than to walk the hub

bool isApex(const OneRing& ring, std::uint32_t neighbour, std::uint32_t other)
{
    for (std::uint32_t i = 0; i < ring.faceCount; ++i)
        if (ring.contains(ring.faces[i], neighbour) && ring.apexOf(ring.faces[i], neighbour) == other)
            return true;
    return false;
}

bool hasFace(const OneRing& ring, std::uint32_t a, std::uint32_t b)
{
    for (std::uint32_t i = 0; i < ring.faceCount; ++i)
        if (ring.contains(ring.faces[i], a) && ring.contains(ring.faces[i], b))
            return true;
    return false;
}

/// Whether a normal, of any length, is turned too far from a unit one; from that of a face that had no area, none is.
bool isTurnedOver(const Vec3& before, const Vec3& after)
{
    const double along = dot(before, after);
    const bool hadNoArea = !(lengthSquared(before) > 0.0); // areas get too small for a float, normals do not
    return !hadNoArea && !(along > 0.0 && along * along > kLeastCosine * kLeastCosine * lengthSquared(after));
}

bool isAgainst(const Vec3& around, const Vec3& after)
{
    const double along = dot(around, after);
    return along < 0.0 && along * along > kAgainst * kAgainst * lengthSquared(after);
}

/// A face as it stands in four poses.
struct PosedFace {
    Lanes3 before, after;
    Lanes3 around; ///< mean normals that the input has at the corners, added
};

/// Whether a face is turned too far in one of four poses in which it agrees with the faces around it, and has an area.
bool turnsInAnyLane(const PosedFace& face, const Lanes3& whole, float leastArea)
{
    const Lanes agreement = dot(whole, face.before), along = dot(face.before, face.after),
                back = dot(face.around, face.after);
    const Lanes sizeBefore = sqrt(dot(face.before, face.before)), sizeAfter = sqrt(dot(face.after, face.after));
    int turned = 0;
    for (std::size_t i = 0; i < Poses::kLanes; ++i) {
        const int counts = int(agreement[i] > 0.0f) & int(sizeBefore[i] > leastArea);
        const int holds = int(along[i] > float(kLeastCosine) * sizeBefore[i] * sizeAfter[i])
                          & int(back[i] >= -float(kAgainstInPose) * sizeAfter[i]);
        turned |= counts & (holds ^ 1);
    }
    return turned != 0;
}

} // namespace

bool CollapseCheck::allows(OneRing& ring, std::uint32_t neighbour) const
{
    const std::uint32_t destination = ring.neighbours[neighbour].vertex;
    const std::uint32_t onEdge = ring.neighbours[neighbour].faces;
    if (onEdge == ring.faceCount && onEdge == mMesh.vertices[destination].liveFaces)
        return false; // nothing would be left of this piece
    if (onEdge != 1 && ring.isBorder())
        return false; // a border is left along itself only
    if (leavesLine(ring, neighbour))
        return false;
    ring.aimAt(neighbour);
    if (turnsFaceOver(ring, destination))
        return false;
    const bool hub = mMesh.vertices[destination].liveFaces > kHubFaces;
    if (!hub && isOrdinary(ring, neighbour))
        return true;
    return hub ? keepsLinkAtHub(ring, neighbour) : keepsLink(ring, neighbour);
}

/// Whether the vertex lies on, or ends, a line where sheets meet in threes, and would leave it. Even numbers of faces on an
/// edge are no such line: walls with two sides have four, and their outlines would be stuck.
bool CollapseCheck::leavesLine(const OneRing& ring, std::uint32_t neighbour)
{
    if (ring.isFan)
        return false;
    const auto isOnLine = [](const OneRing::Neighbour& end) { return end.faces > 2 && end.faces % 2 == 1; };
    const auto lines = std::count_if(ring.neighbours, ring.neighbours + ring.neighbourCount, isOnLine);
    return lines != 0 && lines <= 2 && !isOnLine(ring.neighbours[neighbour]);
}

bool CollapseCheck::turnsFaceOver(const OneRing& ring, std::uint32_t destination) const
{
    const Vec3 there = mMesh.meanNormal(destination);
    for (std::uint32_t i = 0; i < ring.survivorCount; ++i) {
        const OneRing::RingFace& ringFace = ring.faces[ring.survivors[i]];
        const Vec3& after = ring.areaAfter[ring.survivors[i]];
        const Vec3 around = there + mMesh.meanNormal(ring.neighbours[ringFace.second].vertex)
                            + mMesh.meanNormal(ring.neighbours[ringFace.third].vertex);
        if (isTurnedOver(CollapseMesh::normalOf(mMesh.faces[ringFace.face]), after) || isAgainst(around, after))
            return true;
    }
    return false;
}

/// What the pose itself has folded, or drawn together to nothing, is not looked at.
bool CollapseCheck::allowsInPoses(const OneRing& ring, std::uint32_t neighbour) const
{
    if (!ring.isPosed)
        return true;
    for (std::size_t group = 0; group < mMesh.poses.groups(); ++group) {
        const PosedRing posed(ring, group);
        const Lanes3 whole = posed.wholeArea(), shift = posed.edge(neighbour), there = posed.meanNormal(neighbour);
        for (std::uint32_t i = 0; i < ring.survivorCount; ++i) {
            const OneRing::RingFace& face = ring.faces[ring.survivors[i]];
            const Lanes3 second = posed.edge(face.second), third = posed.edge(face.third);
            const PosedFace posedFace{cross(second, third), cross(second - shift, third - shift),
                                      there + posed.meanNormal(face.second) + posed.meanNormal(face.third)};
            if (turnsInAnyLane(posedFace, whole, kDrawnTogether * mMesh.faces[face.face].area))
                return false;
        }
    }
    return true;
}

/// The common case, settled without a branch: one closed fan whose neighbours, but for those that a face on the edge shares,
/// are strangers to the destination. When it is not that, keepsLink() looks closer.
bool CollapseCheck::isOrdinary(const OneRing& ring, std::uint32_t neighbour) const
{
    const OneRing::Neighbour& end = ring.neighbours[neighbour];
    if (!ring.isFan || ring.faceCount > kOrdinaryFaces)
        return false;
    const std::uint32_t a = ring.faces[end.firstFace].third, b = ring.faces[end.lastFace].second;
    if (a == b || ring.faces[a].third == b || ring.faces[b].third == a)
        return false;
    std::uint32_t others[kOrdinaryFaces];
    std::fill(others, others + kOrdinaryFaces, kNone);
    for (std::uint32_t i = 0; i < ring.neighbourCount; ++i)
        others[i] = ((i == neighbour) | (i == a) | (i == b)) ? kNone : ring.neighbours[i].vertex;
    mMesh.compactFaceList(end.vertex);
    const std::uint32_t* list = mMesh.faceList(end.vertex);
    std::uint32_t isShared[kOrdinaryFaces] = {};
    for (std::uint32_t i = 0; i < mMesh.vertices[end.vertex].liveFaces; ++i)
        for (std::uint32_t wedge : mMesh.faces[list[i]].wedge) {
            const std::uint32_t corner = mMesh.vertexOf(wedge);
            for (std::uint32_t k = 0; k < kOrdinaryFaces; ++k)
                isShared[k] |= others[k] == corner ? 1 : 0;
        }
    return std::find(isShared, isShared + kOrdinaryFaces, 1u) == isShared + kOrdinaryFaces;
}

/// Walks the destination's faces: a common neighbour must be the apex of a face on the edge, and no face of the destination
/// may have two corners that a face of the vertex has as well.
bool CollapseCheck::keepsLink(const OneRing& ring, std::uint32_t neighbour) const
{
    const std::uint32_t destination = ring.neighbours[neighbour].vertex;
    bool fits[OneRing::kMaxNeighbours + 1]; // may be shared; the last is every vertex that is no neighbour
    std::fill(fits, fits + ring.neighbourCount, false);
    fits[neighbour] = fits[ring.neighbourCount] = true;
    for (std::uint32_t i = 0; i < ring.faceCount; ++i)
        if (ring.contains(ring.faces[i], neighbour))
            fits[ring.apexOf(ring.faces[i], neighbour)] = true;
    mMesh.compactFaceList(destination);
    const std::uint32_t* list = mMesh.faceList(destination);
    const std::uint32_t count = mMesh.vertices[destination].liveFaces;
    for (std::uint32_t i = 0; i < count; ++i) {
        const CollapseMesh::Face& face = mMesh.faces[list[i]];
        std::uint32_t common[3], found = 0;
        bool sound = true;
        for (std::uint32_t wedge : face.wedge) {
            const std::uint32_t at = ring.find(mMesh, mMesh.vertexOf(wedge));
            sound &= fits[at];
            common[found] = at;
            found += at != ring.neighbourCount && at != neighbour ? 1 : 0;
        }
        if (!sound || (found == 2 && hasFace(ring, common[0], common[1])))
            return false;
    }
    const OneRing::Neighbour& end = ring.neighbours[neighbour];
    const bool simple =
        ring.apexOf(ring.faces[end.firstFace], neighbour) != ring.apexOf(ring.faces[end.lastFace], neighbour)
        && std::all_of(ring.neighbours, ring.neighbours + ring.neighbourCount,
                       [](const OneRing::Neighbour& other) { return other.faces == 2; });
    return simple || keepsEdgesManifold(ring, neighbour);
}

/// The same asked of the vertex's own neighbours, whose faces are fewer.
bool CollapseCheck::keepsLinkAtHub(const OneRing& ring, std::uint32_t neighbour) const
{
    const std::uint32_t destination = ring.neighbours[neighbour].vertex;
    for (std::uint32_t i = 0; i < ring.neighbourCount; ++i) {
        if (i == neighbour)
            continue;
        const std::uint32_t other = ring.neighbours[i].vertex;
        if (mMesh.vertices[other].liveFaces > OneRing::kMaxFaces)
            return false; // two hubs
        const bool apex = isApex(ring, neighbour, i);
        mMesh.compactFaceList(other);
        const std::uint32_t* list = mMesh.faceList(other);
        for (std::uint32_t k = 0; k < mMesh.vertices[other].liveFaces; ++k) {
            const CollapseMesh::Face& face = mMesh.faces[list[k]];
            const std::uint32_t at[3] = {mMesh.vertexOf(face.wedge[0]), mMesh.vertexOf(face.wedge[1]),
                                         mMesh.vertexOf(face.wedge[2])};
            const bool touches = std::find(at, at + 3, destination) != at + 3;
            if (!touches || std::find(at, at + 3, ring.vertex) != at + 3)
                continue;
            if (!apex)
                return false;
            for (std::uint32_t vertex : at)
                if (vertex != destination && vertex != other)
                    if (const std::uint32_t known = ring.find(mMesh, vertex);
                        known != ring.neighbourCount && hasFace(ring, i, known))
                        return false;
        }
    }
    return keepsEdgesManifold(ring, neighbour);
}

/// Each apex edge of the destination takes over the faces of the vertex's: it has to stay an edge of the surface, and may
/// end up with more than two faces only if one of the two had as many.
bool CollapseCheck::keepsEdgesManifold(const OneRing& ring, std::uint32_t neighbour) const
{
    const std::uint32_t destination = ring.neighbours[neighbour].vertex;
    for (std::uint32_t i = 0; i < ring.neighbourCount; ++i) {
        if (i == neighbour || !isApex(ring, neighbour, i))
            continue;
        std::uint32_t between = 0; // faces on the edge with this apex
        for (std::uint32_t k = 0; k < ring.faceCount; ++k)
            between += ring.contains(ring.faces[k], neighbour) && ring.contains(ring.faces[k], i);
        const std::uint32_t there = facesBetween(destination, ring.neighbours[i].vertex);
        if (there == kNone)
            return false;
        const std::uint32_t after = ring.neighbours[i].faces + there - 2 * between;
        if (after == 0 || after > std::max({2u, std::uint32_t{ring.neighbours[i].faces}, there}))
            return false;
    }
    return true;
}

/// Faces on an edge; kNone when both ends have too many to look through.
std::uint32_t CollapseCheck::facesBetween(std::uint32_t a, std::uint32_t b) const
{
    if (mMesh.vertices[a].liveFaces > mMesh.vertices[b].liveFaces)
        std::swap(a, b);
    if (mMesh.vertices[a].liveFaces > OneRing::kMaxFaces)
        return kNone;
    mMesh.compactFaceList(a);
    const std::uint32_t* list = mMesh.faceList(a);
    std::uint32_t count = 0;
    for (std::uint32_t i = 0; i < mMesh.vertices[a].liveFaces; ++i)
        for (std::uint32_t wedge : mMesh.faces[list[i]].wedge)
            count += mMesh.vertexOf(wedge) == b;
    return count;
}

} // namespace lodsmith
