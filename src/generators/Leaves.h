#pragma once

#include <lodsmith/core/MeshView.h>
#include <lodsmith/core/Result.h>
#include <lodsmith/generators/FoliageLevels.h>

#include <array>
#include <cstdint>
#include <vector>

namespace lodsmith::generators {

using Point = std::array<double, 3>;

/// A triangle with its place in the mesh.
struct LeafTriangle {
    std::uint32_t subMesh = 0;
    std::array<std::uint32_t, 3> vertex = {}; ///< in the submesh's vertex buffer
    std::array<Point, 3> corner = {};
};

/// A leaf in several forms, each a selection of the leaf's vertices.
struct Leaf {
    std::vector<std::vector<LeafTriangle>> forms; ///< the input's first, then with fewer and fewer triangles
    Point centre = {};                            ///< of its surface
    double area = 0.0;
};

/// A mesh taken apart.
struct Foliage {
    std::vector<Leaf> leaves;                     ///< each with one form
    std::vector<std::vector<std::uint32_t>> wood; ///< what is no leaf: one triangle list a submesh
    Point centre = {};                            ///< of the bounding box
    double radius = 0.0;                          ///< farthest position from there
};

/// World units squared.
double areaOf(const std::array<Point, 3>& corner);

/// Finds the leaves of a mesh, as foliageLevels() tells. Leaves without area are in neither part. When the mesh has no
/// foliage there are no leaves, and the wood is empty too.
/// Errors: IndexOutOfRange, InvalidGeometry (a referenced position is not finite).
Result<Foliage> findLeaves(const MeshView& mesh, const FoliageOptions& options);

} // namespace lodsmith::generators
