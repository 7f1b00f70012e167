#include "VertexCacheOrder.h"

#include <meshoptimizer.h>

#include <algorithm>

namespace lodsmith {

namespace {

/// The optimiser's tables cover all vertices up to the highest index, so a list that uses a short stretch of a large shared
/// buffer is moved to the start of it for the time being.
void orderList(std::vector<std::uint32_t>& triangles)
{
    if (triangles.empty())
        return;
    const auto [lowest, highest] = std::minmax_element(triangles.begin(), triangles.end());
    const std::uint32_t first = *lowest;
    const std::size_t span = std::size_t(*highest) - first + 1;
    for (std::uint32_t& index : triangles)
        index -= first;
    meshopt_optimizeVertexCache(triangles.data(), triangles.data(), triangles.size(), span);
    for (std::uint32_t& index : triangles)
        index += first;
}

} // namespace

void orderForVertexCache(LodChain& chain)
{
    for (LodChainLevel& level : chain.levels)
        for (std::vector<std::uint32_t>& triangles : level.indices)
            orderList(triangles);
}

std::string vertexCacheOrderName()
{
    return "vertex cache order of meshoptimizer " + std::to_string(MESHOPTIMIZER_VERSION);
}

} // namespace lodsmith
