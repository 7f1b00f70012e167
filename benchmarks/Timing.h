#pragma once

#include "Peer.h"

#include <map>
#include <string>
#include <vector>

namespace lodsmith::benchmarks {

struct TimingOptions {
    int rounds = 5;            ///< at least this many runs of every peer
    double leastSeconds = 0.5; ///< and further rounds until this much time was measured
};

/// Seconds of every run, by peer.
using Timings = std::map<std::string, std::vector<double>>;

/// Runs the peers in turn, round after round, so that what slows the machine down slows all of them.
/// Nothing warms up here: run each peer once before.
Timings timeInTurn(Subject& subject, const std::vector<Peer*>& peers, const TimingOptions& options);

double median(std::vector<double> values);

/// NaN when there is none.
double geometricMean(const std::vector<double>& values);

/// Slope of the straight line through (log x, log y): the exponent of y over x.
double fittedExponent(const std::vector<double>& x, const std::vector<double>& y);

} // namespace lodsmith::benchmarks
