#include <lodsmith/ogre/LodConfig.h>

#include "MainThread.h"

#include <lodsmith/core/Assert.h>

#include <cmath>

namespace lodsmith {

LodConfig automaticLodConfig(const Ogre::MeshPtr& mesh)
{
    assertMainThread();
    LODSMITH_ASSERT(mesh, "automaticLodConfig() needs a mesh");
    LodConfig config;
    config.mesh = mesh;
    config.strategy = "pixel_count";
    config.options.metric = Metric::Curvature;
    for (int i = 2; i <= 5; ++i) {
        const double pixels = 3388608.0 / std::pow(i, 4);
        const double cost = static_cast<double>(mesh->getBoundingSphereRadius()) * std::pow(i, 5) / 100000.0;
        config.levels.push_back(LodLevel{static_cast<Ogre::Real>(pixels), {LevelTarget::Kind::CollapseCost, cost}, {}});
    }
    return config;
}

} // namespace lodsmith
