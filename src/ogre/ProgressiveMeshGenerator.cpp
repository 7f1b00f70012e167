#include <lodsmith/ogre/ProgressiveMeshGenerator.h>

#include "GenerationSteps.h"
#include "MainThread.h"
#include "OgreGuard.h"

#include <lodsmith/core/Assert.h>

#include <utility>

namespace lodsmith {

namespace {

Result<LodReport> generate(const LodConfig& config, const std::shared_ptr<LodCache>& cache, Progress* progress)
{
    Result<PreparedLods> prepared = prepareLods(config, cache);
    if (!prepared)
        return prepared.error();
    const Result<ComputedLods> computed = computeLods(prepared.value(), progress);
    if (!computed)
        return computed.error();
    return finishLods(config, prepared.value(), computed.value());
}

} // namespace

ProgressiveMeshGenerator::ProgressiveMeshGenerator(std::shared_ptr<LodCache> cache) : mCache(std::move(cache)) {}

Result<LodReport> ProgressiveMeshGenerator::generateLodLevels(const LodConfig& config, Progress* progress)
{
    assertMainThread();
    LODSMITH_ASSERT(config.mesh, "generateLodLevels() needs a mesh");
    return guarded(config.mesh->getName(), [&] { return generate(config, mCache, progress); });
}

Result<LodReport> ProgressiveMeshGenerator::generateAutoconfiguredLodLevels(const Ogre::MeshPtr& mesh,
                                                                            Progress* progress,
                                                                            const AutomaticLods& automatic)
{
    assertMainThread();
    LODSMITH_ASSERT(mesh, "generateAutoconfiguredLodLevels() needs a mesh");
    const Result<LodConfig> config = checkedAutomaticConfig(mesh, automatic);
    if (!config)
        return config.error();
    return generateLodLevels(config.value(), progress);
}

} // namespace lodsmith
