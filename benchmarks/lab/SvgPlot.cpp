#include "SvgPlot.h"

#include "../MarkdownTable.h"

#include <algorithm>
#include <cmath>

namespace lodsmith::benchmarks {

namespace {

// The picture's size, and what is around the plot itself.
constexpr double kWidth = 720.0, kHeight = 400.0;
constexpr double kLeft = 64.0, kRight = 24.0, kTop = 24.0, kBottom = 52.0;

std::string text(const std::string& plain)
{
    std::string escaped;
    for (const char c : plain)
        escaped += c == '<' ? "&lt;" : c == '&' ? "&amp;" : c == '"' ? "&quot;" : std::string(1, c);
    return escaped;
}

double share(const PlotAxis& axis, double value)
{
    const auto scaled = [&](double number) { return axis.logarithmic ? std::log(number) : number; };
    const double least = std::min(axis.low, axis.high), most = std::max(axis.low, axis.high);
    value = std::min(most, std::max(least, value));
    return (scaled(value) - scaled(axis.low)) / (scaled(axis.high) - scaled(axis.low));
}

double left(const SvgPlot& plot, double x)
{
    return kLeft + share(plot.x, x) * (kWidth - kLeft - kRight);
}

double top(const SvgPlot& plot, double y)
{
    return kHeight - kBottom - share(plot.y, y) * (kHeight - kTop - kBottom);
}

std::string number(double value)
{
    return fixed(value, 1);
}

std::string label(double x, double y, const char* anchor, const std::string& words)
{
    return "<text x=\"" + number(x) + "\" y=\"" + number(y) + "\" text-anchor=\"" + anchor + "\">" + text(words)
           + "</text>\n";
}

std::string grid(const SvgPlot& plot)
{
    std::string svg;
    for (const PlotTick& tick : plot.x.ticks) {
        const double x = left(plot, tick.at);
        svg += "<path d=\"M" + number(x) + ' ' + number(kTop) + " V" + number(kHeight - kBottom)
               + "\" stroke=\"#ddd\"/>\n" + label(x, kHeight - kBottom + 18.0, "middle", tick.label);
    }
    for (const PlotTick& tick : plot.y.ticks) {
        const double y = top(plot, tick.at);
        svg += "<path d=\"M" + number(kLeft) + ' ' + number(y) + " H" + number(kWidth - kRight)
               + "\" stroke=\"#ddd\"/>\n" + label(kLeft - 8.0, y + 4.0, "end", tick.label);
    }
    svg += label((kLeft + kWidth - kRight) / 2.0, kHeight - 12.0, "middle", plot.x.label);
    return svg + "<text transform=\"translate(16 " + number((kTop + kHeight - kBottom) / 2.0)
           + ") rotate(-90)\" text-anchor=\"middle\">" + text(plot.y.label) + "</text>\n";
}

std::string curve(const SvgPlot& plot, const PlotSeries& series)
{
    std::string path;
    for (const PlotPoint& point : series.points)
        path += (path.empty() ? "M" : " L") + number(left(plot, point.x)) + ' ' + number(top(plot, point.y));
    return "<path d=\"" + path + "\" fill=\"none\" stroke=\"" + series.colour + "\" stroke-width=\"2.5\"/>\n";
}

std::string dot(double x, double y, const std::string& colour)
{
    return "<circle cx=\"" + number(x) + "\" cy=\"" + number(y) + "\" r=\"3\" fill=\"" + colour
           + "\" fill-opacity=\".5\"/>\n";
}

std::string drawn(const SvgPlot& plot, const PlotSeries& series)
{
    if (series.line)
        return series.points.empty() ? "" : curve(plot, series);
    std::string svg;
    for (const PlotPoint& point : series.points)
        svg += dot(left(plot, point.x), top(plot, point.y), series.colour);
    return svg;
}

std::string legend(const SvgPlot& plot)
{
    constexpr double kLine = 20.0, kMark = 28.0;
    const double x = kLeft + plot.legendX * (kWidth - kLeft - kRight);
    double y = kTop + plot.legendY * (kHeight - kTop - kBottom);
    std::string svg;
    for (const PlotSeries& series : plot.series) {
        svg += series.line ? "<path d=\"M" + number(x) + ' ' + number(y) + " h" + number(kMark) + "\" stroke=\""
                                 + series.colour + "\" stroke-width=\"2.5\"/>\n"
                           : dot(x + kMark / 2.0, y, series.colour);
        svg += label(x + kMark + 8.0, y + 4.0, "start", series.name);
        y += kLine;
    }
    return svg;
}

} // namespace

std::string toSvg(const SvgPlot& plot)
{
    std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + fixed(kWidth, 0) + ' '
                      + fixed(kHeight, 0) + "\" font-family=\"sans-serif\" font-size=\"13\" role=\"img\" aria-label=\""
                      + text(plot.title) + "\">\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n" + grid(plot);
    for (const PlotSeries& series : plot.series)
        svg += drawn(plot, series);
    return svg + legend(plot) + "</svg>\n";
}

} // namespace lodsmith::benchmarks
