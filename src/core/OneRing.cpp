#include "OneRing.h"

namespace lodsmith {

namespace {

constexpr int kNext[3] = {1, 2, 0};

} // namespace

bool OneRing::build(CollapseMesh& mesh, std::uint32_t v)
{
    vertex = v;
    faceCount = neighbourCount = 0;
    mFilter = 0;
    isSeam = isPlain = false;
    if (mesh.vertices[v].liveFaces == 0 || mesh.vertices[v].liveFaces > kMaxFaces)
        return false;
    mesh.compactFaceList(v);
    origin = mesh.position(v);
    faceCount = mesh.vertices[v].liveFaces;
    std::uint32_t third[kMaxFaces];
    const bool seamNear = readFaces(mesh, third);
    // On an orientable fan every neighbour is the second corner of one face and the third of another.
    for (std::uint32_t i = 0; i < faceCount; ++i)
        faces[i].third = noteAgain(mesh, third[i], i);
    isPlain = !seamNear;
    for (std::uint32_t i = 0; i < neighbourCount; ++i)
        isPlain &= neighbours[i].faces == 2;
    return true;
}

/// Fills in the faces and their second corners, hands out their third ones, and tells whether any wedge is not its vertex's only one.
bool OneRing::readFaces(CollapseMesh& mesh, std::uint32_t* third)
{
    const std::uint32_t* list = mesh.faceList(vertex);
    const std::uint32_t* extraWedgeVertex = mesh.extraWedgeVertex.data();
    const std::uint32_t vertexCount = mesh.vertexCount();
    const auto vertexOf = [=](std::uint32_t wedge) { return wedge < vertexCount ? wedge : extraWedgeVertex[wedge - vertexCount]; };
    bool seamNear = false;
    for (std::uint32_t i = 0; i < faceCount; ++i) {
        const CollapseMesh::Face& face = mesh.faces[list[i]];
        const std::uint32_t at[3] = {vertexOf(face.wedge[0]), vertexOf(face.wedge[1]), vertexOf(face.wedge[2])};
        const int corner = (at[1] == vertex) + 2 * (at[2] == vertex);
        const int next = kNext[corner], afterNext = kNext[next];
        RingFace& entry = faces[i];
        entry.face = list[i];
        entry.corner = static_cast<std::uint8_t>(corner);
        entry.wedge[0] = face.wedge[corner];
        entry.wedge[1] = face.wedge[next];
        entry.wedge[2] = face.wedge[afterNext];
        entry.second = note(mesh, at[next], i);
        third[i] = at[afterNext];
        isSeam |= entry.wedge[0] != faces[0].wedge[0];
        seamNear |= (at[0] != face.wedge[0]) | (at[1] != face.wedge[1]) | (at[2] != face.wedge[2]);
    }
    return seamNear || isSeam;
}

/// Written without branches: in a list of faces in no order, whether a neighbour is new cannot be predicted.
inline std::uint16_t OneRing::note(CollapseMesh& mesh, std::uint32_t vertexNumber, std::uint32_t face)
{
    CollapseMesh::Vertex& record = mesh.vertices[vertexNumber];
    const std::uint32_t recorded = record.ringIndex % kMaxNeighbours;
    const bool known = (recorded < neighbourCount) & (neighbours[recorded].vertex == vertexNumber);
    const std::uint32_t i = known ? recorded : neighbourCount;
    record.ringIndex = static_cast<std::uint16_t>(i);
    mFilter |= std::uint64_t{1} << (vertexNumber % 64);
    Neighbour& entry = neighbours[i];
    entry.vertex = vertexNumber;
    entry.edge = Vec3{record.position[0], record.position[1], record.position[2]} - origin;
    entry.faces = static_cast<std::uint16_t>(known ? entry.faces + 1 : 1);
    entry.firstFace = known ? entry.firstFace : static_cast<std::uint8_t>(face);
    entry.lastFace = static_cast<std::uint8_t>(face);
    neighbourCount += known ? 0 : 1;
    return static_cast<std::uint16_t>(i);
}

inline std::uint16_t OneRing::noteAgain(CollapseMesh& mesh, std::uint32_t vertexNumber, std::uint32_t face)
{
    const std::uint32_t i = mesh.vertices[vertexNumber].ringIndex % kMaxNeighbours;
    if (i >= neighbourCount || neighbours[i].vertex != vertexNumber)
        return note(mesh, vertexNumber, face);
    ++neighbours[i].faces;
    neighbours[i].lastFace = static_cast<std::uint8_t>(face);
    return static_cast<std::uint16_t>(i);
}

bool OneRing::isBorder() const
{
    for (std::uint32_t i = 0; i < neighbourCount; ++i)
        if (neighbours[i].faces == 1)
            return true;
    return false;
}

} // namespace lodsmith
