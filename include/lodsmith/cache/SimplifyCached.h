#pragma once

#include <lodsmith/cache/LodCache.h>
#include <lodsmith/core/Export.h>
#include <lodsmith/core/Progress.h>
#include <lodsmith/core/Result.h>
#include <lodsmith/core/Simplify.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace lodsmith {

/// A chain, and what the cache had to do with it.
struct CachedChain {
    LodChain chain;
    bool found = false;             ///< it came from the cache
    std::optional<Error> notStored; ///< it was made, but could not be stored: why
};

/// What is done to a chain after simplify() and before it is stored, so that a later start finds it done.
struct ChainFinish {
    std::string name;                     ///< in the key: what gives other chains has another name
    std::function<void(LodChain&)> apply; ///< null for nothing; the same input gives the same output
};

/// As simplify(), but what the cache has is not made again, and what it has not is stored.
///
/// The same result as simplify() and `finish` after it, the same errors and promises. A chain that does not fit the mesh (a
/// damaged or forged entry, or another mesh of the same key) is never returned: it is made anew. Trouble with the cache is no
/// error. What `finish` throws goes through, and nothing is stored.
///
/// @param inputRead as for simplify(); when the chain is found, before this returns
/// @param finish    called on the calling thread, unless the chain is found
LODSMITH_API Result<CachedChain> simplifyCached(LodCache& cache, const MeshView& mesh,
                                                const std::vector<LevelTarget>& targets,
                                                const SimplifyOptions& options = {}, Progress* progress = nullptr,
                                                const std::function<void()>& inputRead = {},
                                                const ChainFinish& finish = {});

} // namespace lodsmith
