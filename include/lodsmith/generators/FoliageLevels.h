#pragma once

#include <lodsmith/core/Export.h>
#include <lodsmith/core/MeshView.h>
#include <lodsmith/core/Progress.h>
#include <lodsmith/core/Result.h>
#include <lodsmith/core/Simplify.h>

#include <cstdint>
#include <vector>

namespace lodsmith {

/// How leaves are found and judged.
struct FoliageOptions {
    /// For each submesh whether it holds leaves, as a two-sided or alpha-tested material tells; leaves are looked for
    /// in no other one then, and count however few they are. Empty: the shape of the mesh alone tells.
    std::vector<bool> leafSubMeshes = {};
    /// 0.05..1: the share of a leaf's surface that its texture leaves opaque, 1 for leaves without transparency.
    /// Decides how much it takes for leaves behind each other to look closed.
    double leafOpacity = 0.5;
    SimplifyOptions simplify = {}; ///< for what is no leaf, and for single leaves
};

/// One level of a mesh with foliage: fewer leaves, some of them enlarged, the rest of the mesh simplified.
///
/// The vertices are those of the input, in the same buffers and order, so that all attributes and bones are the
/// input's; some are in other places.
struct LODSMITH_API FoliageLevel {
    /// False when even the fewest triangles are more than were allowed; the rest is empty then.
    bool made = false;
    /// As LodChainLevel::indices: one triangle list a submesh of the input.
    std::vector<std::vector<std::uint32_t>> indices;
    /// For each vertex buffer 3 floats a vertex, world units: where its vertices are now.
    std::vector<std::vector<float>> positions;
    /// For each vertex buffer and each of its VertexBufferView::offsets 3 floats a vertex: an enlarged leaf bends as
    /// much more.
    std::vector<std::vector<std::vector<float>>> offsets;
    /// Numbers of the leaves that are left, rising. Each is among those of the level before.
    std::vector<std::uint32_t> leaves;
    std::uint32_t triangles = 0; ///< over all submeshes
    double largestScale = 1.0;   ///< by how much a leaf is enlarged at most, 1..2

    /// The level as a mesh. Shares the memory of this level, which must stay as it is, and of the input.
    MeshView view(const MeshView& original) const;
};

/// All levels of a mesh with foliage.
struct FoliageLevels {
    std::uint32_t leaves = 0;         ///< of the input; 0 when it has no foliage, and there are no levels then
    std::vector<FoliageLevel> levels; ///< one for each count of triangles asked for, in that order
};

/// Makes levels of trees and bushes that cover as much of the picture as the original does.
///
/// Simplification that reuses the vertices of a mesh can only drop leaves, so that crowns thin out. Here a share of the
/// leaves is kept and some of these are enlarged for those that are gone, up to twice (the idea of Cook, Halstead,
/// Planck and Ryu 2007, Stochastic Simplification of Aggregate Detail). Where they choose at random, the choice here is
/// greedy: always the leaf, the size and the number of its triangles that give most coverage for a triangle, in
/// pictures from eight directions around +y, less what they cover beyond the original's outline; then each choice is
/// reconsidered. What is no leaf is simplified by simplify().
///
/// A leaf is a piece that hangs together over edges with nothing else, is a disc (one border, no hole) of at most 64
/// triangles and extends at most three quarters as far as the mesh. A mesh has foliage when there are at least eight
/// leaves, which have at least half of its surface, and none more than a fifth of theirs.
///
/// Errors: InvalidSetting (leafOpacity out of range; leafSubMeshes neither empty nor as long as the submeshes) and
/// those of simplify(). Deterministic. Thread-safe, with the threads of FoliageOptions::simplify; throws nothing.
///
/// @param triangles for each level how many it may have at most, not rising; rising ones are misuse
/// @param progress  may be null
LODSMITH_API Result<FoliageLevels> foliageLevels(const MeshView& mesh, const std::vector<std::uint32_t>& triangles,
                                                 const FoliageOptions& options = {}, Progress* progress = nullptr);

} // namespace lodsmith
