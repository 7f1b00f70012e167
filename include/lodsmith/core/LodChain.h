#pragma once

#include <cstdint>
#include <vector>

namespace lodsmith {

/// Why a level holds no fewer vertices than it does.
enum class StopReason {
    TargetReached, ///< the level's target is met, or all that its bound on deviation or cost allows is done
    Locked,        ///< what is left is locked (importance 1, border or seam locks)
    Seam,          ///< what is left would need a wedge that a submesh does not have at the destination
    Topology, ///< what is left would open a hole, pinch the surface, double a face or flip one, or is the last piece
};

/// One level of detail.
struct LodChainLevel {
    /// One triangle list per submesh of the input, indexing that submesh's own vertex buffer. Empty lists are possible.
    std::vector<std::vector<std::uint32_t>> indices;
    std::uint32_t vertices = 0;  ///< referenced positions after welding
    std::uint32_t triangles = 0; ///< over all submeshes
    /// World units; no point of this level is farther from the original surface than this, nor the other way round, at rest
    /// or in a pose of the mesh (CleaningReport's triangles set aside). Includes a ten-millionth of the radius (in the pose
    /// where it is largest) for rounding, and how far vertices that count as one are apart in poses; a Deviation target
    /// counts neither.
    double deviation = 0.0;
    /// World units: the dearest collapse so far, as a length (CollapseCost in LevelTarget).
    double cost = 0.0;
    StopReason stop = StopReason::TargetReached;
    /// True when the level has the same vertices as the one before: it has no indices of its own and need not be stored.
    /// Whoever chooses among a chain's levels marks the others so too.
    bool skipped = false;
};

/// What was left out of the generated levels because it draws nothing. The input itself is never changed.
struct CleaningReport {
    std::uint32_t degenerateTriangles = 0;  ///< two corners at one position
    std::uint32_t repeatedTriangles = 0;    ///< same submesh, same three positions, same winding as an earlier one
    std::uint32_t unreferencedVertices = 0; ///< buffer vertices that no triangle uses
};

/// A mesh's chain of levels, coarser and coarser. Level 0 (the input) is described but not repeated.
struct LodChain {
    std::uint32_t vertices = 0;       ///< of the input: referenced positions after welding
    std::uint32_t bufferVertices = 0; ///< of the input: vertices in all buffers
    std::uint32_t triangles = 0;      ///< of the input, before cleaning
    double radius = 0.0;              ///< world units: farthest referenced position from the bounding box's centre
    CleaningReport cleaned;
    std::vector<LodChainLevel> levels; ///< one for each target asked for, in that order
};

} // namespace lodsmith
