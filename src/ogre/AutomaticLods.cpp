#include <lodsmith/ogre/AutomaticLods.h>

#include "MainThread.h"

#include <lodsmith/core/Assert.h>

#include <algorithm>
#include <cmath>

namespace lodsmith {

namespace {

constexpr double kPi = 3.14159265358979323846;

namespace balanced {

/// Radii on screen, in pixels, as powers of two. Nearer than the first the camera would almost be inside the bounding sphere; half
/// octaves between them take a fifth longer and save a hundredth.
constexpr int kLargest = 9;
constexpr int kSmallest = 1;

void addLevels(LodConfig& config, double radius, const AutomaticLods& automatic)
{
    config.options.metric = automatic.metric.value_or(Metric::Quadric);
    config.mostLevels = automatic.levels.value_or(AutomaticLods::kMaxLevels);
    for (int power = kLargest; power >= kSmallest; --power) {
        const double size = std::ldexp(1.0, power);
        const LevelTarget target{LevelTarget::Kind::Deviation, automatic.pixels / size * radius};
        config.levels.push_back(LodLevel{static_cast<Ogre::Real>(kPi * size * size), target, {}});
    }
}

} // namespace balanced

namespace classic {

constexpr unsigned kFirst = 2;
/// Up to here the formula of the curvature metric goes.
constexpr unsigned kLast = 5;
constexpr double kPixelsOfOne = 3388608.0;
/// Of the quadric metric, when a level appears.
constexpr double kQuadricPixels = 0.5;

double pixelsOf(unsigned i)
{
    return kPixelsOfOne / std::pow(i, 4);
}

double costOf(unsigned i, Metric metric, double radius)
{
    if (metric == Metric::Quadric)
        return kQuadricPixels * radius / std::sqrt(pixelsOf(i) / kPi);
    const unsigned within = std::min(i, kLast);
    return radius * std::pow(within, 5) / 100000.0 * std::pow(static_cast<double>(i) / within, 2);
}

void addLevels(LodConfig& config, double radius, const AutomaticLods& automatic)
{
    const unsigned levels = automatic.levels.value_or(kLast - kFirst + 1);
    config.options.metric = automatic.metric.value_or(Metric::Curvature);
    const unsigned last = std::max(kLast, levels + kFirst - 1);
    for (unsigned i = last + 1 - levels; i <= last; ++i) {
        const double pixels = pixelsOf(i) * automatic.pixels * automatic.pixels;
        const LevelTarget target{LevelTarget::Kind::CollapseCost, costOf(i, config.options.metric, radius)};
        config.levels.push_back(LodLevel{static_cast<Ogre::Real>(pixels), target, {}});
    }
}

} // namespace classic

} // namespace

LodConfig automaticLodConfig(const Ogre::MeshPtr& mesh, const AutomaticLods& automatic)
{
    assertMainThread();
    LODSMITH_ASSERT(mesh, "automaticLodConfig() needs a mesh");
    LODSMITH_ASSERT(troubleWith(automatic).empty(), "automaticLodConfig() needs settings in range");
    LodConfig config;
    config.mesh = mesh;
    config.strategy = "pixel_count";
    const double radius = mesh->getBoundingSphereRadius();
    if (automatic.method == AutomaticLods::Method::Balanced)
        balanced::addLevels(config, radius, automatic);
    else
        classic::addLevels(config, radius, automatic);
    return config;
}

std::string troubleWith(const AutomaticLods& automatic)
{
    if (automatic.levels && (*automatic.levels < 1 || *automatic.levels > AutomaticLods::kMaxLevels))
        return "automatic levels are 1 to " + std::to_string(AutomaticLods::kMaxLevels) + ", not "
               + std::to_string(*automatic.levels);
    if (!(automatic.pixels >= AutomaticLods::kMinPixels && automatic.pixels <= AutomaticLods::kMaxPixels))
        return "the error of automatic levels is 0.1 to 10 pixels, not " + std::to_string(automatic.pixels);
    return "";
}

} // namespace lodsmith
