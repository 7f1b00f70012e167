#include "Numbers.h"

#include <gtest/gtest.h>

namespace lodsmith::cli {

TEST(Numbers, plainDecimalsAreRead)
{
    EXPECT_EQ(parseNumber("0.5"), 0.5);
    EXPECT_EQ(parseNumber("-12"), -12.0);
    EXPECT_EQ(parseNumber("1e-3"), 0.001);
    EXPECT_EQ(parseCount("0"), 0u);
    EXPECT_EQ(parseCount("18446744073709551615"), 18446744073709551615u);
}

TEST(Numbers, nothingElsePassesForANumber)
{
    for (const char* text : {"", " 1", "1 ", "+1", "1,5", "0x10", "inf", "nan", "1e999", "1.0.0", "abc", "1f", "--1"})
        EXPECT_FALSE(parseNumber(text)) << text;
}

TEST(Numbers, countsAreDigitsAlone)
{
    for (const char* text : {"", "-1", "1.0", "1e3", " 1", "+1", "18446744073709551616"})
        EXPECT_FALSE(parseCount(text)) << text;
}

} // namespace lodsmith::cli
