#include "CommandOptions.h"
#include "Commands.h"
#include "CostConstants.h"
#include "CostRecord.h"
#include "CostReport.h"
#include "Numbers.h"
#include "OgreSession.h"
#include "OutputPlan.h"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>
#include <utility>

namespace lodsmith::cli {

namespace {

constexpr const char* kExamples = R"(Examples:
  lodsmith cost tree-lod.mesh
      what each level takes, how much it counts, and which to shrink first
  lodsmith cost models --preset honest --json > cost.jsonl
      every .mesh below models/, duplicates charged, one JSON object a mesh
  lodsmith cost tree.mesh --optimise 1
      the cheapest levels that are never off by more than a pixel when they appear
  lodsmith cost tree-lod.mesh --metres 0.01 --constants largest_area=31416
      a mesh in centimetres, seen from within 100 m
)";

constexpr double kDegree = 3.14159265358979323846 / 180.0;

struct CostArguments {
    std::vector<std::string> inputs;
    CostSettings settings;
    std::string constants;
    BatchOptions batch;
    bool json = false;
};

Result<Json> costOfFile(const PlannedFile& file, const CostSettings& settings, Progress& progress)
{
    if (file.error)
        return *file.error;
    OgreSession session;
    const Result<Ogre::MeshPtr> mesh = session.load(file.input);
    if (!mesh)
        return mesh.error();
    return costRecord(*mesh.value(), file.input, settings, progress);
}

void resolve(CostArguments& arguments)
{
    CostSettings& settings = arguments.settings;
    if (!arguments.constants.empty())
        if (const Result<Done> set = setCostConstants(arguments.constants, settings.formula); !set)
            throw UsageError("--constants: " + set.error().message);
    if (settings.mostPixels && settings.zlibSizes)
        throw UsageError("--optimise reckons with bytes as stored: it does not go with --sizes zlib");
}

int runCost(CostArguments& arguments)
{
    resolve(arguments);
    const std::vector<PlannedFile> plan = planInputs(arguments.inputs);
    std::vector<BatchJob> jobs;
    for (const PlannedFile& file : plan) {
        BatchJob job;
        job.file = file.input.string();
        job.inputBytes = fileBytes(file.input);
        job.work = [&file, &arguments](Progress& progress) { return costOfFile(file, arguments.settings, progress); };
        jobs.push_back(std::move(job));
    }
    return runBatch(jobs, arguments.batch, [&](std::size_t job, const Result<Json>& outcome) {
        Json record{{"input", plan[job].input.string()}};
        if (outcome) {
            record.update(outcome.value());
            record["error"] = nullptr;
        } else {
            setError(record, outcome.error());
        }
        if (arguments.json)
            std::printf("%s\n", toLine(record).c_str());
        else if (outcome)
            std::printf("%s\n", costReport(record).c_str());
    });
}

Result<View> parseViewport(const std::string& text, View view)
{
    const std::size_t cross = text.find('x');
    const std::optional<std::uint64_t> width = parseCount(text.substr(0, cross));
    const std::optional<std::uint64_t> height =
        cross == std::string::npos ? std::nullopt : parseCount(text.substr(cross + 1));
    if (!width || !height || *width < 1 || *width > 100000 || *height < 1 || *height > 100000)
        return Error{ErrorCode::InvalidSetting, "'" + text + "' is no size in pixels, such as 1920x1080"};
    view.width = static_cast<double>(*width);
    view.height = static_cast<double>(*height);
    return view;
}

Result<std::vector<double>> parsePlaces(const std::string& text)
{
    std::vector<double> places;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        const std::optional<double> place = parseNumber(text.substr(begin, end - begin));
        if (!place || *place < 0.0)
            return Error{ErrorCode::InvalidSetting,
                         "'" + text.substr(begin, end - begin) + "' is no distance of at least 0"};
        places.push_back(*place);
        begin = end + 1;
    }
    return places;
}

void addFormulaOptions(CLI::App& command, CostArguments& arguments)
{
    CostSettings& settings = arguments.settings;
    addParsedOption(command, "--preset", "The formula: seed, viewer or honest [seed]",
                    [&settings](const std::string& word) -> Result<Done> {
                        const Result<StreamingCostSettings> formula = costPreset(word);
                        if (!formula)
                            return formula.error();
                        settings.preset = word;
                        settings.formula = formula.value();
                        return Done{};
                    })
        ->type_name("PRESET");
    command
        .add_option("--constants", arguments.constants, "Other constants than the preset's, as docs/cli.md names them")
        ->type_name("NAME=VALUE,...");
    addParsedOption(command, "--sizes", "Charge levels for their bytes as stored, or behind zlib: raw or zlib [raw]",
                    [&settings](const std::string& word) -> Result<Done> {
                        if (word != "raw" && word != "zlib")
                            return Error{ErrorCode::InvalidSetting, "'" + word + "' is neither raw nor zlib"};
                        settings.zlibSizes = word == "zlib";
                        return Done{};
                    })
        ->type_name("SIZES");
    addNumberOption(command, "--metres", settings.metresPerUnit, 1e-6, 1e6, "Metres in a world unit of the meshes [1]")
        ->type_name("METRES");
}

void addDistanceOptions(CLI::App& command, CostSettings& settings)
{
    command.add_flag("--preset-distances", settings.presetDistances,
                     "Levels appear at the formula's ratios, not where the mesh's own strategy says");
    addParsedOption(command, "--viewport", "What pixel counts refer to [1920x1080]",
                    [&settings](const std::string& text) -> Result<Done> {
                        const Result<View> view = parseViewport(text, settings.view);
                        if (!view)
                            return view.error();
                        settings.view = view.value();
                        return Done{};
                    })
        ->type_name("WIDTHxHEIGHT");
    addParsedOption(command, "--fov", "Vertical field of view in degrees [45]",
                    [&settings](const std::string& text) -> Result<Done> {
                        const std::optional<double> degrees = parseNumber(text);
                        if (!degrees || *degrees < 1.0 || *degrees > 170.0)
                            return Error{ErrorCode::InvalidSetting, "'" + text + "' is no angle from 1 to 170"};
                        settings.view.fieldOfView = *degrees * kDegree;
                        return Done{};
                    })
        ->type_name("DEGREES");
    addParsedOption(command, "--at", "Say what is drawn at these distances, in metres",
                    [&settings](const std::string& text) -> Result<Done> {
                        const Result<std::vector<double>> places = parsePlaces(text);
                        if (!places)
                            return places.error();
                        settings.places = places.value();
                        return Done{};
                    })
        ->type_name("METRES,...");
    addParsedOption(command, "--optimise", "Look for the cheapest levels with at most so many pixels of error",
                    [&settings](const std::string& text) -> Result<Done> {
                        const std::optional<double> pixels = parseNumber(text);
                        if (!pixels || *pixels < 0.001 || *pixels > 1000.0)
                            return Error{ErrorCode::InvalidSetting, "'" + text + "' is no number from 0.001 to 1000"};
                        settings.mostPixels = *pixels;
                        return Done{};
                    })
        ->type_name("PIXELS");
}

} // namespace

void addCostCommand(CLI::App& app, int& exitCode)
{
    const auto arguments = std::make_shared<CostArguments>();
    CLI::App* command = app.add_subcommand("cost", "Say what levels of detail cost to send and to draw");
    command->add_option("MESH", arguments->inputs, "Meshes, or directories with meshes at any depth")->required();
    addFormulaOptions(*command, *arguments);
    addDistanceOptions(*command, arguments->settings);
    addCountOption(*command, "-j,--jobs", arguments->batch.workers, 1, 1024, "Work on N files at a time [1]")
        ->type_name("N");
    addTimeLimitOption(*command, arguments->batch);
    command->add_flag("--json", arguments->json,
                      "Print one JSON object a mesh on standard output, and nothing else there");
    command->footer(kExamples);
    command->callback([arguments, &exitCode] { exitCode = runCost(*arguments); });
}

} // namespace lodsmith::cli
