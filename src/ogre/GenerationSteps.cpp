#include "GenerationSteps.h"

#include "LodPlan.h"
#include "VertexCacheOrder.h"

#include <lodsmith/analysis/LevelChoice.h>
#include <lodsmith/cache/SimplifyCached.h>
#include <lodsmith/ogre/MeshWriter.h>

#include <OgreSubMesh.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <sstream>
#include <utility>

namespace lodsmith {

namespace {

std::vector<LevelTarget> targetsOf(const LodConfig& config)
{
    std::vector<LevelTarget> targets;
    for (const LodLevel& level : config.levels)
        if (!level.isManual())
            targets.push_back(level.target);
    return targets;
}

/// The core numbers the submeshes of its view; people count those of the mesh.
Error inTermsOfMesh(Error error, const MeshData& data)
{
    if (error.subMesh >= 0) {
        const auto& views = data.subMeshOf();
        error.subMesh = static_cast<int>(std::find(views.begin(), views.end(), error.subMesh) - views.begin());
    }
    return error;
}

/// From which sizes on screen on levels may be shown, up to a factor: pixels are an area, and what is farther is smaller.
std::vector<double> sizesOf(const LodConfig& config)
{
    const bool rising = config.levels.size() > 1 && config.levels[1].value > config.levels[0].value;
    std::vector<double> sizes;
    for (const LodLevel& level : config.levels)
        sizes.push_back(rising ? 1.0 / level.value : std::sqrt(level.value));
    return sizes;
}

/// Marks the levels that are not worth storing as skipped.
void leaveOut(LodChain& chain, const std::vector<double>& sizes, unsigned most)
{
    std::vector<LevelCandidate> candidates;
    std::vector<LodChainLevel*> levels;
    for (std::size_t i = 0; i < chain.levels.size(); ++i)
        if (LodChainLevel& level = chain.levels[i]; !level.skipped) {
            candidates.push_back({sizes[i], level.triangles});
            levels.push_back(&level);
            level.skipped = true;
        }
    for (const std::size_t i : chooseLevels(chain.triangles, candidates, most))
        levels[i]->skipped = false;
    for (LodChainLevel* level : levels)
        if (level->skipped)
            level->indices = {};
}

/// What computeLods() does to a chain, for the key of the cache: what would give other levels has another name.
std::string nameOfFinish(const PreparedLods& prepared)
{
    std::ostringstream name;
    name << vertexCacheOrderName();
    if (prepared.mostLevels > 0) {
        name << "; at most " << prepared.mostLevels << " worth " << kWorthOfLevel << " at" << std::hexfloat;
        for (const double size : prepared.sizes)
            name << ' ' << size;
    }
    return name.str();
}

double secondsToOrder(LodChain& chain)
{
    const auto start = std::chrono::steady_clock::now();
    orderForVertexCache(chain);
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// The order is kept in the cache too: it takes longer than all the rest of a start from there.
Result<CachedChain> makeOrFind(PreparedLods& prepared, Progress* progress, const ChainFinish& finish)
{
    const auto letGo = [&] { prepared.data.releaseArrays(); };
    const MeshView& view = prepared.data.view();
    if (prepared.cache && !prepared.targets.empty())
        return simplifyCached(*prepared.cache, view, prepared.targets, prepared.options, progress, letGo, finish);
    Result<LodChain> chain = simplify(view, prepared.targets, prepared.options, progress, letGo);
    if (!chain)
        return chain.error();
    finish.apply(chain.value());
    return CachedChain{std::move(chain).value(), false, std::nullopt};
}

std::vector<LodLevelReport> reportLevels(const LodConfig& config, const LodChain& chain)
{
    std::vector<LodLevelReport> reports;
    auto next = chain.levels.begin();
    for (const LodLevel& level : config.levels) {
        LodLevelReport report;
        report.value = level.value;
        report.manual = level.isManual();
        if (!report.manual) {
            report.vertices = next->vertices;
            report.triangles = next->triangles;
            report.deviation = next->deviation;
            report.skipped = next->skipped;
            report.stop = next->stop;
            ++next;
        }
        reports.push_back(report);
    }
    return reports;
}

/// What writing does to level 0, said before it is done.
std::vector<std::string> notesOfWriting(const LodConfig& config, const MeshData& data, const LodChain& chain)
{
    std::vector<std::string> notes;
    const bool anyStored = std::any_of(chain.levels.begin(), chain.levels.end(),
                                       [](const LodChainLevel& level) { return !level.skipped; });
    for (std::size_t i = 0; anyStored && i < data.subMeshOf().size(); ++i)
        if (data.subMeshOf()[i] >= 0
            && config.mesh->getSubMesh(i)->operationType != Ogre::RenderOperation::OT_TRIANGLE_LIST)
            notes.push_back("submesh " + std::to_string(i)
                            + ": level 0 became a triangle list too, since OGRE draws all levels of a submesh alike");
    if (config.mesh->isEdgeListBuilt())
        notes.emplace_back("the edge lists were freed, OGRE builds them again on demand");
    return notes;
}

LodReport makeReport(const LodConfig& config, const MeshData& data, const LodChain& chain)
{
    LodReport report;
    report.vertices = chain.vertices;
    report.bufferVertices = chain.bufferVertices;
    report.triangles = chain.triangles;
    report.radius = chain.radius;
    report.cleaned = chain.cleaned;
    report.notes = data.notes();
    const std::vector<std::string> more = notesOfWriting(config, data, chain);
    report.notes.insert(report.notes.end(), more.begin(), more.end());
    report.levels = reportLevels(config, chain);
    return report;
}

} // namespace

Result<LodConfig> checkedAutomaticConfig(const Ogre::MeshPtr& mesh, const AutomaticLods& automatic)
{
    if (const std::string trouble = troubleWith(automatic); !trouble.empty())
        return Error{ErrorCode::InvalidSetting, trouble, mesh->getName()};
    const Ogre::Real radius = mesh->getBoundingSphereRadius();
    if (!std::isfinite(radius) || !(radius > 0))
        return Error{ErrorCode::InvalidGeometry, "the mesh has no bounding radius to derive levels from",
                     mesh->getName()};
    return automaticLodConfig(mesh, automatic);
}

Result<PreparedLods> prepareLods(const LodConfig& config, std::shared_ptr<LodCache> cache)
{
    // Settings are checked first: nobody should wait for a long simplification to learn of a typing error.
    const Result<LodPlan> plan = planLods(config);
    if (!plan)
        return plan.error();
    Result<MeshData> data = MeshReader::read(*config.mesh, config.subMeshImportance);
    if (!data)
        return data.error();
    return PreparedLods{std::move(data).value(), targetsOf(config), config.options,
                        std::move(cache),        config.mostLevels, sizesOf(config)};
}

Result<ComputedLods> computeLods(PreparedLods& prepared, Progress* progress)
{
    double orderSeconds = 0.0;
    const ChainFinish finish{nameOfFinish(prepared), [&](LodChain& chain) {
                                 if (prepared.mostLevels > 0)
                                     leaveOut(chain, prepared.sizes, prepared.mostLevels);
                                 orderSeconds = secondsToOrder(chain);
                             }};
    Result<CachedChain> made = makeOrFind(prepared, progress, finish);
    if (!made)
        return inTermsOfMesh(made.error(), prepared.data);
    CachedChain& chain = made.value();
    return ComputedLods{std::move(chain.chain), chain.found, std::move(chain.notStored), orderSeconds};
}

Result<LodReport> finishLods(const LodConfig& config, const PreparedLods& prepared, const ComputedLods& computed)
{
    LodReport report = makeReport(config, prepared.data, computed.chain);
    report.orderSeconds = computed.orderSeconds;
    report.fromCache = computed.fromCache;
    report.notStored = computed.notStored;
    const Result<Done> written = MeshWriter::write(config, prepared.data, computed.chain);
    if (!written)
        return written.error();
    return report;
}

} // namespace lodsmith
