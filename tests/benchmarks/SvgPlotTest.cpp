#include "SvgPlot.h"

#include <gmock/gmock.h>

namespace lodsmith::benchmarks {

namespace {

using testing::HasSubstr;
using testing::Not;

SvgPlot somePlot()
{
    SvgPlot plot;
    plot.title = "a < b & \"c\"";
    plot.x = {"size", 100.0, 1.0, true, {{10.0, "ten"}}};
    plot.y = {"error", 0.0, 4.0, false, {{1.0, "one"}}};
    return plot;
}

// The plot goes from 64 to 696 across and from 348 up to 24.
TEST(SvgPlot, aLogarithmicAxisHasItsGeometricMeanInTheMiddle)
{
    SvgPlot plot = somePlot();
    plot.series = {{"line", "#123456", true, {{100.0, 0.0}, {10.0, 2.0}, {1.0, 4.0}}}};
    EXPECT_THAT(toSvg(plot), HasSubstr("\"M64.0 348.0 L380.0 186.0 L696.0 24.0\""));
}

TEST(SvgPlot, whatIsBeyondAnAxisIsDrawnAtItsEnd)
{
    SvgPlot plot = somePlot();
    plot.series = {{"line", "#123456", true, {{1000.0, -1.0}, {0.1, 9.0}}}};
    EXPECT_THAT(toSvg(plot), HasSubstr("\"M64.0 348.0 L696.0 24.0\""));
}

TEST(SvgPlot, wordsAreNoMarkup)
{
    SvgPlot plot = somePlot();
    plot.series = {{"<name>", "#123456", false, {{10.0, 1.0}}}};
    const std::string svg = toSvg(plot);
    EXPECT_THAT(svg, HasSubstr("aria-label=\"a &lt; b &amp; &quot;c&quot;\""));
    EXPECT_THAT(svg, HasSubstr(">&lt;name><"));
    EXPECT_THAT(svg, Not(HasSubstr("<name>")));
}

} // namespace

} // namespace lodsmith::benchmarks
