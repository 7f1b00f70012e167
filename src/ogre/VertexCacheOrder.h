#pragma once

#include <lodsmith/core/LodChain.h>

#include <string>

namespace lodsmith {

/// Reorders the triangles of every list of a chain so that vertices are met again while a GPU still has them in its cache
/// (meshoptimizer's optimizeVertexCache). The triangles and their winding stay the same. Thread-safe for different chains.
void orderForVertexCache(LodChain& chain);

/// What orderForVertexCache() does, for the key of a cache: another order has another name.
std::string vertexCacheOrderName();

} // namespace lodsmith
