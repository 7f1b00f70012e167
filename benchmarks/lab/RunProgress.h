#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace lodsmith::benchmarks {

/// How far a run is, as lines on standard error.
class RunProgress {
public:
    /// @param steps   how many there are
    /// @param weight  of all of them: a step takes about as long as it is heavy
    RunProgress(std::size_t steps, double weight) : mSteps(steps), mLeft(weight) {}

    /// Something was measured: a line with number, rate and time left.
    void measured(const std::string& what, double weight);

    /// There was nothing to do.
    void skipped(double weight);

private:
    double elapsed() const;

    std::size_t mSteps;
    std::size_t mDone = 0;
    std::size_t mMeasured = 0;
    double mLeft;
    double mMeasuredWeight = 0.0;
    std::chrono::steady_clock::time_point mStart = std::chrono::steady_clock::now();
};

/// "8 s", "5 min" or "2 h 5 min".
std::string durationText(double seconds);

} // namespace lodsmith::benchmarks
