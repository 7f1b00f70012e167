#pragma once

#include "MeshBuilders.h"

#include <lodsmith/core/LodChain.h>
#include <lodsmith/core/MeshView.h>

#include <array>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace lodsmith::test {

using IndexLists = std::vector<std::vector<std::uint32_t>>; ///< one triangle list per submesh

/// What makes two vertices one.
enum class Weld {
    Rest,  ///< equal positions; -0 equals +0
    Motion ///< also equal pose offsets (a missing one is zero), and bone influences or, without such, motions in poses
};

/// Names of a mesh's positions, made without any code of the library: welded vertices have one number, over all buffers.
struct WeldedPositions {
    std::vector<std::vector<std::uint32_t>> of; ///< [vertex buffer][vertex]
    std::vector<Point> points;                  ///< by number
};

WeldedPositions weldPositions(const MeshView& mesh, Weld weld = Weld::Rest);

/// A triangle by vertices of its submesh's buffer, and by welded positions.
struct WeldedTriangle {
    std::uint32_t subMesh = 0;
    std::array<std::uint32_t, 3> vertices{};
    std::array<std::uint32_t, 3> positions{};

    /// Two corners at one position: draws nothing.
    bool degenerate() const;
    /// The positions, turned so that the least comes first; the winding is kept.
    std::array<std::uint32_t, 3> turned() const;
    /// The positions in rising order; both windings give the same.
    std::array<std::uint32_t, 3> sorted() const;
};

/// The triangles of `lists`; indices have to be in range.
std::vector<WeldedTriangle> weldedTriangles(const MeshView& mesh, const WeldedPositions& welded,
                                            const IndexLists& lists);

/// A mesh's own index lists.
IndexLists indexLists(const MeshView& mesh);

/// `triangles` without degenerate ones and without later repetitions (same submesh, positions and winding); what was
/// left out is added to `report`.
std::vector<WeldedTriangle> cleaned(const std::vector<WeldedTriangle>& triangles, CleaningReport& report);

std::uint32_t countPositions(const std::vector<WeldedTriangle>& triangles);

using Edge = std::pair<std::uint32_t, std::uint32_t>; ///< welded positions, the lesser first

/// What the connectivity of a set of triangles that are not degenerate looks like.
struct Connectivity {
    explicit Connectivity(const std::vector<WeldedTriangle>& triangles);

    std::map<Edge, std::uint32_t> edges; ///< triangles on each edge
    std::map<std::uint32_t, std::uint32_t>
        fans; ///< for each position, groups of triangles that hang together over edges at it
    std::map<std::uint32_t, std::uint32_t>
        borderOf; ///< for each border position the number of its border (edges with one triangle)
    std::map<std::uint32_t, std::uint32_t> pieceOf; ///< for each position the number of its connected piece
    std::uint32_t triangles = 0;
    std::uint32_t borderEdges = 0;      ///< with one triangle
    std::uint32_t oddEdges = 0;         ///< with an odd number of triangles
    std::uint32_t nonManifoldEdges = 0; ///< with more than two triangles
    std::uint32_t pieces = 0;

    /// No edge has more than two triangles and no position more than one fan.
    bool manifold() const;
    /// Vertices - edges + faces.
    long eulerCharacteristic() const;
};

} // namespace lodsmith::test
