#include "MeshPlots.h"

#include "DrawnTriangles.h"
#include "Figures.h"

#include <algorithm>

namespace lodsmith::cli {

namespace {

std::string trianglesWords(double triangles)
{
    return wholeNumber(triangles) + " triangles";
}

PlotSeries curveSeries(const Json& record, double percent)
{
    PlotSeries series{"What simplifying can reach, largest", 1, PlotSeries::Line::Straight, {}};
    for (const Json& point : record["curve"]) {
        const double triangles = point["triangles"].get<double>(), deviation = point["max"].get<double>() * percent;
        // The mesh itself has none, which a logarithmic axis cannot show.
        if (deviation > 0.0)
            series.points.push_back(
                {triangles, deviation, trianglesWords(triangles) + ": at most " + shortNumber(deviation) + " % off"});
    }
    return series;
}

std::string levelTitle(std::size_t number, double triangles, const std::string& figure, double deviation)
{
    return "Level " + std::to_string(number) + ", " + trianglesWords(triangles) + ": " + figure + " "
           + shortNumber(deviation) + " %";
}

PlotSeries levelSeries(const Json& record, const std::string& figure, const std::string& name, int style,
                       double percent)
{
    PlotSeries series{name, style, PlotSeries::Line::None, {}};
    for (std::size_t i = 1; i < record["levels"].size(); ++i) {
        const Json& level = record["levels"][i];
        const double triangles = level["triangles"].get<double>();
        const double deviation = level["surface"][figure].get<double>() * percent;
        series.points.push_back({triangles, deviation, levelTitle(i, triangles, figure, deviation)});
    }
    return series;
}

/// One step a level, within the range of the plot.
PlotSeries stepSeries(const std::string& name, int style, const std::vector<DrawnLevel>& levels, double near,
                      double far)
{
    PlotSeries series{name, style, PlotSeries::Line::Steps, {}};
    double drawn = 0.0;
    for (const DrawnLevel& level : levels)
        if (level.distance <= near)
            drawn = level.triangles;
    series.points.push_back({near, drawn, ""});
    for (std::size_t i = 1; i < levels.size(); ++i) {
        const DrawnLevel& level = levels[i];
        if (level.distance <= near || level.distance >= far)
            continue;
        drawn = level.triangles;
        series.points.push_back(
            {level.distance, drawn,
             "Level " + std::to_string(i) + " from " + shortNumber(level.distance) + " on: " + trianglesWords(drawn)});
    }
    series.points.push_back({far, drawn, ""});
    return series;
}

std::vector<DrawnLevel> drawnLevels(const Json& levels)
{
    std::vector<DrawnLevel> drawn;
    // A level that never appears has no distance.
    for (const Json& level : levels)
        if (level["distance"].is_number())
            drawn.push_back({level["distance"].get<double>(), level["triangles"].get<double>()});
    return drawn;
}

void fitAxes(Plot& plot, const std::string& xLabel, const std::string& yLabel)
{
    std::vector<double> x, y;
    for (const PlotSeries& series : plot.series)
        for (const PlotPoint& point : series.points) {
            x.push_back(point.x);
            y.push_back(point.y);
        }
    plot.x = axisFor(xLabel, Axis::Scale::Logarithmic, x);
    plot.y = axisFor(yLabel, Axis::Scale::Logarithmic, y);
}

} // namespace

Plot deviationPlot(const Json& record)
{
    const double percent = 100.0 / record["radius"].get<double>();
    Plot plot;
    plot.id = "deviation";
    plot.title = "Deviation over triangles";
    plot.description = "Deviation from the original in percent of the radius over the number of triangles, both axes "
                       "logarithmic. The table of levels has the numbers.";
    plot.series.push_back(curveSeries(record, percent));
    if (record["levels"].size() > 1) {
        plot.series.push_back(levelSeries(record, "max", "Levels, largest", 2, percent));
        plot.series.push_back(levelSeries(record, "mean", "Levels, mean", 3, percent));
    }
    fitAxes(plot, "Triangles", "Deviation, % of the radius");
    return plot;
}

Plot distancePlot(const Json& record)
{
    const double near = record["drawn"]["near"].get<double>(), far = record["drawn"]["far"].get<double>();
    const std::string from = record["levels_from"].get<std::string>();
    const std::vector<DrawnLevel> judged = drawnLevels(record["levels"]);
    Plot plot;
    plot.id = "distance";
    plot.title = "Triangles over distance";
    plot.description =
        "Triangles drawn over the distance in world units, both axes logarithmic, from where the mesh is as high "
        "as the picture to where it is a speck. The table of levels has the numbers.";
    plot.series.push_back(stepSeries(from == "file" ? "Levels of the file" : "As the file is, without levels", 2,
                                     from == "file" ? judged : std::vector<DrawnLevel>{judged.front()}, near, far));
    if (from == "definition")
        plot.series.push_back(stepSeries("As the definition says", 3, judged, near, far));
    plot.series.push_back(stepSeries("Automatic levels", 1, drawnLevels(record["automatic_levels"]), near, far));
    fitAxes(plot, "Distance, world units", "Triangles drawn");
    plot.x.low = near;
    plot.x.high = far;
    return plot;
}

} // namespace lodsmith::cli
