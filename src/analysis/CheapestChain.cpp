#include <lodsmith/analysis/CheapestChain.h>

#include "Rings.h"

#include <lodsmith/core/Assert.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lodsmith {

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kWorthwhile = 1e-9; // of the cost: what a further level has to save

Error invalid(std::string message)
{
    return Error{ErrorCode::InvalidSetting, std::move(message)};
}

bool isPositive(double number)
{
    return std::isfinite(number) && number > 0.0;
}

bool isValid(const ErrorBudget& budget)
{
    return isPositive(budget.pixels) && isPositive(budget.viewportHeight) && budget.fieldOfView > 0.0
           && budget.fieldOfView < kPi && budget.mostLevels >= 1;
}

Result<Done> check(const std::vector<CandidateLevel>& candidates, const ErrorBudget& budget,
                   const StreamingCostSettings& settings)
{
    if (const std::string trouble = troubleWith(settings); !trouble.empty())
        return invalid(trouble);
    if (!isValid(budget))
        return invalid("the pixels, the viewport, the field of view or the number of levels are out of range");
    if (candidates.empty() || candidates.front().deviation != 0.0)
        return invalid("the first candidate is the original, which deviates from nothing");
    for (const CandidateLevel& candidate : candidates)
        if (!isPositive(candidate.bytes) || !(candidate.deviation >= 0.0)
            || !std::isfinite(sightDistance(candidate.deviation, budget)))
            return invalid("a candidate has bytes above 0 and a deviation of at least 0");
    return Done{};
}

/// A candidate on the way from the object outwards.
struct Stop {
    std::size_t candidate;
    double distance;
    double triangles;
};

/// Candidate 0, then the others from the nearest on.
std::vector<Stop> stopsOf(const std::vector<CandidateLevel>& candidates, const ErrorBudget& budget,
                          const StreamingCostSettings& settings)
{
    std::vector<Stop> stops;
    for (std::size_t i = 0; i < candidates.size(); ++i)
        stops.push_back(
            {i, sightDistance(candidates[i].deviation, budget), countedTriangles(candidates[i].bytes, settings)});
    std::stable_sort(stops.begin() + 1, stops.end(),
                     [](const Stop& a, const Stop& b) { return a.distance < b.distance; });
    return stops;
}

/// Paths of a fixed number of stops, the first stop always among them.
class ChainSearch {
public:
    ChainSearch(const std::vector<Stop>& stops, std::size_t levels, const StreamingCostSettings& settings)
        : mStops(stops), mLevels(levels), mSettings(settings)
    {
    }

    /// The stops of least mean triangles; nothing when there are no so many that are all seen.
    std::vector<std::size_t> cheapest() const
    {
        std::vector<std::size_t> path = leastBeyond(mStops.front().triangles);
        while (!path.empty()) {
            const double mean = meanTriangles(path);
            const std::vector<std::size_t> next = leastBeyond(mean);
            if (!(meanTriangles(next) < mean))
                break;
            path = next;
        }
        return path;
    }

    double meanTriangles(const std::vector<std::size_t>& path) const
    {
        double triangles = 0.0, areas = 0.0;
        for (std::size_t i = 0; i < path.size(); ++i) {
            const double seen = area(path[i], i + 1 < path.size() ? mStops[path[i + 1]].distance : kEdge);
            triangles += seen * mStops[path[i]].triangles;
            areas += seen;
        }
        return triangles / areas;
    }

private:
    double area(std::size_t stop, double outer) const { return ringArea(mStops[stop].distance, outer, mSettings); }

    /// Area * (triangles - mean) of a stop; infinite for one but the first that nobody sees.
    double weigh(std::size_t stop, double outer, double mean) const
    {
        const double inner = mStops[stop].distance;
        if (stop > 0 && areaBetween(inner, outer, mSettings) < mSettings.smallestArea)
            return kNone;
        return area(stop, outer) * (mStops[stop].triangles - mean);
    }

    /// The stops with the least sum of area * (triangles - mean).
    std::vector<std::size_t> leastBeyond(double mean) const
    {
        const std::size_t count = mStops.size();
        // best[n][s]: of n + 1 stops, the last being s, what lies before s
        std::vector<std::vector<double>> best(mLevels, std::vector<double>(count, kNone));
        std::vector<std::vector<std::size_t>> before(mLevels, std::vector<std::size_t>(count, 0));
        best[0][0] = 0.0;
        for (std::size_t n = 1; n < mLevels; ++n)
            for (std::size_t to = n; to < count; ++to)
                for (std::size_t from = n - 1; from < to; ++from) {
                    const double sum = best[n - 1][from] + weigh(from, mStops[to].distance, mean);
                    if (sum < best[n][to]) {
                        best[n][to] = sum;
                        before[n][to] = from;
                    }
                }
        std::size_t last = 0;
        double least = kNone;
        for (std::size_t s = 0; s < count; ++s) {
            const double sum = best[mLevels - 1][s] + weigh(s, kEdge, mean);
            if (sum < least) {
                least = sum;
                last = s;
            }
        }
        if (least == kNone)
            return {};
        std::vector<std::size_t> path(mLevels);
        for (std::size_t n = mLevels; n-- > 0; last = before[n][last])
            path[n] = last;
        return path;
    }

    static constexpr double kNone = std::numeric_limits<double>::infinity();
    static constexpr double kEdge = std::numeric_limits<double>::infinity(); // of the disc

    const std::vector<Stop>& mStops;
    std::size_t mLevels;
    const StreamingCostSettings& mSettings;
};

std::vector<std::size_t> cheapestPath(const std::vector<Stop>& stops, std::size_t mostLevels,
                                      const StreamingCostSettings& settings)
{
    std::vector<std::size_t> best{0};
    double least = stops.front().triangles;
    for (std::size_t levels = 2; levels <= std::min(mostLevels, stops.size()); ++levels) {
        const ChainSearch search(stops, levels, settings);
        const std::vector<std::size_t> path = search.cheapest();
        if (!path.empty() && search.meanTriangles(path) < least * (1.0 - kWorthwhile)) {
            least = search.meanTriangles(path);
            best = path;
        }
    }
    return best;
}

} // namespace

double sightDistance(double deviation, const ErrorBudget& budget)
{
    LODSMITH_ASSERT(isValid(budget), "an error budget out of range");
    return deviation * budget.viewportHeight / (2.0 * std::tan(budget.fieldOfView / 2.0) * budget.pixels);
}

Result<CheapestChain> cheapestChain(const std::vector<CandidateLevel>& candidates, const ErrorBudget& budget,
                                    const StreamingCostSettings& settings)
{
    if (const Result<Done> checked = check(candidates, budget, settings); !checked)
        return checked.error();
    const std::vector<Stop> stops = stopsOf(candidates, budget, settings);
    CheapestChain chain;
    std::vector<CostedLevel> levels;
    for (const std::size_t stop : cheapestPath(stops, budget.mostLevels, settings)) {
        chain.candidates.push_back(stops[stop].candidate);
        levels.push_back({candidates[stops[stop].candidate].bytes, 0.0});
        if (levels.size() > 1)
            chain.distances.push_back(stops[stop].distance);
    }
    const Result<StreamingCost> cost = streamingCost(levels, chain.distances, settings);
    if (!cost)
        return cost.error();
    chain.cost = cost.value();
    return chain;
}

} // namespace lodsmith
