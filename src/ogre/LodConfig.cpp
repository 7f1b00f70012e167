#include <lodsmith/ogre/LodConfig.h>

#include "MainThread.h"

#include <lodsmith/core/Assert.h>

#include <algorithm>
#include <cmath>

namespace lodsmith {

namespace {

constexpr unsigned kFirst = 2;
/// Up to here the formula of the curvature metric goes.
constexpr unsigned kLast = 5;
constexpr double kPi = 3.14159265358979323846;
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

} // namespace

LodConfig automaticLodConfig(const Ogre::MeshPtr& mesh, const AutomaticLods& automatic)
{
    assertMainThread();
    LODSMITH_ASSERT(mesh, "automaticLodConfig() needs a mesh");
    LODSMITH_ASSERT(troubleWith(automatic).empty(), "automaticLodConfig() needs settings in range");
    LodConfig config;
    config.mesh = mesh;
    config.strategy = "pixel_count";
    config.options.metric = automatic.metric;
    const double radius = mesh->getBoundingSphereRadius();
    const unsigned last = std::max(kLast, automatic.levels + kFirst - 1);
    for (unsigned i = last + 1 - automatic.levels; i <= last; ++i) {
        const double pixels = pixelsOf(i) / (automatic.quality * automatic.quality);
        const LevelTarget target{LevelTarget::Kind::CollapseCost, costOf(i, automatic.metric, radius)};
        config.levels.push_back(LodLevel{static_cast<Ogre::Real>(pixels), target, {}});
    }
    return config;
}

std::string troubleWith(const AutomaticLods& automatic)
{
    if (automatic.levels < 1 || automatic.levels > AutomaticLods::kMaxLevels)
        return "automatic levels are 1 to " + std::to_string(AutomaticLods::kMaxLevels) + ", not "
               + std::to_string(automatic.levels);
    if (!(automatic.quality >= AutomaticLods::kMinQuality && automatic.quality <= AutomaticLods::kMaxQuality))
        return "the quality of automatic levels is 0.1 to 10, not " + std::to_string(automatic.quality);
    return "";
}

} // namespace lodsmith
