#include "OneRing.h"

namespace lodsmith {

namespace {

constexpr int kNext[3] = {1, 2, 0};

} // namespace

bool OneRing::build(CollapseMesh& mesh, std::uint32_t v)
{
    vertex = v;
    faceCount = neighbourCount = 0;
    isSeam = false;
    mFilter = 0;
    if (mesh.vertices[v].liveFaces == 0 || mesh.vertices[v].liveFaces > kMaxFaces)
        return false;
    mesh.compactFaceList(v);
    origin = mesh.position(v);
    const std::uint32_t* list = mesh.faceList(v);
    faceCount = mesh.vertices[v].liveFaces;
    const std::uint32_t* extraWedgeVertex = mesh.extraWedgeVertex.data();
    const std::uint32_t vertexCount = mesh.vertexCount();
    const auto vertexOf = [=](std::uint32_t wedge) { return wedge < vertexCount ? wedge : extraWedgeVertex[wedge - vertexCount]; };
    for (std::uint32_t i = 0; i < faceCount; ++i) {
        const CollapseMesh::Face& face = mesh.faces[list[i]];
        const std::uint32_t at[3] = {vertexOf(face.wedge[0]), vertexOf(face.wedge[1]), vertexOf(face.wedge[2])};
        const int corner = (at[1] == v) + 2 * (at[2] == v);
        const int second = kNext[corner], third = kNext[second];
        RingFace& entry = faces[i];
        entry.face = list[i];
        entry.corner = static_cast<std::uint8_t>(corner);
        entry.wedge[0] = face.wedge[corner];
        entry.wedge[1] = face.wedge[second];
        entry.wedge[2] = face.wedge[third];
        entry.second = note(mesh, at[second], i);
        entry.third = note(mesh, at[third], i);
        ++asSecond[entry.second];
        ++asThird[entry.third];
        isSeam |= entry.wedge[0] != faces[0].wedge[0];
    }
    return true;
}

/// Written without branches: in a list of faces in no order, whether a neighbour is new cannot be predicted.
inline std::uint16_t OneRing::note(CollapseMesh& mesh, std::uint32_t vertexNumber, std::uint32_t face)
{
    CollapseMesh::Vertex& record = mesh.vertices[vertexNumber];
    const std::uint32_t recorded = record.ringIndex % kMaxNeighbours;
    const bool known = (recorded < neighbourCount) & (neighbour[recorded] == vertexNumber);
    const std::uint32_t i = known ? recorded : neighbourCount;
    record.ringIndex = static_cast<std::uint16_t>(i);
    mFilter |= std::uint64_t{1} << (vertexNumber % 64);
    neighbour[i] = vertexNumber;
    edge[i] = Vec3{record.position[0], record.position[1], record.position[2]} - origin;
    asSecond[i] = known ? asSecond[i] : std::uint16_t{0};
    asThird[i] = known ? asThird[i] : std::uint16_t{0};
    firstFace[i] = known ? firstFace[i] : static_cast<std::uint8_t>(face);
    lastFace[i] = static_cast<std::uint8_t>(face);
    neighbourCount += known ? 0 : 1;
    return static_cast<std::uint16_t>(i);
}

bool OneRing::isBorder() const
{
    for (std::uint32_t i = 0; i < neighbourCount; ++i)
        if (facesOn(i) == 1)
            return true;
    return false;
}

} // namespace lodsmith
