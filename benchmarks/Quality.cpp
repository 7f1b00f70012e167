#include "Quality.h"

#include <lodsmith/analysis/MeshStatistics.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace lodsmith::benchmarks {

namespace {

std::uint32_t weldedVertices(const MeshView& view)
{
    const Result<MeshStatistics> statistics = meshStatistics(view);
    if (!statistics)
        throw std::runtime_error(describe(statistics.error()));
    return statistics.value().vertices;
}

} // namespace

std::vector<MeasuredLevel> measureLevels(const Subject& subject, const std::vector<PeerLevel>& levels,
                                         const DeviationOptions& options)
{
    std::vector<MeasuredLevel> measured;
    for (const PeerLevel& made : levels) {
        const MeshView view = levelView(subject.view(), made.indices);
        MeasuredLevel& level =
            measured.emplace_back(MeasuredLevel{triangleCount(made.indices), weldedVertices(view), made.stop, {}});
        if (level.triangles == 0)
            continue;
        const Result<Deviation> deviation = measureDeviation(subject.view(), view, options);
        if (!deviation)
            throw std::runtime_error(describe(deviation.error()));
        level.deviation = deviation.value();
    }
    return measured;
}

double visiblePixels(const Subject& subject, double pixels, const MeasuredLevel& level)
{
    constexpr double kPi = 3.14159265358979323846;
    const double radius = subject.mesh()->getBoundingSphereRadius();
    if (pixels <= 0.0 || !level.deviation || radius <= 0.0)
        return std::numeric_limits<double>::quiet_NaN();
    return level.deviation->surface.maximum / radius * std::sqrt(pixels / kPi);
}

bool reached(const MeasuredLevel& level, std::uint32_t triangles)
{
    const double tolerance = std::max(2.0, 0.02 * triangles);
    return level.deviation && std::abs(double(level.triangles) - double(triangles)) <= tolerance;
}

} // namespace lodsmith::benchmarks
