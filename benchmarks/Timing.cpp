#include "Timing.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <time.h>

namespace lodsmith::benchmarks {

namespace {

constexpr int kMostRounds = 101;

} // namespace

void repeatInTurn(std::size_t works, const TimingOptions& options, const std::function<double(std::size_t)>& run)
{
    double measured = 0.0;
    for (int round = 0; round < options.rounds || (measured < options.leastSeconds && round < kMostRounds); ++round)
        for (std::size_t work = 0; work < works; ++work)
            measured += run(work);
}

double processorSeconds()
{
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
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

} // namespace lodsmith::benchmarks
