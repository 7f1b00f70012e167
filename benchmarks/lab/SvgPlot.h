#pragma once

#include <string>
#include <vector>

namespace lodsmith::benchmarks {

struct PlotPoint {
    double x = 0.0;
    double y = 0.0;
};

/// A number that is marked on an axis.
struct PlotTick {
    double at = 0.0;
    std::string label;
};

/// An axis from `low` to `high`, on the left and at the bottom; `low` may be the greater one. A logarithmic axis is above 0.
struct PlotAxis {
    std::string label;
    double low = 0.0;
    double high = 1.0;
    bool logarithmic = false;
    std::vector<PlotTick> ticks;
};

struct PlotSeries {
    std::string name;
    std::string colour; ///< as in CSS
    bool line = false;  ///< otherwise a dot at each point
    std::vector<PlotPoint> points;
};

/// A plot for the documents, as a picture of its own.
struct SvgPlot {
    std::string title; ///< for those who do not see it
    PlotAxis x;
    PlotAxis y;
    std::vector<PlotSeries> series;
    double legendX = 0.5; ///< 0..1 from the left
    double legendY = 0.1; ///< 0..1 from the top
};

/// The plot as SVG. Points beyond an axis are drawn at its end. Names and labels are plain text.
std::string toSvg(const SvgPlot& plot);

} // namespace lodsmith::benchmarks
