#include "Plot.h"

#include "Figures.h"
#include "HtmlText.h"

#include <lodsmith/core/Assert.h>

#include <algorithm>
#include <cmath>

namespace lodsmith::cli {

namespace {

// Units of the drawing, which is about as many pixels wide on a telephone: letters of 12 can be read there.
constexpr double kWidth = 420.0, kHeight = 300.0;
constexpr double kLeft = 58.0, kRight = 408.0, kTop = 12.0, kBottom = 252.0;
constexpr double kMark = 4.0, kTouch = 10.0;
constexpr double kMostDecades = 6.0;
constexpr double kFewDecades = 2.5;
constexpr int kTicks = 5;

bool isLogarithmic(const Axis& axis)
{
    return axis.scale == Axis::Scale::Logarithmic;
}

double across(const Plot& plot, double x)
{
    return kLeft + positionOn(plot.x, x) * (kRight - kLeft);
}

double upwards(const Plot& plot, double y)
{
    return kBottom - positionOn(plot.y, y) * (kBottom - kTop);
}

std::string attribute(const char* name, double value)
{
    return std::string(" ") + name + "=\"" + coordinate(value) + "\"";
}

std::string line(const char* style, double x1, double y1, double x2, double y2)
{
    return std::string("<line class=\"") + style + "\"" + attribute("x1", x1) + attribute("y1", y1)
           + attribute("x2", x2) + attribute("y2", y2) + "/>";
}

std::string text(const char* style, double x, double y, const std::string& words, const std::string& more = "")
{
    return std::string("<text class=\"") + style + "\"" + attribute("x", x) + attribute("y", y) + more + ">"
           + escaped(words) + "</text>";
}

std::string axes(const Plot& plot)
{
    std::string svg;
    for (const double tick : ticksOf(plot.x)) {
        const double x = across(plot, tick);
        svg += line("grid", x, kTop, x, kBottom) + text("tick x", x, kBottom + 17.0, tickLabel(tick));
    }
    for (const double tick : ticksOf(plot.y)) {
        const double y = upwards(plot, tick);
        svg += line("grid", kLeft, y, kRight, y) + text("tick y", kLeft - 6.0, y + 4.0, tickLabel(tick));
    }
    const double middle = (kTop + kBottom) / 2.0;
    svg += line("axis", kLeft, kBottom, kRight, kBottom) + line("axis", kLeft, kTop, kLeft, kBottom);
    svg += text("label", (kLeft + kRight) / 2.0, kHeight - 8.0, plot.x.label);
    svg += text("label", 13.0, middle, plot.y.label, " transform=\"rotate(-90 13 " + coordinate(middle) + ")\"");
    return svg;
}

std::string path(const Plot& plot, const PlotSeries& series)
{
    if (series.line == PlotSeries::Line::None || series.points.size() < 2)
        return "";
    std::string way;
    for (const PlotPoint& point : series.points) {
        const std::string x = coordinate(across(plot, point.x)), y = coordinate(upwards(plot, point.y));
        if (way.empty())
            way.append("M").append(x).append(" ").append(y);
        else if (series.line == PlotSeries::Line::Steps)
            way.append("H").append(x).append("V").append(y);
        else
            way.append("L").append(x).append(" ").append(y);
    }
    return "<path class=\"line\" d=\"" + way + "\"/>";
}

/// The mark of a style, around a centre. Shapes differ too, for those who do not tell the colours apart.
std::string mark(int style, double x, double y)
{
    const auto at = [&](double dx, double dy) { return coordinate(x + dx) + " " + coordinate(y + dy); };
    switch (style) {
    case 2:
        return "<path class=\"mark\" d=\"M" + at(-kMark, -kMark) + "L" + at(kMark, -kMark) + "L" + at(kMark, kMark)
               + "L" + at(-kMark, kMark) + "Z\"/>";
    case 3:
        return "<path class=\"mark\" d=\"M" + at(0, -kMark - 1.5) + "L" + at(kMark + 1.5, 0) + "L" + at(0, kMark + 1.5)
               + "L" + at(-kMark - 1.5, 0) + "Z\"/>";
    case 4:
        return "<path class=\"mark\" d=\"M" + at(0, -kMark - 1) + "L" + at(kMark + 1, kMark) + "L"
               + at(-kMark - 1, kMark) + "Z\"/>";
    default: return "<circle class=\"mark\"" + attribute("cx", x) + attribute("cy", y) + attribute("r", kMark) + "/>";
    }
}

std::string marks(const Plot& plot, const PlotSeries& series)
{
    std::string svg;
    for (const PlotPoint& point : series.points) {
        if (point.title.empty())
            continue;
        const double x = across(plot, point.x), y = upwards(plot, point.y);
        svg += "<g><title>" + escaped(point.title) + "</title><circle class=\"touch\"" + attribute("cx", x)
               + attribute("cy", y) + attribute("r", kTouch) + "/>" + mark(series.style, x, y) + "</g>";
    }
    return svg;
}

bool hasMarks(const PlotSeries& series)
{
    return std::any_of(series.points.begin(), series.points.end(),
                       [](const PlotPoint& point) { return !point.title.empty(); });
}

std::string legend(const Plot& plot)
{
    std::string html = "<ul class=\"legend\">";
    for (const PlotSeries& series : plot.series) {
        html += "<li class=\"series" + std::to_string(series.style)
                + "\"><svg viewBox=\"0 0 34 14\" width=\"34\" height=\"14\" aria-hidden=\"true\">";
        if (series.line != PlotSeries::Line::None)
            html += line("line", 1.0, 7.0, 33.0, 7.0);
        if (hasMarks(series))
            html += mark(series.style, 17.0, 7.0);
        html += "</svg>" + escaped(series.name) + "</li>";
    }
    return html + "</ul>";
}

double niceStep(double span)
{
    const double raw = span / kTicks;
    const double power = std::pow(10.0, std::floor(std::log10(raw)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (raw <= factor * power * 1.0000001)
            return factor * power;
    return 10.0 * power;
}

std::vector<double> linearTicks(const Axis& axis)
{
    const double step = niceStep(axis.high - axis.low);
    std::vector<double> ticks;
    for (double i = std::ceil(axis.low / step - 1e-9); i * step <= axis.high + step * 1e-9; ++i)
        ticks.push_back(i * step);
    return ticks;
}

std::vector<double> logarithmicTicks(const Axis& axis)
{
    const double decades = std::log10(axis.high / axis.low);
    std::vector<double> factors{1.0};
    if (decades <= kFewDecades)
        factors = {1.0, 2.0, 5.0};
    if (decades <= 0.7)
        return linearTicks(axis);
    const int step = static_cast<int>(std::ceil(decades / kMostDecades));
    std::vector<double> ticks;
    const int first = static_cast<int>(std::floor(std::log10(axis.low)));
    const int last = static_cast<int>(std::ceil(std::log10(axis.high)));
    for (int exponent = first; exponent <= last; ++exponent) {
        if (exponent % step != 0)
            continue;
        for (const double factor : factors) {
            const double tick = factor * std::pow(10.0, exponent);
            if (tick >= axis.low * (1.0 - 1e-9) && tick <= axis.high * (1.0 + 1e-9))
                ticks.push_back(tick);
        }
    }
    return ticks;
}

} // namespace

Axis axisFor(std::string label, Axis::Scale scale, const std::vector<double>& numbers)
{
    const bool logarithmic = scale == Axis::Scale::Logarithmic;
    std::vector<double> counted;
    std::copy_if(numbers.begin(), numbers.end(), std::back_inserter(counted),
                 [&](double number) { return std::isfinite(number) && (!logarithmic || number > 0.0); });
    Axis axis{std::move(label), scale, logarithmic ? 0.1 : 0.0, 1.0};
    if (counted.empty())
        return axis;
    const auto [least, most] = std::minmax_element(counted.begin(), counted.end());
    if (logarithmic) {
        // A third of a decade at least, so that one number alone has an axis too.
        const double room = std::max(std::pow(*most / *least, 0.04), *most < 2.0 * *least ? 1.5 : 1.0);
        axis.low = *least / room;
        axis.high = *most * room;
    } else {
        const double room = *most > *least ? 0.05 * (*most - *least) : std::max(std::fabs(*most), 1.0) * 0.5;
        axis.low = *least - room;
        axis.high = *most + room;
    }
    return axis;
}

double positionOn(const Axis& axis, double number)
{
    LODSMITH_ASSERT(axis.high > axis.low && (!isLogarithmic(axis) || axis.low > 0.0), "an axis has a range");
    if (std::isnan(number))
        return 0.0;
    const double inside = std::clamp(number, axis.low, axis.high);
    if (isLogarithmic(axis))
        return std::log(inside / axis.low) / std::log(axis.high / axis.low);
    return (inside - axis.low) / (axis.high - axis.low);
}

std::vector<double> ticksOf(const Axis& axis)
{
    return isLogarithmic(axis) ? logarithmicTicks(axis) : linearTicks(axis);
}

std::string plotFigure(const Plot& plot)
{
    const std::string title = plot.id + "-title", description = plot.id + "-text";
    std::string html = "<figure class=\"plot\" id=\"" + escaped(plot.id) + "\"><figcaption>" + escaped(plot.title)
                       + "</figcaption><svg viewBox=\"0 0 " + coordinate(kWidth) + " " + coordinate(kHeight)
                       + "\" role=\"img\" aria-labelledby=\"" + escaped(title) + " " + escaped(description)
                       + "\"><title id=\"" + escaped(title) + "\">" + escaped(plot.title) + "</title><desc id=\""
                       + escaped(description) + "\">" + escaped(plot.description) + "</desc>" + axes(plot);
    for (const PlotSeries& series : plot.series)
        html += "<g class=\"series" + std::to_string(series.style) + "\">" + path(plot, series) + marks(plot, series)
                + "</g>";
    return html + "</svg>" + legend(plot) + "</figure>\n";
}

} // namespace lodsmith::cli
