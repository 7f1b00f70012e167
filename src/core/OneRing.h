#pragma once

#include "CollapseMesh.h"
#include "Vec3.h"

#include <cstdint>

namespace lodsmith {

/// The faces around a vertex and the vertices around those, gathered once for cost, checks, deviation and collapse.
class OneRing {
public:
    /// A vertex with more faces is not collapsed until its neighbours' collapses have made it smaller. This keeps the work
    /// on a fan of n triangles linear; meshes of ordinary valence never notice.
    static constexpr std::uint32_t kMaxFaces = 128;

    struct RingFace {
        std::uint32_t face;
        std::uint16_t second, third; ///< neighbours at the next corner and the one after, in winding order
        std::uint32_t wedge[3];      ///< of this vertex, the second and the third corner
        std::uint8_t corner;         ///< this vertex's corner in the face
        std::uint8_t own;            ///< which of this vertex's wedges it has
    };

    static constexpr std::uint32_t kMaxNeighbours = 2 * kMaxFaces;

    struct Neighbour {
        Vec3 edge; ///< from this vertex to the neighbour
        std::uint32_t vertex;
        std::uint16_t faces;    ///< faces on the edge
        std::uint8_t firstFace; ///< of those
        std::uint8_t lastFace;  ///< the same as the first on a border
    };

    std::uint32_t vertex = kNone;
    Vec3 origin;
    std::uint32_t faceCount = 0;
    std::uint32_t neighbourCount = 0;
    bool isFan = false;   ///< closed fans only, and neighbour i is the second corner of face i; never mind seams
    bool isPlain = false; ///< a fan without a seam at or near this vertex

    std::uint32_t wedgeCount = 0;
    std::uint32_t wedges[kMaxFaces]; ///< those of this vertex that are in use, in the order of the faces
    RingFace faces[kMaxFaces];
    Neighbour neighbours[kMaxNeighbours];

    // Of a mesh with poses:
    bool isPosed = false; ///< there are poses, and nothing at this vertex comes apart in them
    const Poses::Group* here = nullptr;
    const Poses::Group* there[kMaxNeighbours]; ///< neighbours

    // As of aimAt():
    std::uint32_t survivorCount = 0;
    std::uint8_t survivors[kMaxFaces]; ///< ring faces that outlast the collapse
    std::uint8_t onEdge[kMaxFaces];    ///< the faceCount - survivorCount others
    Vec3 areaAfter[kMaxFaces];         ///< of ring faces, survivors only: normal, of twice the area's length

    /// Fills this ring; false, with an empty ring, when the vertex has no face or too many.
    bool build(CollapseMesh& mesh, std::uint32_t vertex);

    /// Number of a vertex in this ring, neighbourCount when it is no neighbour. Each neighbour's record holds the number it
    /// got in the ring that was built last; that it is ours, the ring itself confirms.
    std::uint32_t find(const CollapseMesh& mesh, std::uint32_t vertexNumber) const
    {
        const std::uint32_t i = mesh.vertices[vertexNumber].ringIndex % kMaxNeighbours;
        return i < neighbourCount && neighbours[i].vertex == vertexNumber ? i : neighbourCount;
    }

    /// Looks at the collapse onto neighbour i: which faces outlast it, and what they are then.
    void aimAt(std::uint32_t i);

    bool contains(const RingFace& face, std::uint32_t i) const { return (face.second == i) | (face.third == i); }
    std::uint32_t apexOf(const RingFace& face, std::uint32_t i) const
    {
        return face.second == i ? face.third : face.second;
    }
    std::uint32_t wedgeOf(const RingFace& face, std::uint32_t i) const
    {
        return face.second == i ? face.wedge[1] : face.wedge[2];
    }
    bool isBorder() const;
    bool isSeam() const { return wedgeCount > 1; }

private:
    /// Vertices at the faces' second and third corners.
    struct Corners {
        std::uint32_t second[kMaxFaces], third[kMaxFaces];
    };

    void numberWedges();
    bool readFaces(const CollapseMesh& mesh, Corners& corners);
    bool linkFan(CollapseMesh& mesh, const Corners& corners);
    void linkAny(CollapseMesh& mesh, const Corners& corners);
    void findPlaces(const CollapseMesh& mesh);
    std::uint16_t note(CollapseMesh& mesh, std::uint32_t vertexNumber, std::uint32_t face);
};

} // namespace lodsmith
