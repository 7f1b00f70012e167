#include "CheapestLevels.h"

#include "Numbers.h"

#include <lodsmith/analysis/CheapestChain.h>
#include <lodsmith/core/Simplify.h>
#include <lodsmith/ogre/MeshReader.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace lodsmith::cli {

namespace {

constexpr unsigned kCandidates = 48;

// Of mesh format 1.100: a level's chunk header and value; for each submesh count, start and buffer; for each buffer
// width and size.
constexpr std::uint64_t kBytesOfLevel = 6 + 4;
constexpr std::uint64_t kBytesOfReference = 4 + 4 + 4;
constexpr std::uint64_t kBytesOfBuffer = 1 + 4;
constexpr std::uint64_t kIndicesOfLeastList = 3;

/// Falling by the same factor each, from below the mesh's own count to 1.
std::vector<LevelTarget> triangleTargets(double triangles)
{
    std::vector<LevelTarget> targets;
    for (unsigned i = 1; i <= kCandidates; ++i) {
        const double count = std::floor(std::pow(triangles, 1.0 - static_cast<double>(i) / kCandidates));
        if (count < triangles && (targets.empty() || count < targets.back().amount))
            targets.push_back({LevelTarget::Kind::Triangles, count});
    }
    return targets;
}

double trianglesOf(const MeshView& view)
{
    double triangles = 0.0;
    for (const SubMeshView& subMesh : view.subMeshes)
        triangles += std::floor(subMesh.indexCount / 3.0);
    return triangles;
}

/// What a level would take in a file. An empty list is written as one triangle; a submesh that is left alone has its
/// copy once in the first level, whichever that is, and afterwards refers to it.
std::uint64_t storedBytes(const LodChainLevel& level, const MeshData& data)
{
    std::uint64_t bytes = kBytesOfLevel;
    for (const int view : data.subMeshOf()) {
        bytes += kBytesOfReference;
        if (view < 0)
            continue;
        const auto subMesh = static_cast<std::size_t>(view);
        const std::uint64_t width = static_cast<std::uint64_t>(data.view().subMeshes[subMesh].indexBytes);
        bytes += kBytesOfBuffer + width * std::max<std::uint64_t>(level.indices[subMesh].size(), kIndicesOfLeastList);
    }
    return bytes;
}

/// Level 0 and all that can be stored.
struct Candidates {
    std::vector<const LodChainLevel*> levels{nullptr};
    std::vector<CandidateLevel> candidates;
};

Candidates candidatesOf(const LodChain& chain, const MeshData& data, std::uint64_t levelZeroBytes,
                        const CostSettings& settings)
{
    Candidates result;
    result.candidates.push_back({static_cast<double>(levelZeroBytes), 0.0});
    for (const LodChainLevel& level : chain.levels)
        if (!level.skipped) {
            result.levels.push_back(&level);
            result.candidates.push_back(
                {static_cast<double>(storedBytes(level, data)), level.deviation * settings.metresPerUnit});
        }
    return result;
}

Json levelRecord(const Ogre::Mesh& mesh, const LodChainLevel& level, double bytes, const LevelCost& cost,
                 const CostSettings& settings)
{
    return Json{{"value", pixelsAt(mesh, cost.distance / settings.metresPerUnit, settings.view)},
                {"distance", cost.distance},
                {"triangles", level.triangles},
                {"deviation", level.deviation},
                {"bytes", bytes},
                {"share", cost.share},
                {"cost", cost.cost}};
}

/// For `lodsmith generate --strategy pixelcount --levels`.
std::string levelsOption(const Json& levels)
{
    std::string option;
    for (const Json& level : levels)
        option += (option.empty() ? "" : ",") + formatNumber(level["value"].get<double>(), 6)
                  + ":triangles:" + std::to_string(level["triangles"].get<std::uint64_t>());
    return option;
}

Json chainRecord(const Ogre::Mesh& mesh, const Candidates& among, const CheapestChain& chain,
                 const CostSettings& settings)
{
    Json record{{"pixels", *settings.mostPixels},
                {"cost", chain.cost.cost},
                {"bytes", chain.cost.bytes},
                {"levels", Json::array()},
                {"option", nullptr}};
    for (std::size_t i = 1; i < chain.candidates.size(); ++i) {
        const std::size_t chosen = chain.candidates[i];
        record["levels"].push_back(
            levelRecord(mesh, *among.levels[chosen], among.candidates[chosen].bytes, chain.cost.levels[i], settings));
    }
    if (!record["levels"].empty())
        record["option"] = levelsOption(record["levels"]);
    return record;
}

} // namespace

Result<Json> cheapestLevels(const Ogre::Mesh& mesh, std::uint64_t levelZeroBytes, const CostSettings& settings,
                            Progress& progress)
{
    const Result<MeshData> data = MeshReader::read(mesh);
    if (!data)
        return data.error();
    const MeshView& view = data.value().view();
    const Result<LodChain> chain = simplify(view, triangleTargets(trianglesOf(view)), {}, &progress);
    if (!chain)
        return chain.error();
    const Candidates among = candidatesOf(chain.value(), data.value(), levelZeroBytes, settings);
    ErrorBudget budget;
    budget.pixels = *settings.mostPixels;
    budget.viewportHeight = settings.view.height;
    budget.fieldOfView = settings.view.fieldOfView;
    const Result<CheapestChain> cheapest = cheapestChain(among.candidates, budget, settings.formula);
    if (!cheapest)
        return cheapest.error();
    return chainRecord(mesh, among, cheapest.value(), settings);
}

} // namespace lodsmith::cli
