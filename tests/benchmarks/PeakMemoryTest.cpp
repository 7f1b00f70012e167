#include "../../benchmarks/PeakMemory.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <numeric>
#include <vector>

namespace lodsmith::benchmarks {

namespace {

TEST(PeakMemory, isWhatTheWorkTakesAtMost)
{
    constexpr std::size_t kBytes = 32 << 20;
    long sum = 0;
    const long peak = peakGrowthKb([&] {
        const std::vector<char> all(kBytes, 1);
        sum = std::accumulate(all.begin(), all.end(), 0L);
    });
    EXPECT_EQ(sum, long(kBytes));
    EXPECT_NEAR(double(peak), kBytes / 1024.0, 1024.0);
    EXPECT_LT(peakGrowthKb([] {}), 1024);
}

TEST(PeakMemory, aProcessThatIsEndedEndsNothingElse)
{
    constexpr const char* kIsTrial = "LODSMITH_TEST_IS_TRIAL";
    if (std::getenv(kIsTrial))
        std::abort(); // the process that this test starts: itself again
    ::setenv(kIsTrial, "1", 1);
    const Trial trial = tryInOwnProcess({"--gtest_filter=PeakMemory.aProcessThatIsEndedEndsNothingElse"});
    ::unsetenv(kIsTrial);
    EXPECT_FALSE(trial.peakKb);
    EXPECT_EQ(trial.trouble, "ended by signal 6");
}

} // namespace

} // namespace lodsmith::benchmarks
