#pragma once

#include <vector>

namespace lodsmith::benchmarks {

/// Chance that two samples of one distribution are as far apart in rank as these, either way (Mann and Whitney 1947). Exact up
/// to 40 values without ties, else by the normal approximation with the correction for ties. 1 when a sample is empty.
double rankTest(const std::vector<double>& a, const std::vector<double>& b);

/// The least that rankTest() can say of samples of these sizes.
double leastRankChance(std::size_t a, std::size_t b);

/// Chance that values which are as likely above zero as below have a mean as far from it as these, either way: the share of all
/// choices of signs; of 100 000 random ones, always the same, beyond 16 values. 1 without values.
double signTest(const std::vector<double>& values);

/// Chances as they are after so many questions at once (Holm 1979): each at least as large as it was, at most 1.
std::vector<double> correctedForMany(const std::vector<double>& chances);

/// The standard deviation of values as a robust estimate: 1.4826 times the median distance from their median.
double robustSpread(const std::vector<double>& values);

} // namespace lodsmith::benchmarks
