#include "Statistics.h"

#include "../Timing.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <random>

namespace lodsmith::benchmarks {

namespace {

constexpr std::size_t kMostExact = 40;

struct Ranks {
    double sumOfFirst = 0.0;
    double ties = 0.0; ///< sum of t^3 - t over groups of t equal values
};

/// Equal values share the mean of their ranks.
Ranks rank(const std::vector<double>& a, const std::vector<double>& b)
{
    std::vector<std::pair<double, bool>> all; // value, whether of a
    for (const double value : a)
        all.emplace_back(value, true);
    for (const double value : b)
        all.emplace_back(value, false);
    std::sort(all.begin(), all.end());
    Ranks ranks;
    for (std::size_t begin = 0, end = 0; begin < all.size(); begin = end) {
        while (end < all.size() && all[end].first == all[begin].first)
            ++end;
        const double mean = (double(begin) + 1.0 + double(end)) / 2.0, equal = double(end - begin);
        for (std::size_t i = begin; i < end; ++i)
            ranks.sumOfFirst += all[i].second ? mean : 0.0;
        ranks.ties += equal * equal * equal - equal;
    }
    return ranks;
}

/// Share of all choices of n of the ranks 1..n+m whose sum is at most `sum`.
double shareUpTo(double sum, std::size_t n, std::size_t m)
{
    const std::size_t total = n + m, most = n * total;
    // ways[k][s]: choices of k ranks with sum s among those seen so far
    std::vector<std::vector<double>> ways(n + 1, std::vector<double>(most + 1));
    ways[0][0] = 1.0;
    for (std::size_t value = 1; value <= total; ++value)
        for (std::size_t k = std::min(n, value); k >= 1; --k)
            for (std::size_t s = most; s >= value; --s)
                ways[k][s] += ways[k - 1][s - value];
    const std::vector<double>& chosen = ways[n];
    const auto last = static_cast<std::size_t>(std::min(sum, double(most)));
    return std::accumulate(chosen.begin(), chosen.begin() + std::ptrdiff_t(last) + 1, 0.0)
           / std::accumulate(chosen.begin(), chosen.end(), 0.0);
}

double normalChance(double distance)
{
    return std::erfc(distance / std::sqrt(2.0));
}

} // namespace

double rankTest(const std::vector<double>& a, const std::vector<double>& b)
{
    if (a.empty() || b.empty())
        return 1.0;
    const double n = double(a.size()), m = double(b.size()), all = n + m;
    const Ranks ranks = rank(a, b);
    const double middle = n * (all + 1.0) / 2.0, away = std::abs(ranks.sumOfFirst - middle);
    if (ranks.ties == 0.0 && a.size() + b.size() <= kMostExact)
        return std::min(1.0, 2.0 * shareUpTo(middle - away, a.size(), b.size()));
    const double variance = n * m / 12.0 * (all + 1.0 - ranks.ties / (all * (all - 1.0)));
    return variance <= 0.0 ? 1.0 : std::min(1.0, normalChance(std::max(0.0, away - 0.5) / std::sqrt(variance)));
}

double leastRankChance(std::size_t a, std::size_t b)
{
    double choices = 1.0;
    for (std::size_t i = 1; i <= a; ++i)
        choices *= double(b + i) / double(i);
    return std::min(1.0, 2.0 / choices);
}

double signTest(const std::vector<double>& values)
{
    constexpr std::size_t kMostComplete = 16;
    constexpr std::uint64_t kRandom = 100000;
    const double sum = std::abs(std::accumulate(values.begin(), values.end(), 0.0));
    const bool complete = values.size() <= kMostComplete;
    const std::uint64_t choices = complete ? std::uint64_t(1) << values.size() : kRandom;
    std::mt19937_64 random(1);
    std::uint64_t asFar = complete ? 0 : 1; // what was seen counts as one of the random choices
    for (std::uint64_t choice = 0; choice < choices; ++choice) {
        double other = 0.0;
        std::uint64_t signs = choice;
        for (std::size_t i = 0; i < values.size(); ++i, signs >>= 1U) {
            if (!complete && i % 64 == 0)
                signs = random();
            other += (signs & 1U) != 0 ? values[i] : -values[i];
        }
        // Rounding must not decide between equals.
        asFar += std::abs(other) >= sum * (1.0 - 1e-12);
    }
    return double(asFar) / double(complete ? choices : choices + 1);
}

std::vector<double> correctedForMany(const std::vector<double>& chances)
{
    std::vector<std::size_t> order(chances.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return chances[a] < chances[b]; });
    std::vector<double> corrected(chances.size());
    double least = 0.0;
    for (std::size_t i = 0; i < order.size(); ++i) {
        least = std::max(least, std::min(1.0, double(order.size() - i) * chances[order[i]]));
        corrected[order[i]] = least;
    }
    return corrected;
}

double robustSpread(const std::vector<double>& values)
{
    if (values.empty())
        return 0.0;
    const double middle = median(values);
    std::vector<double> distances;
    for (const double value : values)
        distances.push_back(std::abs(value - middle));
    return 1.4826 * median(distances);
}

} // namespace lodsmith::benchmarks
