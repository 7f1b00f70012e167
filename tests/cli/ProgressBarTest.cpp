#include "ProgressBar.h"

#include <gmock/gmock.h>

namespace lodsmith::cli {

using testing::HasSubstr;

TEST(ProgressBar, saysHowManyHowFastAndHowLong)
{
    ProgressState state{5, 10, 0.0, 10.0, "tree.mesh"};
    const std::string line = progressLine(state, 200);
    EXPECT_THAT(line, HasSubstr("[##########..........]"));
    EXPECT_THAT(line, HasSubstr("5 of 10"));
    EXPECT_THAT(line, HasSubstr("0.5 files/s"));
    EXPECT_THAT(line, HasSubstr("10 s left"));
    EXPECT_THAT(line, HasSubstr("tree.mesh"));
}

TEST(ProgressBar, workOnUnfinishedFilesCounts)
{
    EXPECT_THAT(progressLine({0, 1, 0.25, 30.0, "x"}, 200), HasSubstr("1 min 30 s left"));
    EXPECT_THAT(progressLine({0, 2, 0.5, 3600.0, "x"}, 200), HasSubstr("3 h 0 min left"));
}

TEST(ProgressBar, saysNothingAboutSpeedBeforeAnythingIsDone)
{
    EXPECT_THAT(progressLine({0, 3, 0.0, 1.0, "x"}, 200), testing::Not(HasSubstr("left")));
}

TEST(ProgressBar, fitsIntoTheTerminal)
{
    EXPECT_EQ(progressLine({1, 2, 0.0, 1.0, std::string(500, 'x')}, 79).size(), 79u);
}

} // namespace lodsmith::cli
