#include "CommandOptions.h"
#include "Commands.h"
#include "Numbers.h"
#include "OgreSession.h"
#include "Table.h"

#include <lodsmith/analysis/Deviation.h>
#include <lodsmith/analysis/MeshStatistics.h>
#include <lodsmith/ogre/LevelReader.h>
#include <lodsmith/ogre/MeshReader.h>

#include <cstdio>
#include <memory>

namespace lodsmith::cli {

namespace {

constexpr const char* kExamples = R"(Examples:
  lodsmith measure tree-lod.mesh
      every level against level 0
  lodsmith measure tree-other-tool.mesh --against tree.mesh --json
      level 0 and all others against another mesh
)";

struct MeasureArguments {
    std::string mesh;
    std::string original;
    DeviationOptions options;
    BatchOptions batch;
    bool json = false;
};

Error withFile(Error error, const std::string& file)
{
    error.file = file;
    return error;
}

Json figures(const DeviationFigures& figures)
{
    return Json{{"mean", figures.mean}, {"rms", figures.rms}, {"max", figures.maximum}};
}

Json levelRecord(std::size_t level, const Json& value, const MeshStatistics& statistics, const Deviation& deviation)
{
    return Json{{"level", level},
                {"value", value},
                {"vertices", statistics.vertices},
                {"triangles", statistics.triangles},
                {"surface", figures(deviation.surface)},
                {"normal", figures(deviation.normal)},
                {"uv", figures(deviation.uv)},
                {"flipped_triangles", deviation.flippedTriangles},
                {"new_border_edges", deviation.newBorderEdges},
                {"new_non_manifold_edges", deviation.newNonManifoldEdges},
                {"repeated_triangles", deviation.repeatedTriangles},
                {"degenerate_triangles", deviation.degenerateTriangles}};
}

Json poseRecords(const std::vector<PoseMoment>& poses)
{
    Json records = Json::array();
    for (const PoseMoment& pose : poses)
        records.push_back({{"name", pose.name}, {"seconds", pose.seconds}});
    return records;
}

Result<Json> measureLevel(const MeshView& original, const MeshView& simplified, std::size_t level, const Json& value,
                          const DeviationOptions& options)
{
    const Result<MeshStatistics> statistics = meshStatistics(simplified);
    if (!statistics)
        return statistics.error();
    const Result<Deviation> deviation = measureDeviation(original, simplified, options);
    if (!deviation)
        return deviation.error();
    return levelRecord(level, value, statistics.value(), deviation.value());
}

/// @param original null for level 0 of the mesh itself
Result<Json> measureMesh(const Ogre::Mesh& mesh, const MeshData* original, const DeviationOptions& options,
                         Progress& progress)
{
    const Result<std::shared_ptr<const MeshData>> levelZero =
        LevelReader::readLevelZero(mesh, original ? &original->poses() : nullptr);
    if (!levelZero)
        return levelZero.error();
    const MeshView& reference = original ? original->view() : levelZero.value()->view();
    const Result<MeshStatistics> statistics = meshStatistics(reference);
    if (!statistics)
        return statistics.error();
    Json record{{"radius", statistics.value().radius},
                {"poses", poseRecords(levelZero.value()->poses())},
                {"levels", Json::array()}};
    const unsigned levels = mesh.getNumLodLevels();
    for (unsigned level = 0; level < levels; ++level) {
        const Result<LevelData> data = LevelReader::read(mesh, levelZero.value(), level);
        if (!data)
            return data.error();
        const Json value = level == 0 ? Json() : Json(mesh.getLodLevel(static_cast<Ogre::ushort>(level)).userValue);
        const Result<Json> measured = measureLevel(reference, data.value().view(), level, value, options);
        if (!measured)
            return measured.error();
        record["levels"].push_back(measured.value());
        progress.report(static_cast<float>(level + 1u) / static_cast<float>(levels));
    }
    return record;
}

Result<Json> measureFile(const MeasureArguments& arguments, Progress& progress)
{
    OgreSession session;
    const Result<Ogre::MeshPtr> mesh = session.load(arguments.mesh);
    if (!mesh)
        return mesh.error();
    if (arguments.original.empty())
        return measureMesh(*mesh.value(), nullptr, arguments.options, progress);
    const Result<Ogre::MeshPtr> original = session.load(arguments.original);
    if (!original)
        return original.error();
    const Result<MeshData> data = MeshReader::read(*original.value());
    if (!data)
        return withFile(data.error(), arguments.original);
    return measureMesh(*mesh.value(), &data.value(), arguments.options, progress);
}

std::string text(const Json& number)
{
    return number.is_null() ? "-" : formatNumber(number.get<double>(), 4);
}

std::string share(const Json& number, const Json& whole)
{
    return whole.get<double>() > 0.0 ? formatNumber(100.0 * number.get<double>() / whole.get<double>(), 3) + " %" : "-";
}

std::string report(const Json& record)
{
    Table table({"level", "value", "triangles", "mean", "of radius", "rms", "max", "normal mean", "uv mean", "flipped",
                 "new borders", "new non-manifold"});
    for (const Json& level : record["levels"])
        table.add({text(level["level"]), text(level["value"]), text(level["triangles"]), text(level["surface"]["mean"]),
                   share(level["surface"]["mean"], record["radius"]), text(level["surface"]["rms"]),
                   text(level["surface"]["max"]), text(level["normal"]["mean"]), text(level["uv"]["mean"]),
                   text(level["flipped_triangles"]), text(level["new_border_edges"]),
                   text(level["new_non_manifold_edges"])});
    const std::size_t poses = record["poses"].size();
    const std::string counted = poses == 0 ? ""
                                           : "Mean, rms and max are over rest and " + std::to_string(poses)
                                                 + (poses == 1 ? " pose" : " poses") + ".\n";
    return table.text() + counted;
}

int runMeasure(const MeasureArguments& arguments)
{
    BatchJob job;
    job.file = arguments.mesh;
    job.inputBytes = fileBytes(arguments.mesh) + (arguments.original.empty() ? 0 : fileBytes(arguments.original));
    job.work = [&arguments](Progress& progress) { return measureFile(arguments, progress); };
    return runBatch({job}, arguments.batch, [&](std::size_t, const Result<Json>& outcome) {
        Json record{{"input", arguments.mesh},
                    {"against", arguments.original.empty() ? arguments.mesh : arguments.original}};
        if (outcome) {
            record.update(outcome.value());
            record["error"] = nullptr;
        } else {
            setError(record, outcome.error());
        }
        if (arguments.json)
            std::printf("%s\n", toLine(record).c_str());
        else if (outcome)
            std::printf("%s", report(record).c_str());
    });
}

} // namespace

void addMeasureCommand(CLI::App& app, int& exitCode)
{
    const auto arguments = std::make_shared<MeasureArguments>();
    CLI::App* command = app.add_subcommand("measure", "Measure how far levels of detail are from the original");
    command->add_option("MESH", arguments->mesh, "A mesh with levels of detail")->required();
    command->add_option("--against", arguments->original, "Measure against level 0 of this mesh [of MESH]")
        ->type_name("ORIGINAL");
    addCountOption(*command, "--samples", arguments->options.samples, 1, 100000000, "Points on each surface [100000]")
        ->type_name("N");
    addTimeLimitOption(*command, arguments->batch);
    command->add_flag("--json", arguments->json, "Print one JSON object on standard output, and nothing else there");
    command->footer(kExamples);
    command->callback([arguments, &exitCode] { exitCode = runMeasure(*arguments); });
}

} // namespace lodsmith::cli
