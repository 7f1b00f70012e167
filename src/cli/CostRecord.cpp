#include "CostRecord.h"

#include "../ogre/TrianglesIn.h"
#include "CheapestLevels.h"

#include <lodsmith/ogre/LevelBytes.h>

#include <OgreLodStrategy.h>
#include <OgreSubMesh.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace lodsmith::cli {

namespace {

Error withFile(Error error, const std::filesystem::path& file)
{
    error.file = file.string();
    return error;
}

std::uint64_t trianglesOf(const Ogre::Mesh& mesh, unsigned level)
{
    std::uint64_t triangles = 0;
    for (const Ogre::SubMesh* subMesh : mesh.getSubMeshes()) {
        const Ogre::IndexData* indices = level == 0 ? subMesh->indexData : subMesh->mLodFaceList[level - 1];
        triangles += indices ? trianglesIn(subMesh->operationType, indices->indexCount) : 0;
    }
    return triangles;
}

/// Null for a hand-made level whose mesh OGRE does not load.
Json drawnTriangles(const Ogre::Mesh& mesh, unsigned level)
{
    const Ogre::MeshLodUsage& usage = mesh.getLodLevel(static_cast<Ogre::ushort>(level));
    if (level == 0 || usage.manualName.empty())
        return trianglesOf(mesh, level);
    return usage.manualMesh ? Json(trianglesOf(*usage.manualMesh, 0)) : Json(nullptr);
}

/// Metres: half the diagonal of the bounding box.
Result<double> radiusOf(const Ogre::Mesh& mesh, const CostSettings& settings)
{
    const Ogre::AxisAlignedBox& bounds = mesh.getBounds();
    const double radius =
        bounds.isFinite() ? static_cast<double>(bounds.getSize().length()) / 2.0 * settings.metresPerUnit : 0.0;
    if (!(radius > 0.0) || !std::isfinite(radius))
        return Error{ErrorCode::InvalidGeometry, "has no bounding box, which the cost goes by"};
    return radius;
}

/// Metres, of levels 1 and up.
Result<std::vector<double>> distancesOf(const Ogre::Mesh& mesh, double radius, const CostSettings& settings)
{
    const unsigned levels = mesh.getNumLodLevels();
    if (settings.presetDistances)
        return presetDistances(radius, levels, settings.formula);
    std::vector<double> distances;
    for (unsigned level = 1; level < levels; ++level) {
        const double value = mesh.getLodLevel(static_cast<Ogre::ushort>(level)).userValue;
        const Result<double> distance = switchDistance(mesh, value, settings.view);
        if (!distance)
            return distance.error();
        distances.push_back(std::min(distance.value() * settings.metresPerUnit, settings.formula.largestDistance));
    }
    return distances;
}

CostedLevel costedLevel(const LevelBytes& level, const CostSettings& settings)
{
    const auto bytes = static_cast<double>(level.bytes), duplicates = static_cast<double>(level.duplicateBytes);
    if (!settings.zlibSizes || level.bytes == 0)
        return {bytes, duplicates};
    const auto packed = static_cast<double>(level.zlibBytes);
    return {packed, duplicates * packed / bytes};
}

Json levelRecord(const Ogre::Mesh& mesh, unsigned level, const LevelBytes& bytes, const LevelCost& cost)
{
    const Json value = level == 0 ? Json() : Json(mesh.getLodLevel(static_cast<Ogre::ushort>(level)).userValue);
    return Json{{"level", level},
                {"manual", bytes.manual.empty() ? Json(nullptr) : Json(bytes.manual)},
                {"value", value},
                {"distance", cost.distance},
                {"triangles", drawnTriangles(mesh, level)},
                {"bytes", bytes.bytes},
                {"zlib_bytes", bytes.zlibBytes},
                {"duplicate_bytes", bytes.duplicateBytes},
                {"counted_triangles", cost.triangles},
                {"share", cost.share},
                {"cost", cost.cost},
                {"cost_per_byte", cost.costPerByte}};
}

/// The level that saves most for each byte that it loses; null when none saves anything.
Json shrinkFirst(const StreamingCost& cost)
{
    const auto best =
        std::max_element(cost.levels.begin(), cost.levels.end(),
                         [](const LevelCost& a, const LevelCost& b) { return a.costPerByte < b.costPerByte; });
    return best->costPerByte > 0.0 ? Json(best - cost.levels.begin()) : Json(nullptr);
}

Json filesRecord(const MeshBytes& bytes)
{
    Json files = Json::array();
    for (const CountedFile& file : bytes.files)
        files.push_back({{"file", file.file.string()}, {"bytes", file.bytes}, {"level", file.level}});
    return files;
}

/// What is drawn at each of the places asked for.
Json seenRecord(const StreamingCost& cost, const MeshBytes& bytes, const std::vector<double>& places)
{
    Json seen = Json::array();
    for (const double distance : places) {
        const std::size_t level = levelAt(cost, distance);
        seen.push_back({{"distance", distance}, {"level", level}, {"bytes", bytes.levels[level].bytes}});
    }
    return seen;
}

std::uint64_t sum(const MeshBytes& bytes, std::uint64_t LevelBytes::*member)
{
    std::uint64_t result = 0;
    for (const LevelBytes& level : bytes.levels)
        result += level.*member;
    return result;
}

Json wholeRecord(const Ogre::Mesh& mesh, const MeshBytes& bytes, const StreamingCost& cost, double radius,
                 const CostSettings& settings)
{
    Json record{{"preset", settings.preset},
                {"sizes", settings.zlibSizes ? "zlib" : "raw"},
                {"strategy", settings.presetDistances ? Json(nullptr) : Json(mesh.getLodStrategy()->getName())},
                {"radius", radius},
                {"cost", cost.cost},
                {"weighted_triangles", cost.weightedTriangles},
                {"bytes", sum(bytes, &LevelBytes::bytes)},
                {"zlib_bytes", sum(bytes, &LevelBytes::zlibBytes)},
                {"duplicate_bytes", sum(bytes, &LevelBytes::duplicateBytes)},
                {"shrink_first", shrinkFirst(cost)},
                {"levels", Json::array()},
                {"seen", seenRecord(cost, bytes, settings.places)},
                {"files", filesRecord(bytes)},
                {"notes", bytes.notes},
                {"optimised", nullptr}};
    for (unsigned level = 0; level < bytes.levels.size(); ++level)
        record["levels"].push_back(levelRecord(mesh, level, bytes.levels[level], cost.levels[level]));
    return record;
}

} // namespace

Result<StreamingCostSettings> costPreset(const std::string& name)
{
    if (name == "seed")
        return seedCost();
    if (name == "viewer")
        return viewerCost();
    if (name == "honest")
        return honestCost();
    return Error{ErrorCode::InvalidSetting, "'" + name + "' is no preset; there are seed, viewer and honest"};
}

Result<Json> costRecord(const Ogre::Mesh& mesh, const std::filesystem::path& file, const CostSettings& settings,
                        Progress& progress)
{
    const Result<MeshBytes> bytes = levelBytes(file);
    if (!bytes)
        return bytes.error();
    if (bytes.value().levels.size() != mesh.getNumLodLevels())
        return withFile({ErrorCode::BadFile, "its levels lie where they cannot be told from the rest"}, file);
    const Result<double> radius = radiusOf(mesh, settings);
    if (!radius)
        return withFile(radius.error(), file);
    const Result<std::vector<double>> distances = distancesOf(mesh, radius.value(), settings);
    if (!distances)
        return withFile(distances.error(), file);
    std::vector<CostedLevel> levels;
    for (const LevelBytes& level : bytes.value().levels)
        levels.push_back(costedLevel(level, settings));
    const Result<StreamingCost> cost = streamingCost(levels, distances.value(), settings.formula);
    if (!cost)
        return withFile(cost.error(), file);
    Json record = wholeRecord(mesh, bytes.value(), cost.value(), radius.value(), settings);
    if (settings.mostPixels) {
        const Result<Json> cheapest = cheapestLevels(mesh, bytes.value().levels.front().bytes, settings, progress);
        if (!cheapest)
            return withFile(cheapest.error(), file);
        record["optimised"] = cheapest.value();
    }
    return record;
}

} // namespace lodsmith::cli
