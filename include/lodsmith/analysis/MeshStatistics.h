#pragma once

#include <lodsmith/core/Export.h>
#include <lodsmith/core/MeshView.h>
#include <lodsmith/core/Result.h>

#include <cstdint>

namespace lodsmith {

/// Counts that tell what a mesh is made of. "Welded" means: referenced positions, equal ones (exactly equal; -0 is 0)
/// taken as one, whatever their attributes, poses or bones. Triangles with two corners at one position have no edges
/// and belong to no component.
struct MeshStatistics {
    std::uint32_t bufferVertices = 0;
    std::uint32_t triangles = 0;
    std::uint32_t vertices = 0;             ///< welded
    std::uint32_t unreferencedVertices = 0; ///< buffer vertices that no triangle uses
    std::uint32_t edges = 0;                ///< between welded vertices
    std::uint32_t borderEdges = 0;          ///< with one triangle
    std::uint32_t nonManifoldEdges = 0;     ///< with more than two triangles
    std::uint32_t inconsistentEdges = 0;    ///< with two triangles that run the same way along it (mixed winding)
    /// Edges with two triangles that disagree, at either end, about a coordinate of a texture coordinate set both have.
    std::uint32_t uvSeamEdges = 0;
    std::uint32_t normalSeamEdges = 0;     ///< the same about the normal
    std::uint32_t materialEdges = 0;       ///< edges with two triangles, of different submeshes
    std::uint32_t degenerateTriangles = 0; ///< zero area, or two corners at one position
    std::uint32_t repeatedTriangles = 0;   ///< same three different positions as an earlier triangle, either winding
    std::uint32_t components = 0;          ///< pieces connected over edges
    double radius = 0.0;      ///< world units: farthest referenced position from the centre of their bounding box
    double surfaceArea = 0.0; ///< world units squared
};

/// Counts a mesh. Errors: IndexOutOfRange, InvalidGeometry (a referenced position is not finite), OutOfMemory; with
/// submesh and index or vertex. Thread-safe; throws nothing.
LODSMITH_API Result<MeshStatistics> meshStatistics(const MeshView& mesh);

} // namespace lodsmith
