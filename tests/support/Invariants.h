#pragma once

#include <lodsmith/core/Simplify.h>

#include <cstdint>
#include <string>
#include <vector>

namespace lodsmith::test {

/// How much of the checking is done.
struct InvariantOptions {
    /// Points tried on each surface against LodChainLevel::deviation, by brute force; 0 leaves that check out.
    std::uint32_t samples = 600;
};

/// Everything that has to hold for any chain that simplify() made of `mesh`, checked without code of the library.
/// One sentence for each thing that does not hold; empty when all is well.
///
/// "Position" is a welded one (Weld::Rest). "Input" means the mesh without degenerate and repeated triangles; "clean
/// input" one whose edges have at most two triangles, whose positions have one fan each, and no three of whose positions have
/// two triangles. Checked for every level:
/// - Indices: whole triangles, each corner a vertex that the same submesh uses in the input (so no corner has a wedge of
///   another submesh or of a vertex nobody used). A skipped level has no indices and the counts of the level (or
///   the input) before.
/// - Triangles: none with two corners at one position; none with the submesh, positions and winding of another one.
/// - Counts: vertices and triangles are those that a recount gives.
/// - Monotone: from level to level vertices and triangles do not rise, deviation and cost do not fall.
/// - Borders: an edge with one triangle. There are no more of them than the input has edges with an odd number of triangles
///   (each is the image of one of these). Of clean input, both ends were border positions of one and the same border.
/// - Non-manifold edges (more than two triangles): no more than in the input.
/// - Clean input stays clean: no two triangles on the same three positions, and in a level with as many pieces as the
///   input the Euler characteristic has not fallen (no new hole, no new handle).
/// - Pieces: positions of a level that hang together did so in the input.
/// - Motion: what is said of borders, non-manifold edges, clean input and pieces also holds when only vertices that move
///   together (Weld::Motion) count as one: closed lips stay closed at rest and can still open.
/// - Locks: positions of importance 1, of borders (lockBorders) and with several wedges (lockSeams) are still there.
/// - Deviation: not below the greatest sampled distance from the level to the input or from the input to the level, at rest and
///   in every pose.
/// - Flips: no triangle that faces against every input triangle that is within the deviation of its centre.
/// - Targets: StopReason::TargetReached for counts exactly when the count is met; no level goes beyond its target by
///   more than its last collapse or, where pieces are gone, the last of those; bounds on deviation and cost are kept.
std::vector<std::string> brokenInvariants(const MeshView& mesh, const std::vector<LevelTarget>& targets,
                                          const SimplifyOptions& options, const LodChain& chain,
                                          const InvariantOptions& check = {});

} // namespace lodsmith::test
