#pragma once

#include <lodsmith/core/Progress.h>
#include <lodsmith/core/Result.h>

#include <algorithm>
#include <cstdint>

namespace lodsmith::analysis {

/// Counts the steps of a measurement, and passes on the wish to stop.
class ComparisonProgress {
public:
    /// @param progress may be null
    /// @param steps as many as there will be, about
    ComparisonProgress(Progress* progress, std::uint64_t steps) : mProgress(progress), mSteps(steps) {}

    /// Counts one step; false once the job is cancelled, which is looked up every so many steps.
    bool step()
    {
        constexpr std::uint64_t kInterval = 1024;
        const bool look = mProgress && mDone % kInterval == 0;
        if (look && mProgress->cancelled())
            return false;
        if (look)
            mProgress->report(std::min(1.0f, static_cast<float>(mDone) / static_cast<float>(mSteps)));
        ++mDone;
        return true;
    }

    static Error cancelled() { return {ErrorCode::Cancelled, "the measurement was cancelled"}; }

private:
    Progress* mProgress;
    std::uint64_t mSteps;
    std::uint64_t mDone = 0;
};

} // namespace lodsmith::analysis
