#include <lodsmith/loddef/LodDefinition.h>

#include "DefinitionCheck.h"

#include <algorithm>
#include <tuple>

namespace lodsmith {

namespace {

bool hasCollapseCost(const LodLevelDefinition& level)
{
    return !level.isManual() && level.target.kind == LevelTarget::Kind::CollapseCost;
}

bool sameLevel(const LodLevelDefinition& a, const LodLevelDefinition& b)
{
    return a.value == b.value && a.meshName == b.meshName
           && (a.isManual() || (a.target.kind == b.target.kind && a.target.amount == b.target.amount));
}

bool sameSubMesh(const SubMeshImportance& a, const SubMeshImportance& b)
{
    return a.subMesh == b.subMesh && a.importance == b.importance;
}

auto tied(const GivenAttributeWeights& weights)
{
    return std::tie(weights.normal, weights.uv, weights.colour, weights.bone);
}

} // namespace

const char* ogreName(LodStrategy strategy)
{
    switch (strategy) {
    case LodStrategy::DistanceSphere: return "distance_sphere";
    case LodStrategy::DistanceBox: return "distance_box";
    case LodStrategy::PixelCount: return "pixel_count";
    case LodStrategy::ScreenRatioPixelCount: return "screen_ratio_pixel_count";
    }
    return "";
}

bool operator==(const LodDefinition& a, const LodDefinition& b)
{
    return a.automatic == b.automatic && a.type == b.type && a.strategy == b.strategy && a.metric == b.metric
           && a.lockBorders == b.lockBorders && tied(a.weights) == tied(b.weights)
           && std::equal(a.levels.begin(), a.levels.end(), b.levels.begin(), b.levels.end(), sameLevel)
           && std::equal(a.subMeshes.begin(), a.subMeshes.end(), b.subMeshes.begin(), b.subMeshes.end(), sameSubMesh);
}

std::vector<Error> findErrors(const LodDefinition& definition)
{
    return findErrors(definition, nullptr);
}

std::vector<LodLevelDefinition> levelsNearestFirst(const LodDefinition& definition)
{
    const bool rising =
        definition.strategy == LodStrategy::DistanceSphere || definition.strategy == LodStrategy::DistanceBox;
    std::vector<LodLevelDefinition> levels = definition.levels;
    std::sort(levels.begin(), levels.end(), [rising](const LodLevelDefinition& a, const LodLevelDefinition& b) {
        return rising ? a.value < b.value : a.value > b.value;
    });
    return levels;
}

SimplifyOptions simplifyOptions(const LodDefinition& definition)
{
    const auto& levels = definition.levels;
    const bool curvature = std::any_of(levels.begin(), levels.end(), hasCollapseCost);
    SimplifyOptions options;
    options.metric = definition.metric.value_or(curvature ? Metric::Curvature : Metric::Quadric);
    options.weights.normal = definition.weights.normal.value_or(options.weights.normal);
    options.weights.uv = definition.weights.uv.value_or(options.weights.uv);
    options.weights.colour = definition.weights.colour.value_or(options.weights.colour);
    options.weights.bone = definition.weights.bone.value_or(options.weights.bone);
    options.lockBorders = definition.lockBorders;
    return options;
}

} // namespace lodsmith
