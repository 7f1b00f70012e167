#include "report/Figures.h"
#include "report/HtmlText.h"
#include "report/PageParts.h"
#include "report/Plot.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <regex>

namespace lodsmith::cli {

namespace {

using testing::HasSubstr;
using testing::Not;

constexpr const char* kReplacement = "\xEF\xBF\xBD";
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

std::string repeated(const std::string& text, int times)
{
    std::string result;
    for (int i = 0; i < times; ++i)
        result += text;
    return result;
}

std::size_t count(const std::string& text, const std::string& part)
{
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size()))
        ++found;
    return found;
}

Axis logarithmic(double low, double high)
{
    return {"", Axis::Scale::Logarithmic, low, high};
}

Axis linear(double low, double high)
{
    return {"", Axis::Scale::Linear, low, high};
}

} // namespace

TEST(HtmlText, markupIsEscaped)
{
    EXPECT_EQ(escaped("<b a=\"1\" b='2'>&amp;</b>"), "&lt;b a=&quot;1&quot; b=&#39;2&#39;&gt;&amp;amp;&lt;/b&gt;");
}

TEST(HtmlText, wellFormedTextStays)
{
    const std::string text = "Bäume 樹 🌳 \u07FF \uFFFD\ttab\nline";
    EXPECT_EQ(escaped(text), text);
}

TEST(HtmlText, bytesThatAreNoUtf8AreReplacedOneByOne)
{
    EXPECT_EQ(escaped("a\xFF"
                      "b"),
              std::string("a") + kReplacement + "b");
    EXPECT_EQ(escaped("\xC3"), kReplacement) << "cut off";
    EXPECT_EQ(escaped("\xC3<"), std::string(kReplacement) + "&lt;") << "what follows is still escaped";
    EXPECT_EQ(escaped("\xC0\xBC"), repeated(kReplacement, 2)) << "an overlong '<'";
    EXPECT_EQ(escaped("\xE0\x80\xBC"), repeated(kReplacement, 3)) << "an overlong '<' in three";
    EXPECT_EQ(escaped("\xED\xA0\x80"), repeated(kReplacement, 3)) << "half a surrogate pair";
    EXPECT_EQ(escaped("\xF4\x90\x80\x80"), repeated(kReplacement, 4)) << "beyond U+10FFFF";
}

TEST(HtmlText, controlCharactersAreReplaced)
{
    EXPECT_EQ(escaped(std::string("\0", 1)), kReplacement);
    EXPECT_EQ(escaped("\x1B[1m"), std::string(kReplacement) + "[1m");
    EXPECT_EQ(escaped("\x7F"), kReplacement);
    EXPECT_EQ(escaped("\xC2\x85"), kReplacement);
    EXPECT_EQ(escaped("\xC2\xA0"), "\xC2\xA0") << "a no-break space is none";
}

TEST(HtmlText, base64IsThatOfTheStandard)
{
    const std::pair<const char*, const char*> examples[] = {{"", ""},
                                                            {"f", "Zg=="},
                                                            {"fo", "Zm8="},
                                                            {"foo", "Zm9v"},
                                                            {"foob", "Zm9vYg=="},
                                                            {"fooba", "Zm9vYmE="},
                                                            {"foobar", "Zm9vYmFy"}};
    for (const auto& [bytes, text] : examples) {
        EXPECT_EQ(base64(bytes), text);
        EXPECT_EQ(fromBase64(text), bytes);
    }
    std::string all;
    for (int c = 0; c < 256; ++c)
        all += static_cast<char>(c);
    EXPECT_EQ(fromBase64(base64(all)), all);
}

TEST(Figures, wholeNumbersAreGroupedByThree)
{
    EXPECT_EQ(wholeNumber(0), "0");
    EXPECT_EQ(wholeNumber(999), "999");
    EXPECT_EQ(wholeNumber(1000), "1\u202F000");
    EXPECT_EQ(wholeNumber(1234567.4), "1\u202F234\u202F567");
    EXPECT_EQ(wholeNumber(-1234), "−1\u202F234");
    EXPECT_EQ(wholeNumber(-0.2), "0");
    EXPECT_EQ(wholeNumber(kNan), "–");
}

TEST(Figures, shortNumbersHaveThreeDigits)
{
    EXPECT_EQ(shortNumber(0.0), "0");
    EXPECT_EQ(shortNumber(0.012345), "0.0123");
    EXPECT_EQ(shortNumber(1.5), "1.5");
    EXPECT_EQ(shortNumber(12.345), "12.3");
    EXPECT_EQ(shortNumber(12345.6), "12\u202F346");
    EXPECT_EQ(shortNumber(-2.5), "−2.5");
    EXPECT_EQ(shortNumber(1.234e-7), "1.2e-07");
    EXPECT_EQ(shortNumber(std::numeric_limits<double>::infinity()), "–");
    EXPECT_EQ(percentage(0.0035), "0.35\u202F%");
}

TEST(Figures, bytesTakeTheUnitTheyFillOnce)
{
    EXPECT_EQ(byteCount(0), "0\u202FB");
    EXPECT_EQ(byteCount(999), "999\u202FB");
    EXPECT_EQ(byteCount(1000), "1\u202FkB");
    EXPECT_EQ(byteCount(999999), "1\u202FMB");
    EXPECT_EQ(byteCount(1234567), "1.23\u202FMB");
}

TEST(Plot, logarithmicAxesGiveEveryDecadeTheSameRoom)
{
    const Axis axis = logarithmic(1.0, 1000.0);
    EXPECT_DOUBLE_EQ(positionOn(axis, 1.0), 0.0);
    EXPECT_NEAR(positionOn(axis, 10.0), 1.0 / 3.0, 1e-12);
    EXPECT_NEAR(positionOn(axis, 100.0), 2.0 / 3.0, 1e-12);
    EXPECT_DOUBLE_EQ(positionOn(axis, 1000.0), 1.0);
}

TEST(Plot, whatIsOffTheAxisIsDrawnAtItsEnds)
{
    EXPECT_EQ(positionOn(logarithmic(1.0, 10.0), 0.0), 0.0);
    EXPECT_EQ(positionOn(logarithmic(1.0, 10.0), -5.0), 0.0);
    EXPECT_EQ(positionOn(logarithmic(1.0, 10.0), 1e300), 1.0);
    EXPECT_EQ(positionOn(linear(0.0, 2.0), 0.5), 0.25);
    EXPECT_EQ(positionOn(linear(0.0, 2.0), kNan), 0.0);
}

TEST(Plot, axesHoldTheirNumbers)
{
    const std::vector<double> numbers{0.0, 3.0, kNan, 700.0, HUGE_VAL};
    const Axis axis = axisFor("x", Axis::Scale::Logarithmic, numbers);
    EXPECT_LT(axis.low, 3.0);
    EXPECT_GT(axis.low, 0.3) << "zero has no place on it";
    EXPECT_GT(axis.high, 700.0);
    EXPECT_TRUE(std::isfinite(axis.high));
    const Axis straight = axisFor("x", Axis::Scale::Linear, numbers);
    EXPECT_LT(straight.low, 0.0);
    EXPECT_GT(straight.high, 700.0);
}

TEST(Plot, oneNumberOrNoneMakesAnAxisToo)
{
    for (const auto scale : {Axis::Scale::Linear, Axis::Scale::Logarithmic})
        for (const std::vector<double>& numbers : {std::vector<double>{}, {5.0}, {0.0}, {kNan}}) {
            const Axis axis = axisFor("x", scale, numbers);
            EXPECT_LT(axis.low, axis.high);
            EXPECT_GE(ticksOf(axis).size(), 2u);
        }
}

TEST(Plot, ticksAreRoundAndRiseWithinTheAxis)
{
    for (const Axis& axis : {logarithmic(3.0, 8e5), logarithmic(0.001, 0.02), logarithmic(40.0, 70.0),
                             logarithmic(1e-9, 1e9), linear(-3.0, 17.0), linear(0.0, 1e-3)}) {
        const std::vector<double> ticks = ticksOf(axis);
        ASSERT_GE(ticks.size(), 2u) << axis.low << " " << axis.high;
        EXPECT_LE(ticks.size(), 12u) << axis.low << " " << axis.high;
        for (std::size_t i = 0; i < ticks.size(); ++i) {
            EXPECT_GE(ticks[i], axis.low - 1e-9 * std::fabs(axis.low));
            EXPECT_LE(ticks[i], axis.high * (1.0 + 1e-9));
            if (i > 0)
                EXPECT_GT(ticks[i], ticks[i - 1]);
        }
    }
}

TEST(Plot, everythingFromOutsideIsEscaped)
{
    Plot plot{"p", "<title>", "\"text\"", linear(0, 1), linear(0, 1), {}};
    plot.x.label = "a & b";
    plot.series.push_back({"<script>", 1, PlotSeries::Line::Straight, {{0, 0, "<&>"}, {1, 1, ""}}});
    const std::string html = plotFigure(plot);
    EXPECT_THAT(html, Not(HasSubstr("<script>")));
    EXPECT_THAT(html, HasSubstr("&lt;script&gt;"));
    EXPECT_THAT(html, HasSubstr("<title>&lt;&amp;&gt;</title>"));
    EXPECT_THAT(html, HasSubstr("a &amp; b"));
}

TEST(Plot, everyPointWithATitleHasAMark)
{
    Plot plot{"p", "t", "d", linear(0, 2), linear(0, 2), {}};
    plot.series.push_back({"s", 2, PlotSeries::Line::Steps, {{0, 2, ""}, {1, 1, "here"}, {2, 1, "there"}}});
    const std::string html = plotFigure(plot);
    EXPECT_EQ(count(html, "class=\"touch\""), 2u);
    EXPECT_THAT(html, HasSubstr("<title>here</title>"));
    // Level until the next x, and only then down or up.
    EXPECT_TRUE(std::regex_search(html, std::regex("d=\"M[0-9.]+ [0-9.]+H[0-9.]+V[0-9.]+H")));
}

TEST(PageParts, noPageNamesAnotherPlace)
{
    const std::string html = htmlPage("<title>", "<p>body</p>");
    EXPECT_THAT(html, HasSubstr("<title>&lt;title&gt;</title>"));
    EXPECT_FALSE(std::regex_search(html, std::regex("(https?:|url\\(|@import)")));
    EXPECT_THAT(html, HasSubstr("default-src 'none'"));
}

} // namespace lodsmith::cli
