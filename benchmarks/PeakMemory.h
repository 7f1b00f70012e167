#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace lodsmith::benchmarks {

/// How far the process's resident memory rises above where it was, in kB, during some work. Linux only.
long peakGrowthKb(const std::function<void()>& work);

/// What a process of its own came to.
struct Trial {
    std::optional<long> peakKb;
    std::string trouble; ///< why there is no figure
};

/// Has this program print a figure of peakGrowthKb() in a process of its own, so that nobody finds memory that another left
/// behind, and whatever ends that process ends nothing else.
/// @param arguments  what makes this program print the figure on standard output, or the trouble and exit with 1
Trial tryInOwnProcess(const std::vector<std::string>& arguments);

} // namespace lodsmith::benchmarks
