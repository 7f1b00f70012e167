#include "RunProgress.h"

#include "../MarkdownTable.h"

#include <cmath>
#include <iostream>

namespace lodsmith::benchmarks {

void RunProgress::measured(const std::string& what, double weight)
{
    ++mDone;
    ++mMeasured;
    mLeft -= weight;
    mMeasuredWeight += weight;
    const double seconds = elapsed(), perMinute = 60.0 * double(mMeasured) / seconds;
    std::cerr << '[' << mDone << '/' << mSteps << "] " << what << "; " << fixed(perMinute, perMinute < 10.0 ? 1 : 0)
              << " a minute";
    if (mDone < mSteps)
        std::cerr << ", about " << durationText(seconds * mLeft / mMeasuredWeight) << " left";
    std::cerr << std::endl;
}

void RunProgress::skipped(double weight)
{
    ++mDone;
    mLeft -= weight;
}

double RunProgress::elapsed() const
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - mStart).count();
}

std::string durationText(double seconds)
{
    const auto whole = static_cast<long long>(std::ceil(seconds));
    if (whole < 60)
        return std::to_string(whole) + " s";
    const long long minutes = (whole + 59) / 60;
    if (minutes < 60)
        return std::to_string(minutes) + " min";
    return std::to_string(minutes / 60) + " h " + std::to_string(minutes % 60) + " min";
}

} // namespace lodsmith::benchmarks
