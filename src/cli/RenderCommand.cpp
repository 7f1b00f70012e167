#include "CommandOptions.h"
#include "Commands.h"
#include "LevelSheet.h"
#include "Numbers.h"
#include "PictureSession.h"
#include "SeenRecord.h"
#include "Table.h"

#include <lodsmith/render/Png.h>

#include <OgreLodStrategy.h>

#include <cstdio>
#include <memory>

namespace lodsmith::cli {

namespace {

constexpr const char* kExamples = R"(Examples:
  lodsmith render tree-lod.mesh -o tree.png
  lodsmith render out/tree.mesh -o tree.png --materials models/tree
  xvfb-run -a lodsmith render tree.mesh -o tree.png --json
      without a screen; the automatic levels of a mesh that has none
)";

constexpr unsigned kLeastSize = 64, kMostSize = 2048;

struct RenderArguments {
    std::string mesh;
    std::string output;
    std::string materials;
    SeenOptions options;
    Existing existing = Existing::Keep;
    BatchOptions batch;
    bool json = false;
};

Result<Done> writeSheet(const RenderArguments& arguments, PictureSession& session, const std::vector<SeenLevel>& seen)
{
    const std::string name = std::filesystem::path(arguments.mesh).filename().string();
    const Result<Sheet> sheet =
        levelSheet(session.renderer(), seen, arguments.options, name, session.hasAutomaticLevels());
    if (!sheet)
        return sheet.error();
    const Result<Image> image = drawSheet(sheet.value());
    if (!image)
        return image.error();
    const Result<std::string> png = pngBytes(image.value());
    if (!png)
        return png.error();
    AtomicFile file(arguments.output, arguments.existing);
    if (auto prepared = file.prepare(png.value()); !prepared)
        return prepared;
    return file.commit();
}

Result<Json> renderFile(const RenderArguments& arguments, Progress& progress)
{
    if (auto possible = checkOutput(arguments.output, arguments.existing); !possible)
        return possible.error();
    const auto session = PictureSession::open(arguments.mesh, arguments.materials);
    if (!session)
        return session.error();
    LevelRenderer& renderer = session.value()->renderer();
    const auto seen = measureSeenLevels(renderer, arguments.options, &progress);
    if (!seen)
        return seen.error();
    if (auto written = writeSheet(arguments, *session.value(), seen.value()); !written)
        return written.error();
    return Json{{"automatic", session.value()->hasAutomaticLevels()},
                {"strategy", renderer.mesh()->getLodStrategy()->getName()},
                {"radius", renderer.mesh()->getBoundingSphereRadius()},
                {"levels", seenRecords(*renderer.mesh(), seen.value())},
                {"notes", renderer.notes()}};
}

std::string text(const Json& number)
{
    if (number.is_null())
        return "-";
    return number.is_number_integer() ? number.dump() : formatNumber(number.get<double>(), 4);
}

std::string report(const Json& record)
{
    Table table({"level", "triangles", "appears at px", "distance", "largest", "mean", "SSIM", "coverage",
                 "silhouette px", "popping mean", "popping SSIM"});
    for (const Json& level : record["levels"]) {
        const auto figure = [&level](const char* moment, const char* name) {
            return level[moment].is_null() ? "-" : text(level[moment]["lit"][name]);
        };
        table.add({text(level["level"]), text(level["triangles"]), text(level["switch_radius"]),
                   text(level["switch_distance"]), figure("at_switch", "largest"), figure("at_switch", "mean"),
                   figure("at_switch", "ssim"), figure("at_switch", "coverage"),
                   figure("at_switch", "silhouette_distance"), figure("popping", "mean"), figure("popping", "ssim")});
    }
    return table.text();
}

int runRender(const RenderArguments& arguments)
{
    if (std::filesystem::path(arguments.output).extension() != ".png")
        throw UsageError("--output: '" + arguments.output + "' is no name of a PNG file, which ends in .png");
    BatchJob job;
    job.file = arguments.mesh;
    job.inputBytes = fileBytes(arguments.mesh);
    const std::filesystem::path output = arguments.output;
    job.outputDirectories = {output.has_parent_path() ? output.parent_path() : std::filesystem::path(".")};
    job.work = [&arguments](Progress& progress) { return renderFile(arguments, progress); };
    return runBatch({job}, arguments.batch, [&](std::size_t, const Result<Json>& outcome) {
        Json record{{"input", arguments.mesh}, {"output", arguments.output}};
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

void addRenderCommand(CLI::App& app, int& exitCode)
{
    const auto arguments = std::make_shared<RenderArguments>();
    CLI::App* command =
        app.add_subcommand("render", "Draw the levels of a mesh side by side, and measure what is seen");
    command->add_option("MESH", arguments->mesh, "A mesh; without levels of detail, with its automatic ones")
        ->required();
    command->add_option("-o,--output", arguments->output, "Contact sheet to write, a PNG file")
        ->required()
        ->type_name("SHEET");
    command
        ->add_option("--materials", arguments->materials,
                     "Directory of the materials and their textures [that of MESH]")
        ->type_name("DIR");
    addCountOption(*command, "--size", arguments->options.closeUpSize, kLeastSize, kMostSize,
                   "Pixels that the mesh fills close up [512]")
        ->type_name("PIXELS");
    command->add_flag_callback(
        "--force", [arguments] { arguments->existing = Existing::Replace; }, "Overwrite a file that is there already");
    addTimeLimitOption(*command, arguments->batch);
    command->add_flag("--json", arguments->json, "Print one JSON object on standard output, and nothing else there");
    command->footer(kExamples);
    command->callback([arguments, &exitCode] { exitCode = runRender(*arguments); });
}

} // namespace lodsmith::cli
