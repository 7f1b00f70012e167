#include <lodsmith/analysis/LevelChoice.h>

#include <lodsmith/core/Assert.h>

#include <algorithm>
#include <cmath>

namespace lodsmith {

namespace {

/// The best way so far that ends with a certain level.
struct Way {
    double cost = 0.0; ///< share of the mesh's triangles times doublings, and what the levels count
    std::vector<std::size_t> levels;
};

bool isBetter(const Way& a, const Way& b)
{
    constexpr double kSame = 1e-12;
    if (std::abs(a.cost - b.cost) > kSame)
        return a.cost < b.cost;
    return a.levels.size() != b.levels.size() ? a.levels.size() < b.levels.size() : a.levels > b.levels;
}

class Chooser {
public:
    Chooser(std::uint32_t triangles, const std::vector<LevelCandidate>& candidates)
        : mTriangles(triangles), mCandidates(candidates)
    {
    }

    std::vector<std::size_t> choose(std::size_t most) const
    {
        Way best = closed(Way{});
        // Ways with `count` levels, by their last one.
        std::vector<Way> ways(1);
        for (std::size_t count = 1; count <= std::min(most, mCandidates.size()); ++count) {
            ways = extended(ways);
            for (const Way& way : ways)
                if (const Way whole = closed(way); isBetter(whole, best))
                    best = whole;
        }
        return best.levels;
    }

private:
    /// How often the distance doubles while the mesh shrinks from the first candidate's size to that of candidate `to`.
    double doublings(std::size_t to) const
    {
        const double last = to < mCandidates.size() ? mCandidates[to].size : mCandidates.back().size / 2.0;
        return std::log2(mCandidates.front().size / last);
    }

    /// What a way's last level costs until candidate `to` takes over.
    double drawn(const Way& way, std::size_t to) const
    {
        if (way.levels.empty())
            return doublings(to);
        const std::size_t from = way.levels.back();
        return (doublings(to) - doublings(from)) * mCandidates[from].triangles / mTriangles;
    }

    Way closed(Way way) const
    {
        way.cost += drawn(way, mCandidates.size());
        return way;
    }

    std::vector<Way> extended(const std::vector<Way>& ways) const
    {
        std::vector<Way> longer;
        for (std::size_t to = 0; to < mCandidates.size(); ++to) {
            const std::size_t before = longer.size();
            for (const Way& way : ways) {
                if (!way.levels.empty() && way.levels.back() >= to)
                    continue;
                Way next{way.cost + drawn(way, to) + kWorthOfLevel, way.levels};
                next.levels.push_back(to);
                if (longer.size() == before)
                    longer.push_back(std::move(next));
                else if (isBetter(next, longer.back()))
                    longer.back() = std::move(next);
            }
        }
        return longer;
    }

    const double mTriangles;
    const std::vector<LevelCandidate>& mCandidates;
};

} // namespace

std::vector<std::size_t> chooseLevels(std::uint32_t triangles, const std::vector<LevelCandidate>& candidates,
                                      std::size_t most)
{
    for (std::size_t i = 0; i < candidates.size(); ++i)
        LODSMITH_ASSERT(candidates[i].size > (i + 1 < candidates.size() ? candidates[i + 1].size : 0.0),
                        "the sizes of candidate levels have to fall and to be above 0");
    if (triangles == 0 || candidates.empty())
        return {};
    return Chooser(triangles, candidates).choose(most);
}

} // namespace lodsmith
