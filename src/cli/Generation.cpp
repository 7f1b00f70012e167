#include "Generation.h"

#include "../loddef/LoddefWords.h"
#include "MeshPlan.h"
#include "PeakMemory.h"
#include "SeparateFoliage.h"

#include <lodsmith/cache/LodCache.h>
#include <lodsmith/loddef/LoddefFileName.h>
#include <lodsmith/ogre/MeshWriter.h>
#include <lodsmith/ogre/ProgressiveMeshGenerator.h>

#include <OgreSubMesh.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <utility>

namespace fs = std::filesystem;

namespace lodsmith::cli {

namespace {

constexpr std::uint64_t kCacheBytes = std::uint64_t(1) << 30;

class Stopwatch {
public:
    double milliseconds() const
    {
        return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - mStart).count();
    }

private:
    std::chrono::steady_clock::time_point mStart = std::chrono::steady_clock::now();
};

/// What was measured over all repeats.
struct Timings {
    std::vector<double> generate;
    std::vector<double> order;
    std::optional<std::int64_t> peakKb;
};

double median(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2.0;
}

Result<LodReport> generateRepeatedly(const LodConfig& config, const GenerateSettings& settings, Progress& progress,
                                     Timings& timings)
{
    ProgressiveMeshGenerator generator(
        settings.cache.empty() ? nullptr : std::make_shared<LodCache>(settings.cache, kCacheBytes));
    Result<LodReport> report = Error{};
    for (unsigned run = 0; run < settings.repeat; ++run) {
        MeshWriter::removeLevels(*config.mesh);
        // Only the first run starts from a heap without leftovers.
        const auto memory = run == 0 ? std::make_unique<PeakMemory>() : nullptr;
        const Stopwatch stopwatch;
        report = generator.generateLodLevels(config, &progress);
        timings.generate.push_back(stopwatch.milliseconds());
        if (!report)
            return report;
        timings.order.push_back(report.value().orderSeconds * 1e3);
        if (memory)
            timings.peakKb = memory->growthKb();
    }
    return report;
}

std::size_t indexBytes(const Ogre::IndexData* data)
{
    return data && data->indexBuffer ? data->indexCount * data->indexBuffer->getIndexSize() : 0;
}

std::size_t levelBytes(const Ogre::Mesh& mesh, std::size_t level)
{
    std::size_t bytes = 0;
    for (const Ogre::SubMesh* subMesh : mesh.getSubMeshes())
        bytes += indexBytes(level == 0 ? subMesh->indexData : subMesh->mLodFaceList[level - 1]);
    return bytes;
}

Json levelZeroRecord(const LodReport& report, const Ogre::Mesh& mesh)
{
    return Json{{"value", nullptr},
                {"vertices", report.vertices},
                {"triangles", report.triangles},
                {"deviation", 0.0},
                {"skipped", false},
                {"stop", nullptr},
                {"manual", nullptr},
                {"separate", nullptr},
                {"coverage", nullptr},
                {"bytes", levelBytes(mesh, 0)}};
}

Json handMadeRecord(Ogre::Real value, const std::string& name, const HandMadeLevel& level)
{
    return Json{{"value", value},
                {"vertices", level.vertices},
                {"triangles", level.triangles},
                {"deviation", nullptr},
                {"skipped", false},
                {"stop", nullptr},
                {"manual", name},
                {"separate", nullptr},
                {"coverage", nullptr},
                {"bytes", 0}};
}

Json levelRecord(const LodLevelReport& level, std::size_t bytes)
{
    return Json{{"value", level.value},
                {"vertices", level.vertices},
                {"triangles", level.triangles},
                {"deviation", level.deviation},
                {"skipped", level.skipped},
                {"stop", toString(level.stop)},
                {"manual", nullptr},
                {"separate", nullptr},
                {"coverage", nullptr},
                {"bytes", bytes}};
}

/// What is different about a level of foliage.
void addFoliage(Json& record, const FoliageRecord& level)
{
    record["coverage"] = level.kept;
    if (level.file.empty())
        return;
    record["vertices"] = level.vertices;
    record["triangles"] = level.triangles;
    record["deviation"] = nullptr;
    record["stop"] = nullptr;
    record["separate"] = level.file;
    record["bytes"] = level.bytes;
}

Json levelRecords(const MeshPlan& plan, const LodReport& report, const FoliageReport& foliage)
{
    const Ogre::Mesh& mesh = *plan.config.mesh;
    Json levels = Json::array({levelZeroRecord(report, mesh)});
    std::size_t stored = 0;
    for (std::size_t i = 0; i < report.levels.size(); ++i) {
        const LodLevelReport& level = report.levels[i];
        if (level.skipped && plan.config.mostLevels > 0)
            continue; // a candidate that was not chosen is nobody's business
        const std::string& handMade = plan.config.levels[i].manualMeshName;
        stored += level.skipped ? 0 : 1;
        if (level.manual)
            levels.push_back(handMadeRecord(level.value, handMade, plan.handMade.at(handMade)));
        else
            levels.push_back(levelRecord(level, level.skipped ? 0 : levelBytes(mesh, stored)));
        if (const auto found = foliage.levels.find(i); found != foliage.levels.end())
            addFoliage(levels.back(), found->second);
    }
    return levels;
}

Json recordOf(const MeshPlan& plan, const LodReport& report, const FoliageReport& foliage, const Timings& timings)
{
    Json record;
    record["vertices"] = report.vertices;
    record["buffer_vertices"] = report.bufferVertices;
    record["triangles"] = report.triangles;
    record["radius"] = report.radius;
    record["loddef"] = plan.loddef.empty() ? Json(nullptr) : Json(plan.loddef);
    record["strategy"] = plan.config.strategy;
    record["metric"] = wordFor(kMetrics, plan.config.options.metric);
    record["levels"] = levelRecords(plan, report, foliage);
    record["cleaned"] = Json{{"degenerate_triangles", report.cleaned.degenerateTriangles},
                             {"repeated_triangles", report.cleaned.repeatedTriangles},
                             {"unreferenced_vertices", report.cleaned.unreferencedVertices}};
    record["notes"] = report.notes;
    record["cached"] = report.fromCache;
    record["generate_ms"] = median(timings.generate);
    record["generate_min_ms"] = *std::min_element(timings.generate.begin(), timings.generate.end());
    record["order_ms"] = median(timings.order);
    record["peak_kb"] = timings.peakKb ? Json(*timings.peakKb) : Json(nullptr);
    return record;
}

std::vector<Companion> companionsOf(const MeshPlan& plan, const FoliageReport& foliage, const PlannedFile& file,
                                    std::vector<std::string>& notes)
{
    std::vector<Companion> companions = findSkeleton(*plan.config.mesh, file.input, notes);
    for (const auto& [name, level] : plan.handMade)
        companions.push_back({level.file, name, std::nullopt});
    companions.insert(companions.end(), foliage.files.begin(), foliage.files.end());
    return companions;
}

/// What decides where levels come from, and was not read through OGRE.
FileHashes definitionFiles(const DefinitionChoice& choice, const fs::path& input)
{
    const fs::path definition = choice.given.empty() ? loddefFileName(input.string()) : choice.given;
    if (definition.empty() || (choice.given.empty() && (!choice.beside || choice.waits)))
        return {};
    return {{definition, fileHash(definition)}};
}

/// What is looked for and may be missing: the skeleton, and beside the mesh what is taken from beside the definition.
void addSought(FileHashes& read, const MeshPlan& plan, const fs::path& input)
{
    const auto add = [&](const fs::path& name) {
        const fs::path path = input.parent_path() / name;
        read.emplace(path, fileHash(path));
    };
    if (const Ogre::Mesh& mesh = *plan.config.mesh; mesh.hasSkeleton())
        add(mesh.getSkeletonName());
    if (!plan.loddef.empty())
        for (const auto& [name, level] : plan.handMade)
            add(level.file.lexically_relative(fs::path(plan.loddef).parent_path()));
}

} // namespace

Result<GeneratedMesh> generateMesh(const GenerateSettings& settings, const PlannedFile& file, OgreSession& session,
                                   Progress& progress)
{
    // Hashed before they are read: what changes from now on is found changed.
    FileHashes read = definitionFiles(settings.definition, file.input);
    const Stopwatch reading;
    const Result<Ogre::MeshPtr> mesh = session.load(file.input);
    const double readMs = reading.milliseconds();
    if (!mesh)
        return mesh.error();
    const Result<MeshPlan> plan = planMesh(settings, file, session, mesh.value());
    if (!plan)
        return plan.error();
    Timings timings;
    Result<LodReport> report = generateRepeatedly(plan.value().config, settings, progress, timings);
    if (!report)
        return report.error();

    const Stopwatch treating;
    const Result<FoliageReport> foliage =
        treatFoliage(plan.value(), report.value(), file, settings.write.format, settings.separateMeshes, progress);
    const double foliageMs = treating.milliseconds();
    if (!foliage)
        return foliage.error();

    std::vector<std::string>& notes = report.value().notes;
    notes.insert(notes.begin(), plan.value().notes.begin(), plan.value().notes.end());
    notes.insert(notes.end(), foliage.value().notes.begin(), foliage.value().notes.end());
    if (const std::optional<Error>& trouble = report.value().notStored)
        notes.push_back("the levels could not be kept in the cache: " + describe(*trouble));
    std::vector<Companion> companions = companionsOf(plan.value(), foliage.value(), file, notes);
    Result<std::string> bytes = meshBytes(*mesh.value(), settings.write.format);
    if (!bytes)
        return bytes.error();
    Json record = recordOf(plan.value(), report.value(), foliage.value(), timings);
    record["read_ms"] = readMs;
    record["foliage_ms"] = foliageMs;
    read.insert(session.filesRead().begin(), session.filesRead().end());
    addSought(read, plan.value(), file.input);
    return GeneratedMesh{std::move(bytes).value(), std::move(companions), std::move(record), std::move(read)};
}

Json failedRecord(const PlannedFile& file, const Error& error)
{
    Json record{{"input", file.input.string()},
                {"output", file.output.empty() ? Json(nullptr) : Json(file.output.string())}};
    for (const char* member : {"vertices", "buffer_vertices", "triangles", "radius", "loddef"})
        record[member] = nullptr;
    record["levels"] = Json::array();
    for (const char* member : {"up_to_date", "cached", "read_ms", "generate_ms", "generate_min_ms", "order_ms",
                               "foliage_ms", "write_ms", "peak_kb"})
        record[member] = nullptr;
    setError(record, error);
    return record;
}

} // namespace lodsmith::cli
