#include "OneRing.h"

#include <algorithm>

namespace lodsmith {

namespace {

constexpr int kNext[3] = {1, 2, 0};

} // namespace

bool OneRing::build(CollapseMesh& mesh, std::uint32_t v)
{
    vertex = v;
    faceCount = neighbourCount = 0;
    isFan = isPlain = isPosed = false;
    if (mesh.vertices[v].liveFaces == 0 || mesh.vertices[v].liveFaces > kMaxFaces)
        return false;
    mesh.compactFaceList(v);
    origin = mesh.position(v);
    faceCount = mesh.vertices[v].liveFaces;
    Corners corners;
    const bool seamNear = readFaces(mesh, corners);
    isFan = linkFan(mesh, corners);
    isPlain = isFan && !seamNear;
    if (!isFan)
        linkAny(mesh, corners);
    if (mesh.poses.count() != 0)
        findPlaces(mesh);
    return true;
}

/// Fills in the faces but for the numbers of their neighbours, and tells whether any wedge is not its vertex's first one.
bool OneRing::readFaces(const CollapseMesh& mesh, Corners& corners)
{
    const std::uint32_t* list = mesh.faceList(vertex);
    const CollapseMesh::Face* meshFaces = mesh.faces.data();
    const std::uint32_t vertexCount = mesh.vertexCount();
    bool seamNear = false;
    for (std::uint32_t i = 0; i < faceCount; ++i) {
        const CollapseMesh::Face& face = meshFaces[list[i]];
        std::uint32_t at[3] = {face.wedge[0], face.wedge[1], face.wedge[2]};
        if (std::max({at[0], at[1], at[2]}) >= vertexCount) {
            seamNear = true;
            for (std::uint32_t& corner : at)
                corner = mesh.vertexOf(corner);
        }
        const int corner = (at[1] == vertex ? 1 : 0) + (at[2] == vertex ? 2 : 0);
        const int next = kNext[corner], afterNext = kNext[next]; // NOLINT(clang-analyzer-core.uninitialized.Assign)
        RingFace& entry = faces[i];
        entry.face = list[i];
        entry.corner = static_cast<std::uint8_t>(corner);
        entry.own = 0;
        entry.wedge[0] = face.wedge[corner];
        entry.wedge[1] = face.wedge[next];
        entry.wedge[2] = face.wedge[afterNext];
        corners.second[i] = at[next];
        corners.third[i] = at[afterNext];
    }
    wedgeCount = 1;
    wedges[0] = faces[0].wedge[0];
    if (seamNear)
        numberWedges();
    return seamNear;
}

void OneRing::numberWedges()
{
    for (std::uint32_t i = 1; i < faceCount; ++i) {
        const std::uint32_t wedge = faces[i].wedge[0];
        const auto own = std::find(wedges, wedges + wedgeCount, wedge) - wedges;
        faces[i].own = static_cast<std::uint8_t>(own);
        if (own == wedgeCount)
            wedges[wedgeCount++] = wedge;
    }
}

/// On closed fans every neighbour is the second corner of one face and the third of another. False when this is something else.
bool OneRing::linkFan(CollapseMesh& mesh, const Corners& corners)
{
    CollapseMesh::Vertex* vertices = mesh.vertices.data();
    for (std::uint32_t i = 0; i < faceCount; ++i) {
        CollapseMesh::Vertex& record = vertices[corners.second[i]];
        record.ringIndex = static_cast<std::uint16_t>(i);
        Neighbour& entry = neighbours[i];
        entry.edge = Vec3{record.position[0], record.position[1], record.position[2]} - origin;
        entry.vertex = corners.second[i];
        entry.faces = 1;
        entry.firstFace = static_cast<std::uint8_t>(i);
    }
    for (std::uint32_t i = 0; i < faceCount; ++i) {
        const std::uint32_t known = vertices[corners.third[i]].ringIndex;
        if (known >= faceCount || neighbours[known].vertex != corners.third[i] || ++neighbours[known].faces != 2)
            return false;
        faces[i].second = static_cast<std::uint16_t>(i);
        faces[i].third = static_cast<std::uint16_t>(known);
        neighbours[known].lastFace = static_cast<std::uint8_t>(i);
    }
    neighbourCount = faceCount;
    return true;
}

/// The corners up to faceCount are filled in by readFaces(); the analyzer loses sight of that.
void OneRing::linkAny(CollapseMesh& mesh, const Corners& corners)
{
    for (std::uint32_t i = 0; i < faceCount; ++i)
        faces[i].second = note(mesh, corners.second[i], i); // NOLINT(clang-analyzer-core.CallAndMessage)
    for (std::uint32_t i = 0; i < faceCount; ++i)
        faces[i].third = note(mesh, corners.third[i], i); // NOLINT(clang-analyzer-core.CallAndMessage)
}

std::uint16_t OneRing::note(CollapseMesh& mesh, std::uint32_t vertexNumber, std::uint32_t face)
{
    CollapseMesh::Vertex& record = mesh.vertices[vertexNumber];
    const std::uint32_t recorded = record.ringIndex;
    if (recorded < neighbourCount && neighbours[recorded].vertex == vertexNumber) {
        Neighbour& entry = neighbours[recorded];
        ++entry.faces;
        entry.lastFace = static_cast<std::uint8_t>(face);
        return record.ringIndex;
    }
    record.ringIndex = static_cast<std::uint16_t>(neighbourCount);
    Neighbour& entry = neighbours[neighbourCount++];
    entry.edge = Vec3{record.position[0], record.position[1], record.position[2]} - origin;
    entry.vertex = vertexNumber;
    entry.faces = 1;
    entry.firstFace = entry.lastFace = static_cast<std::uint8_t>(face);
    return record.ringIndex;
}

/// Each face says where its corners are. They disagree where the surface comes apart.
void OneRing::findPlaces(const CollapseMesh& mesh)
{
    here = mesh.poses.of(mesh.placeOf(faces[0].wedge[0]));
    for (std::uint32_t i = 0; i < neighbourCount; ++i)
        there[i] = mesh.poses.of(mesh.placeOf(wedgeOf(faces[neighbours[i].firstFace], i)));
    const auto agrees = [&](const RingFace& face) {
        return mesh.poses.of(mesh.placeOf(face.wedge[0])) == here
               && mesh.poses.of(mesh.placeOf(face.wedge[1])) == there[face.second]
               && mesh.poses.of(mesh.placeOf(face.wedge[2])) == there[face.third];
    };
    isPosed = mesh.wedgeMotion.empty() || std::all_of(faces, faces + faceCount, agrees);
}

void OneRing::aimAt(std::uint32_t i)
{
    survivorCount = 0;
    for (std::uint32_t k = 0; k < faceCount; ++k) { // without a branch, which no processor could foresee
        survivors[survivorCount] = onEdge[k - survivorCount] = static_cast<std::uint8_t>(k);
        survivorCount += contains(faces[k], i) ? 0 : 1;
    }
    const Vec3& shift = neighbours[i].edge;
    for (std::uint32_t k = 0; k < survivorCount; ++k) {
        const RingFace& face = faces[survivors[k]];
        areaAfter[survivors[k]] = cross(neighbours[face.second].edge - shift, neighbours[face.third].edge - shift);
    }
}

bool OneRing::isBorder() const
{
    if (isFan)
        return false;
    for (std::uint32_t i = 0; i < neighbourCount; ++i)
        if (neighbours[i].faces == 1)
            return true;
    return false;
}

} // namespace lodsmith
