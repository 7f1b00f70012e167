#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace lodsmith::benchmarks {

struct TimingOptions {
    int rounds = 5;            ///< at least this many runs of everything
    double leastSeconds = 0.5; ///< and further rounds until this much time was measured
};

/// Runs a number of works in turn, round after round, so that what slows the machine down slows all of them. Nothing warms up
/// here: run each once before.
/// @param run  does work i and returns the seconds that count
void repeatInTurn(std::size_t works, const TimingOptions& options, const std::function<double(std::size_t)>& run);

/// Processor time that this process has taken so far, all threads together.
double processorSeconds();

double median(std::vector<double> values);

/// NaN when there is none.
double geometricMean(const std::vector<double>& values);

} // namespace lodsmith::benchmarks
