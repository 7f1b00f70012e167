#pragma once

#include "Peer.h"

#include <lodsmith/core/LodChain.h>

namespace lodsmith::benchmarks {

/// The original's triangles as a level.
LevelIndices originalIndices(const MeshView& view);

/// Reads the chain off an OGRE mesh; a level that its generator skipped repeats the one before.
/// @param skipped  one entry for each level that was asked for
std::vector<PeerLevel> storedLevels(const Subject& subject, const std::vector<bool>& skipped);

/// The levels of a chain from simplify(); a skipped one repeats the one before.
std::vector<PeerLevel> chainLevels(const MeshView& original, const LodChain& chain);

/// The word for a stop reason in tables; empty for a target that is met.
const char* stopWord(StopReason stop);

} // namespace lodsmith::benchmarks
