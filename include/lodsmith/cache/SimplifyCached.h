#pragma once

#include <lodsmith/cache/LodCache.h>
#include <lodsmith/core/Export.h>
#include <lodsmith/core/Progress.h>
#include <lodsmith/core/Result.h>
#include <lodsmith/core/Simplify.h>

#include <optional>
#include <vector>

namespace lodsmith {

/// A chain, and what the cache had to do with it.
struct CachedChain {
    LodChain chain;
    bool found = false;             ///< it came from the cache
    std::optional<Error> notStored; ///< it was made, but could not be stored: why
};

/// As simplify(), but what the cache has is not made again, and what it has not is stored.
///
/// The same result, errors and promises as simplify(). A chain that does not fit the mesh (a damaged or forged entry, or
/// another mesh of the same key) is never returned: it is made anew. Trouble with the cache is no error.
LODSMITH_API Result<CachedChain> simplifyCached(LodCache& cache, const MeshView& mesh,
                                                const std::vector<LevelTarget>& targets,
                                                const SimplifyOptions& options = {}, Progress* progress = nullptr);

} // namespace lodsmith
