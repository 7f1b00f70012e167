#include "Timing.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lodsmith::benchmarks {

namespace {

constexpr int kMostRounds = 101;

double run(Peer& peer, Subject& subject)
{
    const double seconds = peer.generate(subject, halvings());
    peer.reset(subject);
    return seconds;
}

} // namespace

Timings timeInTurn(Subject& subject, const std::vector<Peer*>& peers, const TimingOptions& options)
{
    Timings timings;
    double measured = 0.0;
    for (int round = 0; round < options.rounds || (measured < options.leastSeconds && round < kMostRounds); ++round)
        for (Peer* peer : peers) {
            const double seconds = run(*peer, subject);
            timings[peer->name()].push_back(seconds);
            measured += seconds;
        }
    return timings;
}

double median(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2.0;
}

double geometricMean(const std::vector<double>& values)
{
    if (values.empty())
        return std::numeric_limits<double>::quiet_NaN();
    double sum = 0.0;
    for (const double value : values)
        sum += std::log(value);
    return std::exp(sum / double(values.size()));
}

double fittedExponent(const std::vector<double>& x, const std::vector<double>& y)
{
    double sumX = 0.0, sumY = 0.0, sumXX = 0.0, sumXY = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double logX = std::log(x[i]), logY = std::log(y[i]);
        sumX += logX;
        sumY += logY;
        sumXX += logX * logX;
        sumXY += logX * logY;
    }
    const double n = double(x.size());
    return (n * sumXY - sumX * sumY) / (n * sumXX - sumX * sumX);
}

} // namespace lodsmith::benchmarks
