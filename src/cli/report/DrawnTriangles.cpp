#include "DrawnTriangles.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace lodsmith::cli {

namespace {

constexpr double kFewest = 0.03, kMost = 0.6;

double trianglesAt(const std::vector<DrawnLevel>& levels, double distance)
{
    double triangles = 0.0;
    for (const DrawnLevel& level : levels)
        if (level.distance <= distance)
            triangles = level.triangles;
    return triangles;
}

/// Where either chain changes between two distances, with the first of these.
std::vector<double> changes(const std::vector<DrawnLevel>& levels, const std::vector<DrawnLevel>& other, double near,
                            double far)
{
    std::vector<double> distances{near};
    for (const auto* chain : {&levels, &other})
        for (const DrawnLevel& level : *chain)
            if (level.distance > near && level.distance < far)
                distances.push_back(level.distance);
    std::sort(distances.begin(), distances.end());
    return distances;
}

/// Triangles of a curve at a deviation, between its points along straight lines of both logarithms.
std::optional<double> trianglesFor(const std::vector<CurvePoint>& curve, double deviation)
{
    for (std::size_t i = 1; i < curve.size(); ++i) {
        const CurvePoint& before = curve[i - 1];
        const CurvePoint& point = curve[i];
        if (point.deviation < deviation || before.deviation > deviation)
            continue;
        if (!(before.deviation > 0.0) || point.deviation <= before.deviation)
            return point.triangles;
        const double part = std::log(deviation / before.deviation) / std::log(point.deviation / before.deviation);
        return before.triangles * std::pow(point.triangles / before.triangles, part);
    }
    // Even its last point is better than that.
    if (!curve.empty() && curve.back().deviation < deviation)
        return curve.back().triangles;
    return std::nullopt;
}

} // namespace

double meanTriangles(const std::vector<DrawnLevel>& levels, double near, double far)
{
    std::vector<double> distances = changes(levels, {}, near, far);
    distances.push_back(far);
    double sum = 0.0;
    for (std::size_t i = 1; i < distances.size(); ++i)
        sum += trianglesAt(levels, distances[i - 1]) * std::log(distances[i] / distances[i - 1]);
    return sum / std::log(far / near);
}

double worstExcess(const std::vector<DrawnLevel>& levels, const std::vector<DrawnLevel>& other, double near, double far,
                   double& from)
{
    double worst = 0.0;
    for (const double distance : changes(levels, other, near, far)) {
        const double excess = trianglesAt(levels, distance) / std::max(trianglesAt(other, distance), 1.0);
        if (excess > worst) {
            worst = excess;
            from = distance;
        }
    }
    return worst;
}

double trianglesFactor(const std::vector<CurvePoint>& curve, const std::vector<CurvePoint>& other)
{
    double sum = 0.0;
    int points = 0;
    for (const CurvePoint& point : curve) {
        if (point.triangles < kFewest * curve.front().triangles || point.triangles > kMost * curve.front().triangles)
            continue;
        const std::optional<double> fewer = trianglesFor(other, point.deviation);
        if (!fewer || !(*fewer > 0.0))
            continue;
        sum += std::log(point.triangles / *fewer);
        ++points;
    }
    return points > 0 ? std::exp(sum / points) : 1.0;
}

} // namespace lodsmith::cli
