#pragma once

#include <string>
#include <vector>

namespace lodsmith::cli {

/// An axis of a plot. Numbers outside its range are drawn at its ends.
struct Axis {
    enum class Scale { Linear, Logarithmic };
    std::string label;
    Scale scale = Scale::Linear;
    double low = 0.0;  ///< > 0 on a logarithmic axis
    double high = 1.0; ///< > low
};

/// An axis that holds all these numbers with a little room; on a logarithmic one those that are not above 0 do not
/// count. Numbers that are not finite never do.
Axis axisFor(std::string label, Axis::Scale scale, const std::vector<double>& numbers);

/// Where a number lies on an axis: 0 at its low end, 1 at its high end.
double positionOn(const Axis& axis, double number);

/// Round numbers to mark on an axis, rising, two at least: powers of ten, with their halves and fifths or the like
/// where these are few, on a logarithmic axis.
std::vector<double> ticksOf(const Axis& axis);

struct PlotPoint {
    double x = 0.0;
    double y = 0.0;
    std::string title; ///< what the pointer shows, as plain text; empty for a point without a mark
};

struct PlotSeries {
    enum class Line { None, Straight, Steps };
    std::string name;
    /// What it looks like, 1..4: colour, dash and mark, report.css.
    int style = 1;
    Line line = Line::Straight; ///< steps go along to the next point's x first
    std::vector<PlotPoint> points;
};

struct Plot {
    std::string id; ///< an HTML id of its own on the page
    std::string title;
    std::string description; ///< for those who do not see it, as plain text
    Axis x;
    Axis y;
    std::vector<PlotSeries> series;
};

/// A figure element: the plot as an inline SVG of fixed proportions, which takes its colours from the page's style, and
/// under it what its lines are.
std::string plotFigure(const Plot& plot);

} // namespace lodsmith::cli
