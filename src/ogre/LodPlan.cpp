#include "LodPlan.h"

#include "LivingEntities.h"

#include <OgreLodStrategy.h>
#include <OgreLodStrategyManager.h>
#include <OgreMeshManager.h>
#include <OgreResourceGroupManager.h>
#include <OgreStringConverter.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

namespace lodsmith {

namespace {

Error badSetting(std::string message)
{
    return Error{ErrorCode::InvalidSetting, std::move(message)};
}

std::string levelName(std::size_t index)
{
    return "level " + std::to_string(index + 1) + ": ";
}

/// Compares what the strategy will compare, so that values which its transformation makes equal are found too.
std::optional<Error> planValues(const LodConfig& config, LodPlan& plan)
{
    const bool rising = plan.strategy->isSorted({Ogre::Real(1), Ogre::Real(2)});
    Ogre::Real before = plan.strategy->getBaseValue();
    for (std::size_t i = 0; i < config.levels.size(); ++i) {
        const Ogre::Real value = config.levels[i].value;
        const Ogre::Real transformed = plan.strategy->transformUserValue(value);
        if (!std::isfinite(value) || !(value > 0) || !std::isfinite(transformed))
            return badSetting(levelName(i) + "the value " + Ogre::StringConverter::toString(value)
                              + " is not a positive number in the strategy's range");
        if (rising ? !(transformed > before) : !(transformed < before))
            return badSetting(levelName(i) + "the value " + Ogre::StringConverter::toString(value) + " has to be "
                              + (rising ? "greater" : "smaller") + " than the one before under the strategy "
                              + plan.strategy->getName());
        plan.values.push_back(transformed);
        before = transformed;
    }
    return std::nullopt;
}

/// Null when there is no such mesh. Looks where OGRE will look for it: in the group of the mesh.
Ogre::MeshPtr findMesh(const Ogre::String& name, const Ogre::String& group)
{
    auto& manager = Ogre::MeshManager::getSingleton();
    Ogre::MeshPtr mesh = manager.getByName(name, group);
    if (!mesh && Ogre::ResourceGroupManager::getSingleton().resourceExists(group, name))
        mesh = manager.load(name, group);
    else if (mesh && !mesh->isLoaded() && !mesh->isManuallyLoaded())
        mesh->load();
    return mesh;
}

Result<Ogre::MeshPtr> planManualLevel(const LodConfig& config, std::size_t index)
{
    Result<Ogre::MeshPtr> mesh = findManualMesh(config.levels[index].manualMeshName, *config.mesh);
    if (mesh)
        return mesh;
    Error error = mesh.error();
    error.message = levelName(index) + error.message;
    return error;
}

std::optional<Error> checkImportance(const LodConfig& config)
{
    const std::vector<float>& importance = config.subMeshImportance;
    if (importance.size() > config.mesh->getNumSubMeshes())
        return badSetting("there are " + std::to_string(importance.size()) + " importances for "
                          + std::to_string(config.mesh->getNumSubMeshes()) + " submeshes");
    for (std::size_t i = 0; i < importance.size(); ++i)
        if (!(importance[i] >= 0.0f && importance[i] <= 1.0f))
            return badSetting("submesh " + std::to_string(i) + ": the importance "
                              + Ogre::StringConverter::toString(importance[i]) + " is not in 0..1");
    return std::nullopt;
}

} // namespace

Result<Ogre::MeshPtr> findManualMesh(const Ogre::String& name, const Ogre::Mesh& owner)
{
    Ogre::MeshPtr mesh;
    try {
        mesh = findMesh(name, owner.getGroup());
    } catch (const Ogre::Exception& exception) {
        return Error{ErrorCode::NotFound, "the mesh \"" + name + "\" cannot be loaded: " + exception.getDescription()};
    } catch (const std::exception& exception) { // OGRE throws std::bad_cast over a file that is no mesh
        return Error{ErrorCode::NotFound, "the mesh \"" + name + "\" cannot be loaded: " + exception.what()};
    }
    if (!mesh)
        return Error{ErrorCode::NotFound, "there is no mesh \"" + name + "\" in the group " + owner.getGroup()};
    if (mesh.get() == &owner)
        return badSetting("the mesh cannot be its own manual level");
    if (mesh->getNumLodLevels() > 1)
        return Error{ErrorCode::Unsupported,
                     "the mesh \"" + name + "\" has levels of its own, OGRE allows none in a manual level"};
    return mesh;
}

Result<LodPlan> planLods(const LodConfig& config)
{
    LodPlan plan;
    plan.strategy = Ogre::LodStrategyManager::getSingleton().getStrategy(config.strategy);
    if (!plan.strategy)
        return badSetting("OGRE knows no level-of-detail strategy \"" + config.strategy + "\"");
    if (config.levels.size() >= std::numeric_limits<Ogre::ushort>::max())
        return badSetting("OGRE holds at most 65534 levels beside the first");
    if (auto error = planValues(config, plan))
        return *error;
    if (auto error = checkImportance(config))
        return *error;
    if (config.mostLevels > 0
        && std::any_of(config.levels.begin(), config.levels.end(), std::mem_fn(&LodLevel::isManual)))
        return badSetting("there can be no hand-made levels among those that are to be chosen from");

    // OGRE never takes the mark of manual levels off a mesh again, so that earlier ones count as well.
    const bool manual = config.mesh->hasManualLodLevel()
                        || std::any_of(config.levels.begin(), config.levels.end(), std::mem_fn(&LodLevel::isManual));
    if (manual && !config.reinitialiseEntities && !livingEntities(*config.mesh).empty())
        return Error{ErrorCode::Unsupported,
                     "the mesh has manual levels and an entity that was made without knowing the new ones; destroy its "
                     "entities first, have them initialised again, or load the mesh again"};
    for (std::size_t i = 0; i < config.levels.size(); ++i) {
        if (!config.levels[i].isManual()) {
            plan.manualMeshes.emplace_back();
            continue;
        }
        Result<Ogre::MeshPtr> mesh = planManualLevel(config, i);
        if (!mesh)
            return mesh.error();
        plan.manualMeshes.push_back(mesh.value());
    }
    return plan;
}

} // namespace lodsmith
