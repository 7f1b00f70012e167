#include "Generation.h"

#include "OgreSession.h"
#include "PeakMemory.h"

#include <lodsmith/analysis/MeshStatistics.h>
#include <lodsmith/ogre/MeshReader.h>
#include <lodsmith/ogre/MeshWriter.h>
#include <lodsmith/ogre/ProgressiveMeshGenerator.h>

#include <OgreSubMesh.h>

#include <algorithm>
#include <chrono>
#include <memory>

namespace fs = std::filesystem;

namespace lodsmith::cli {

namespace {

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

/// Vertices and triangles of a hand-made level, which the generator does not look into.
struct ManualCounts {
    std::uint32_t vertices = 0;
    std::uint32_t triangles = 0;
};

std::string manualName(const LevelSpec& level)
{
    return fs::path(level.meshFile).filename().string();
}

Result<LodConfig> makeConfig(const GenerateSettings& settings, const Ogre::MeshPtr& mesh)
{
    LodConfig config;
    if (settings.levels.empty()) {
        if (!(mesh->getBoundingSphereRadius() > 0.0f))
            return Error{ErrorCode::InvalidGeometry,
                         "has no bounding radius, which the automatic levels follow; use --levels"};
        config = automaticLodConfig(mesh);
    }
    config.mesh = mesh;
    if (!settings.levels.empty())
        config.strategy = settings.strategy;
    for (const LevelSpec& level : settings.levels)
        config.levels.push_back({level.value, level.target, level.isManual() ? manualName(level) : ""});
    if (settings.metric)
        config.options.metric = *settings.metric;
    config.options.weights = settings.weights;
    config.options.lockBorders = settings.lockBorders;
    config.options.lockSeams = settings.lockSeams;
    config.shareIndexBuffers = settings.shareBuffers;
    return config;
}

Result<std::vector<ManualCounts>> loadManualLevels(OgreSession& session, const GenerateSettings& settings,
                                                   const Ogre::Mesh& mesh)
{
    std::vector<ManualCounts> counts;
    for (const LevelSpec& level : settings.levels) {
        counts.emplace_back();
        if (!level.isManual())
            continue;
        const Result<Ogre::MeshPtr> manual = session.loadLevelOf(mesh, level.meshFile, manualName(level));
        if (!manual)
            return manual.error();
        const Result<MeshData> data = MeshReader::read(*manual.value());
        if (!data)
            return data.error();
        const Result<MeshStatistics> statistics = meshStatistics(data.value().view());
        if (!statistics)
            return statistics.error();
        counts.back() = {statistics.value().vertices, statistics.value().triangles};
    }
    return counts;
}

Result<LodReport> generateRepeatedly(const LodConfig& config, unsigned repeat, Progress& progress, Timings& timings)
{
    Result<LodReport> report = Error{};
    for (unsigned run = 0; run < repeat; ++run) {
        MeshWriter::removeLevels(*config.mesh);
        // Only the first run starts from a heap without leftovers.
        const auto memory = run == 0 ? std::make_unique<PeakMemory>() : nullptr;
        const Stopwatch stopwatch;
        report = ProgressiveMeshGenerator().generateLodLevels(config, &progress);
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
                {"bytes", levelBytes(mesh, 0)}};
}

Json levelRecord(const LodLevelReport& level, const std::string& manual, const ManualCounts& counts, std::size_t bytes)
{
    if (level.manual)
        return Json{{"value", level.value},
                    {"vertices", counts.vertices},
                    {"triangles", counts.triangles},
                    {"deviation", nullptr},
                    {"skipped", false},
                    {"stop", nullptr},
                    {"manual", manual},
                    {"bytes", 0}};
    return Json{{"value", level.value},
                {"vertices", level.vertices},
                {"triangles", level.triangles},
                {"deviation", level.deviation},
                {"skipped", level.skipped},
                {"stop", toString(level.stop)},
                {"manual", nullptr},
                {"bytes", bytes}};
}

Json levelRecords(const LodConfig& config, const LodReport& report, const std::vector<ManualCounts>& manual)
{
    Json levels = Json::array({levelZeroRecord(report, *config.mesh)});
    std::size_t stored = 0;
    for (std::size_t i = 0; i < report.levels.size(); ++i) {
        const LodLevelReport& level = report.levels[i];
        stored += level.skipped ? 0 : 1;
        const std::size_t bytes = level.skipped || level.manual ? 0 : levelBytes(*config.mesh, stored);
        levels.push_back(
            levelRecord(level, config.levels[i].manualMeshName, level.manual ? manual[i] : ManualCounts(), bytes));
    }
    return levels;
}

Json recordOf(const LodConfig& config, const LodReport& report, const std::vector<ManualCounts>& manual,
              const Timings& timings)
{
    Json record;
    record["vertices"] = report.vertices;
    record["buffer_vertices"] = report.bufferVertices;
    record["triangles"] = report.triangles;
    record["radius"] = report.radius;
    record["strategy"] = config.strategy;
    record["metric"] = config.options.metric == Metric::Quadric ? "quadric" : "curvature";
    record["levels"] = levelRecords(config, report, manual);
    record["cleaned"] = Json{{"degenerate_triangles", report.cleaned.degenerateTriangles},
                             {"repeated_triangles", report.cleaned.repeatedTriangles},
                             {"unreferenced_vertices", report.cleaned.unreferencedVertices}};
    record["notes"] = report.notes;
    record["generate_ms"] = median(timings.generate);
    record["generate_min_ms"] = *std::min_element(timings.generate.begin(), timings.generate.end());
    record["order_ms"] = median(timings.order);
    record["peak_kb"] = timings.peakKb ? Json(*timings.peakKb) : Json(nullptr);
    return record;
}

Result<Done> writeResult(const GenerateSettings& settings, const PlannedFile& file, const Ogre::Mesh& mesh,
                         std::vector<std::string>& notes)
{
    std::vector<Companion> companions = findSkeleton(mesh, file.input, notes);
    for (const LevelSpec& level : settings.levels)
        if (level.isManual())
            companions.push_back({level.meshFile, manualName(level)});
    const Result<std::string> bytes = meshBytes(mesh, settings.write.format);
    if (!bytes)
        return bytes.error();
    return writeMeshFiles(file.output, bytes.value(), companions, settings.write.existing);
}

} // namespace

Result<Json> generateFile(const GenerateSettings& settings, const PlannedFile& file, Progress& progress)
{
    OgreSession session;
    const Stopwatch reading;
    const Result<Ogre::MeshPtr> mesh = session.load(file.input);
    const double readMs = reading.milliseconds();
    if (!mesh)
        return mesh.error();
    const Result<std::vector<ManualCounts>> manual = loadManualLevels(session, settings, *mesh.value());
    if (!manual)
        return manual.error();
    const Result<LodConfig> config = makeConfig(settings, mesh.value());
    if (!config)
        return config.error();
    Timings timings;
    Result<LodReport> report = generateRepeatedly(config.value(), settings.repeat, progress, timings);
    if (!report)
        return report.error();

    const Stopwatch writing;
    const Result<Done> written = writeResult(settings, file, *mesh.value(), report.value().notes);
    if (!written)
        return written.error();
    Json record = recordOf(config.value(), report.value(), manual.value(), timings);
    record["read_ms"] = readMs;
    record["write_ms"] = writing.milliseconds();
    return record;
}

Json failedRecord(const PlannedFile& file, const Error& error)
{
    Json record{{"input", file.input.string()},
                {"output", file.output.empty() ? Json(nullptr) : Json(file.output.string())}};
    for (const char* member : {"vertices", "buffer_vertices", "triangles", "radius"})
        record[member] = nullptr;
    record["levels"] = Json::array();
    for (const char* member : {"read_ms", "generate_ms", "generate_min_ms", "order_ms", "write_ms", "peak_kb"})
        record[member] = nullptr;
    setError(record, error);
    return record;
}

} // namespace lodsmith::cli
