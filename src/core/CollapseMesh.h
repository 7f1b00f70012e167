#pragma once

#include "ClosestPoint.h"
#include "Poses.h"
#include "Prefetch.h"
#include "Vec3.h"

#include <lodsmith/core/LodChain.h>
#include <lodsmith/core/MeshView.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace lodsmith {

constexpr std::uint32_t kNone = 0xFFFFFFFFu;

/// The mesh while it is being collapsed: welded vertices, their wedges, and triangles over wedges.
///
/// A vertex is a position; a wedge is one set of attributes at it, in one submesh. The first wedge of vertex v has
/// number v, further ones are numbered from vertexCount() on. Positions are scaled by a power of two (exactly) so that
/// the bounding radius lies in [0.5, 1). Faces keep their numbers for good, so that those of a submesh are a range.
class CollapseMesh {
public:
    /// Two to a cache line. Corner order is the winding.
    struct Face {
        std::uint32_t wedge[3]; ///< wedge[0] is kNone when the face is gone
        float deviation;        ///< bound on the distance between here and the original surface, scaled
        float normal[3];        ///< unit, or zero on a face without area
        float area;
    };

    struct Vertex {
        float position[3];
        std::uint32_t firstFace;    ///< where in mFaceLists its faces begin
        std::uint32_t faceSlots;    ///< entries in use there, some of them possibly faces that are gone
        std::uint32_t faceCapacity; ///< entries reserved there
        std::uint32_t liveFaces;    ///< faces not gone
        std::uint16_t ringIndex;    ///< scratch of OneRing
        bool hasSeam;               ///< more than one wedge
    };

    std::uint32_t vertexCount() const { return static_cast<std::uint32_t>(vertices.size()); }
    std::uint32_t vertexOf(std::uint32_t wedge) const
    {
        return wedge < vertices.size() ? wedge : extraWedgeVertex[wedge - vertices.size()];
    }
    Vec3 position(std::uint32_t vertex) const
    {
        const float* p = vertices[vertex].position;
        return {p[0], p[1], p[2]};
    }
    Corners cornersOf(const Face& face) const
    {
        return {position(vertexOf(face.wedge[0])), position(vertexOf(face.wedge[1])),
                position(vertexOf(face.wedge[2]))};
    }
    static Vec3 normalOf(const Face& face) { return {face.normal[0], face.normal[1], face.normal[2]}; }
    bool isAlive(std::uint32_t vertex) const { return vertices[vertex].liveFaces != 0; }
    bool isGone(const Face& face) const { return face.wedge[0] == kNone; }
    std::uint32_t subMeshOfWedge(std::uint32_t wedge) const { return wedgeSubMesh.empty() ? 0 : wedgeSubMesh[wedge]; }
    std::uint32_t subMeshOf(const Face& face) const { return subMeshOfWedge(face.wedge[0]); }
    std::uint32_t motionOf(std::uint32_t wedge) const { return wedgeMotion.empty() ? 0 : wedgeMotion[wedge]; }
    /// Where poses keep a wedge.
    std::uint32_t placeOf(std::uint32_t wedge) const
    {
        return wedgeMotion.empty() ? vertexOf(wedge) : wedgeMotion[wedge];
    }
    const float* attributesOf(std::uint32_t wedge) const
    {
        return attributes.data() + std::size_t{wedge} * attributeStride;
    }

    /// Squared, between two wedges.
    float attributeDistance(std::uint32_t a, std::uint32_t b) const
    {
        const float *va = attributesOf(a), *vb = attributesOf(b);
        float even = 0.0f, odd = 0.0f;
        for (std::size_t k = 0; k < attributeStride; k += 2) {
            const float first = va[k] - vb[k], second = va[k + 1] - vb[k + 1];
            even += first * first;
            odd += second * second;
        }
        return even + odd;
    }

    /// Squared length of (target - here) + s * (second - here) + t * (third - here).
    float secondDifference(std::uint32_t here, std::uint32_t target, std::uint32_t second, float s, std::uint32_t third,
                           float t) const
    {
        const float *h = attributesOf(here), *d = attributesOf(target), *a = attributesOf(second),
                    *b = attributesOf(third);
        float sum[2] = {0.0f, 0.0f};
        for (std::size_t k = 0; k < attributeStride; k += 2)
            for (std::size_t lane = 0; lane < 2; ++lane) {
                const std::size_t i = k + lane;
                const float difference = d[i] - h[i] + s * (a[i] - h[i]) + t * (b[i] - h[i]);
                sum[lane] += difference * difference;
            }
        return sum[0] + sum[1];
    }

    const std::uint32_t* faceList(std::uint32_t vertex) const { return mFaceLists.data() + vertices[vertex].firstFace; }

    /// Four links of a chain; each reads what the one before has asked for.
    void prefetchVertex(std::uint32_t vertex) const { prefetch(&vertices[vertex]); }
    void prefetchFaceList(std::uint32_t vertex) const { prefetch(faceList(vertex)); }
    void prefetchFaces(std::uint32_t vertex) const;
    void prefetchNeighbours(std::uint32_t vertex) const;

    /// Drops entries of faces that are gone from a vertex's list.
    void compactFaceList(std::uint32_t vertex);

    /// @param doubledArea normal, of twice the area's length
    static void setPlane(Face& face, const Vec3& doubledArea);

    /// Computes the planes of all faces, and keeps what the collapses have to be compared with.
    void buildPlanes();

    /// Mean of the unit normals that the faces around a vertex had in the input, weighted by their angles; in steps.
    Vec3 meanNormal(std::uint32_t vertex) const
    {
        const auto& n = meanNormals[vertex];
        return {double(n[0]), double(n[1]), double(n[2])};
    }
    static constexpr float kNormalSteps = 127.0f; ///< in one

    /// Counts the vertices and faces that there are.
    void countFaces();

    /// Lists the faces of every vertex, once they are counted.
    void buildFaceLists();

    /// Gives the lists' memory back until they are built again.
    void dropFaceLists() { std::vector<std::uint32_t>().swap(mFaceLists); }

    /// Gives the remaining faces of a vertex to another; the first is gone with that.
    void moveFaces(std::uint32_t from, std::uint32_t to, const std::uint32_t* moved, std::uint32_t count);

    /// Lets a face, or those of a vertex, have at least this bound on their deviation.
    void raiseFaceDeviation(std::uint32_t face, double deviation);
    void raiseDeviation(std::uint32_t vertex, double deviation);

    /// Takes a face out; vertices left without a face are gone with it.
    void removeFace(std::uint32_t face);

    std::vector<Vertex> vertices;
    std::vector<Face> faces;
    std::vector<std::uint32_t> firstFaceOfSubMesh; ///< submesh count + 1 entries

    std::vector<std::uint32_t> extraWedgeVertex; ///< vertex of wedge vertexCount() + i
    std::vector<std::uint32_t> nextWedge;        ///< next wedge at the same vertex, or kNone
    std::vector<std::uint32_t> wedgeSource;      ///< index in its vertex buffer
    std::vector<std::uint32_t> wedgeSubMesh;     ///< submesh; empty when there is only one
    std::vector<std::uint32_t> wedgeMotion;      ///< equal where wedges of a vertex move together; empty when all do
    std::vector<float> importance;               ///< of each vertex, 0..1; empty when all are 0
    std::vector<std::array<std::int8_t, 3>> meanNormals; ///< in steps, to save memory: half a degree is near enough

    Poses poses; ///< empty when rest is all that counts

    std::size_t attributeStride = 0; ///< floats a wedge, even; 0 when no attribute counts
    std::vector<float> attributes;   ///< scaled and weighted, so that their squares add to squared distances

    /// What is added to a face's area in costs: a share of the mean face's, so that tips and thin parts, whose faces are
    /// small, are not given away for nothing.
    float areaBonus() const { return kMeanShare * static_cast<float>(area / (liveFaces + facesElsewhere)); }

    double area = 0.0; ///< of all faces of the input, scaled
    std::uint32_t liveVertices = 0;
    std::uint32_t liveFaces = 0;
    std::uint32_t facesElsewhere = 0; ///< of a mesh of which this is a part
    double scale = 1.0;               ///< power of two: scaled = world * scale
    LodChain summary;                 ///< figures of the input, no levels

private:
    static constexpr float kMeanShare = 0.3f; // chosen on the curve of mean and maximum deviation over it

    void growFaceList(Vertex& vertex, std::uint32_t needed);
    void compactAllFaceLists();

    std::vector<std::uint32_t> mFaceLists;
};

} // namespace lodsmith
