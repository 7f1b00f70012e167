#include "OneRing.h"

namespace lodsmith {

bool OneRing::build(CollapseMesh& mesh, std::uint32_t v)
{
    vertex = v;
    faceCount = neighbourCount = 0;
    isSeam = false;
    if (mesh.vertices[v].liveFaces == 0 || mesh.vertices[v].liveFaces > kMaxFaces)
        return false;
    mesh.compactFaceList(v);
    origin = mesh.position(v);
    const std::uint32_t* list = mesh.faceList(v);
    faceCount = mesh.vertices[v].liveFaces;
    for (std::uint32_t i = 0; i < faceCount; ++i) {
        const CollapseMesh::Face& face = mesh.faces[list[i]];
        const std::uint32_t at[3] = {mesh.vertexOf(face.wedge[0]), mesh.vertexOf(face.wedge[1]), mesh.vertexOf(face.wedge[2])};
        const int corner = at[0] == v ? 0 : at[1] == v ? 1 : 2;
        const int second = corner == 2 ? 0 : corner + 1, third = corner == 0 ? 2 : corner - 1;
        RingFace& entry = faces[i];
        entry.face = list[i];
        entry.corner = static_cast<std::uint8_t>(corner);
        entry.wedge[0] = face.wedge[corner];
        entry.wedge[1] = face.wedge[second];
        entry.wedge[2] = face.wedge[third];
        entry.second = indexOf(mesh, at[second], i);
        entry.third = indexOf(mesh, at[third], i);
        ++asSecond[entry.second];
        ++asThird[entry.third];
        isSeam |= entry.wedge[0] != faces[0].wedge[0];
    }
    return true;
}

inline std::uint16_t OneRing::indexOf(CollapseMesh& mesh, std::uint32_t vertexNumber, std::uint32_t face)
{
    if (const int known = find(mesh, vertexNumber); known >= 0) {
        lastFace[known] = static_cast<std::uint8_t>(face);
        return static_cast<std::uint16_t>(known);
    }
    firstFace[neighbourCount] = lastFace[neighbourCount] = static_cast<std::uint8_t>(face);
    neighbour[neighbourCount] = vertexNumber;
    edge[neighbourCount] = mesh.position(vertexNumber) - origin;
    asSecond[neighbourCount] = asThird[neighbourCount] = 0;
    mesh.vertices[vertexNumber].ringIndex = neighbourCount;
    return static_cast<std::uint16_t>(neighbourCount++);
}

bool OneRing::isBorder() const
{
    for (std::uint32_t i = 0; i < neighbourCount; ++i)
        if (facesOn(i) == 1)
            return true;
    return false;
}

} // namespace lodsmith
