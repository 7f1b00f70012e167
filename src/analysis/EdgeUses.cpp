#include "EdgeUses.h"

#include <algorithm>
#include <tuple>

namespace lodsmith::analysis {

std::vector<EdgeUse> sortedEdgeUses(const std::vector<WeldedTriangle>& triangles, const std::vector<bool>& skipped)
{
    std::vector<EdgeUse> uses;
    uses.reserve(3 * triangles.size());
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        if (skipped[t])
            continue;
        for (std::uint32_t corner = 0; corner < 3; ++corner) {
            const auto [low, high] =
                std::minmax(triangles[t].position[corner], triangles[t].position[(corner + 1) % 3]);
            uses.push_back({low, high, t, corner});
        }
    }
    std::sort(uses.begin(), uses.end(), [](const EdgeUse& a, const EdgeUse& b) {
        return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
    });
    return uses;
}

} // namespace lodsmith::analysis
