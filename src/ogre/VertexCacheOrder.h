#pragma once

#include <lodsmith/core/LodChain.h>

namespace lodsmith {

/// Reorders the triangles of every list of a chain so that vertices are met again while a GPU still has them in its cache
/// (meshoptimizer's optimizeVertexCache). The triangles and their winding stay the same. Thread-safe for different chains.
void orderForVertexCache(LodChain& chain);

} // namespace lodsmith
