#pragma once

#include "CollapseMesh.h"
#include "FaceIndex.h"
#include "OneRing.h"

#include <vector>

namespace lodsmith {

/// Takes small pieces of surface away whole: those that hang together with nothing else and that no collapse makes smaller,
/// like a leaf card that is down to one triangle.
///
/// The piece is left to the face nearest to its centre. No point of the piece is farther from that one than the farthest of
/// its vertices is (the distance to a triangle is a convex function), which bounds what is lost; in every pose alike.
class PieceRemoval {
public:
    explicit PieceRemoval(CollapseMesh& mesh) : mMesh(mesh), mIndex(mesh) {}

    /// Looks at the piece that a ring belongs to. False when it has more than 8 faces, or when it is all that is left.
    bool find(const OneRing& ring);

    /// What find() has found, until the mesh changes. Scaled units.
    const std::vector<std::uint32_t>& vertices() const { return mVertices; }
    const std::vector<std::uint32_t>& faces() const { return mFaces; }
    double area() const { return mArea; }
    double distance() const
    {
        return mDistance;
    } ///< of its vertices from what stays, root mean square over rest and poses
    double deviation() const { return mDeviation; } ///< bound on the distance of the original surface from what stays

    /// Takes the piece that was found out of the mesh.
    void remove();

private:
    bool collect(const OneRing& ring);
    std::uint32_t add(std::uint32_t vertex);
    std::uint32_t addNeighbours(std::uint32_t vertex);
    bool isInPiece(std::uint32_t vertex) const;
    void measure();
    void measureInPoses(double& squares, double& largest) const;

    CollapseMesh& mMesh;
    FaceIndex mIndex;
    std::vector<std::uint32_t> mVertices, mFaces;
    std::uint32_t mHeir = kNone; ///< the face that the piece is left to
    double mArea = 0.0, mDistance = 0.0, mDeviation = 0.0;
};

} // namespace lodsmith
