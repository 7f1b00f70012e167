#include "Definition.h"
#include "Services.h"
#include <lodsmith/lua/Numbers.h>

#include <lodsmith/ogre/AutomaticLods.h>

#include <cmath>
#include <cstdint>
#include <limits>

namespace lodsmith::lua {

namespace {

/// Of candidate levels those that the mesh has, or all when it has none; without the nearest ones where these are too many.
std::vector<LodLevel> chosenLevels(const LodConfig& config)
{
    std::vector<LodLevel> levels;
    for (const LodLevel& level : config.levels)
        for (Ogre::ushort i = 1; i < config.mesh->getNumLodLevels(); ++i)
            if (config.mesh->getLodLevel(i).userValue == level.value)
                levels.push_back(level);
    if (levels.empty())
        levels = config.levels;
    if (levels.size() > config.mostLevels)
        levels.erase(levels.begin(), levels.end() - config.mostLevels);
    return levels;
}

/// An automatic configuration as levels that somebody may edit.
LodDefinition explicitDefinition(const LodConfig& config)
{
    LodDefinition definition;
    definition.automatic = false;
    definition.strategy = LodStrategy::PixelCount;
    definition.metric = config.options.metric;
    for (const LodLevel& level : config.mostLevels > 0 ? chosenLevels(config) : config.levels) {
        LodLevelDefinition explicitLevel;
        explicitLevel.value = level.value;
        explicitLevel.target = level.target;
        definition.levels.push_back(std::move(explicitLevel));
    }
    return definition;
}

} // namespace

Manager::Manager(const std::shared_ptr<Services>& services) : ServiceHandle("lodsmith::Manager", "manager", services) {}

Returned Manager::apply(const Mesh& handle, const Definition* definition) const
{
    return withMesh(handle, [&](Services& services, const Ogre::MeshPtr& mesh) -> Returned {
        const Result<LodDecision> decision =
            definition ? services.manager.apply(mesh, definition->data()) : services.manager.apply(mesh);
        if (!decision)
            return decision.error();
        return decision.value();
    });
}

Returned Manager::applyToAll() const
{
    return withServices([](Services& services) -> Returned {
        services.manager.applyToAll();
        return true;
    });
}

Returned Manager::automaticDefinition(const Mesh& handle, OptionalNumber levels) const
{
    return withMesh(handle, [&](Services& services, const Ogre::MeshPtr& mesh) -> Returned {
        AutomaticLods automatic = services.manager.policy().automaticLods;
        if (levels && !(*levels >= 1 && *levels <= AutomaticLods::kMaxLevels && *levels == std::floor(*levels)))
            return Returned::failure(numberText(*levels) + " is no number of automatic levels, 1 to "
                                     + std::to_string(AutomaticLods::kMaxLevels));
        if (levels)
            automatic.levels = static_cast<unsigned>(*levels);
        if (std::string trouble = troubleWith(automatic); !trouble.empty())
            return Returned::failure(trouble);
        if (!(mesh->getBoundingSphereRadius() > 0))
            return Error{ErrorCode::InvalidGeometry, "the mesh has no bounding radius", mesh->getName()};
        return std::make_unique<Definition>(explicitDefinition(automaticLodConfig(mesh, automatic)));
    });
}

Returned Manager::enabled() const
{
    return withServices([](Services& services) -> Returned { return services.manager.policy().enabled; });
}

Returned Manager::automatic() const
{
    return withServices([](Services& services) -> Returned { return services.manager.policy().automatic; });
}

Returned Manager::minTriangles() const
{
    return withServices([](Services& services) -> Returned { return services.manager.policy().minTriangles; });
}

template <class Change>
Returned Manager::changePolicy(const Change& change) const
{
    return withServices([&](Services& services) -> Returned {
        LodPolicy policy = services.manager.policy();
        change(policy);
        services.manager.setPolicy(policy);
        return true;
    });
}

Returned Manager::setEnabled(bool enabled) const
{
    return changePolicy([&](LodPolicy& policy) { policy.enabled = enabled; });
}

Returned Manager::setAutomatic(bool automatic) const
{
    return changePolicy([&](LodPolicy& policy) { policy.automatic = automatic; });
}

Returned Manager::setMinTriangles(double triangles) const
{
    if (!(triangles >= 0 && triangles <= double(std::numeric_limits<std::uint32_t>::max())))
        return Returned::failure(numberText(triangles) + " is no number of triangles");
    return changePolicy([&](LodPolicy& policy) { policy.minTriangles = static_cast<std::uint32_t>(triangles); });
}

} // namespace lodsmith::lua
