#include "../loddef/LoddefWords.h"
#include "BuildRecord.h"
#include "Commands.h"
#include "Generation.h"
#include "GenerationReport.h"
#include "MachineLimits.h"
#include "MeshBuild.h"
#include "Numbers.h"
#include "OutputDirectories.h"
#include "SeparateFoliage.h"
#include "Shard.h"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <set>

namespace fs = std::filesystem;

namespace lodsmith::cli {

namespace {

constexpr const char* kExamples =
    R"(A level is VALUE:METHOD:AMOUNT, or VALUE:mesh:FILE for a hand-made mesh. VALUE is a distance in world
units or a pixel count. METHOD and AMOUNT, always against the original mesh:
  proportional  share of the vertices removed, 0 to 1
  constant      number of vertices removed
  triangles     number of triangles kept
  deviation     bound on the deviation, in world units
  collapsecost  dearest collapse, in world units

A definition beside a mesh (tree.loddef beside tree.mesh) says what levels that mesh gets, unless options above do.

Examples:
  lodsmith generate tree.mesh -o tree-lod.mesh
      as tree.loddef says; without one automatic levels, which are off by at most a pixel
  lodsmith generate tree.mesh -o out/ --levels 20:proportional:0.5,60:proportional:0.75
      half of the vertices from distance 20 on, a quarter from 60
  lodsmith generate models -o out --json > report.jsonl
      every .mesh below models/, one JSON object a mesh
  lodsmith generate house.mesh -o out/ --levels 50:deviation:0.02,400:mesh:box.mesh
      as few triangles as 0.02 units of deviation allow, then a hand-made box
  lodsmith generate models -o out --loddef far.loddef
      all of them as far.loddef says
  lodsmith generate models -o out
      once more, or after an interruption: makes what is missing or has changed, and nothing else
  lodsmith generate models -o out --shard 3/8
      the third of eight parts of the work, for as many machines
)";

constexpr double kLargestWeight = 1e6;

/// Everything the command line of `generate` says.
struct GenerateArguments {
    std::vector<std::string> inputs;
    std::string output;
    std::optional<std::string> levels;
    std::string strategy;
    std::optional<std::string> loddef;
    bool noLoddef = false;
    GenerateSettings settings;
    BatchOptions batch;
    unsigned jobs = 0;      ///< meshes at a time; 0 for as many as fit the machine
    unsigned memoryMib = 0; ///< for all of them; 0 for what is free
    Shard shard;
    BuildRules rules;
    bool weighted = false; ///< one of the weights was given
    bool json = false;
};

Result<std::string> parseStrategy(const std::string& word)
{
    if (word == "distance" || word == "distance_sphere")
        return std::string("distance_sphere");
    if (word == "pixelcount" || word == "pixel_count")
        return std::string("pixel_count");
    if (word == "distance_box" || word == "screen_ratio_pixel_count")
        return word;
    return Error{ErrorCode::InvalidSetting,
                 "'" + word
                     + "' is no strategy; there are distance and pixelcount (and OGRE's own "
                       "distance_sphere, distance_box, pixel_count, screen_ratio_pixel_count)"};
}

Result<Metric> parseMetric(const std::string& word)
{
    if (const Metric* metric = meaningOf(kMetrics, word))
        return *metric;
    return Error{ErrorCode::InvalidSetting, "'" + word + "' is no metric; there are " + wordList(kMetrics)};
}

Result<float> parseWeight(const std::string& text)
{
    const std::optional<double> weight = parseNumber(text);
    if (!weight || *weight < 0.0 || *weight > kLargestWeight)
        return Error{ErrorCode::InvalidSetting, "'" + text + "' is no number from 0 to 1000000"};
    return static_cast<float>(*weight);
}

LevelOrder orderOf(const std::string& strategy)
{
    return strategy.find("pixel") == std::string::npos ? LevelOrder::Rising : LevelOrder::Falling;
}

/// Hand-made meshes end up beside the output under their own names, which therefore have to differ.
void checkManualLevels(const std::vector<LevelSpec>& levels, const std::vector<PlannedFile>& plan)
{
    std::set<fs::path> names;
    for (const LevelSpec& level : levels) {
        if (!level.isManual())
            continue;
        const fs::path name = fs::path(level.meshFile).filename();
        if (name.empty() || !names.insert(name).second)
            throw UsageError("--levels: '" + level.meshFile + "' needs a file name that no other level has");
        for (const PlannedFile& file : plan)
            if (file.output.filename() == name)
                throw UsageError("--levels: '" + level.meshFile + "' has the file name of the output '"
                                 + file.output.string() + "'");
    }
}

/// Levels that become meshes of their own must not meet other files of the run.
void checkSeparateNames(const std::vector<PlannedFile>& plan)
{
    std::set<fs::path> outputs;
    for (const PlannedFile& file : plan)
        outputs.insert((file.output.parent_path() / file.output.stem()).lexically_normal());
    const auto check = [&](const fs::path& file) {
        const std::string stem = stemOfSeparate(file);
        if (!stem.empty() && outputs.count((file.parent_path() / stem).lexically_normal()) > 0)
            throw UsageError("--separate-meshes: '" + file.string() + "' has the name of a level of '" + stem + "'");
    };
    for (const PlannedFile& file : plan) {
        check(file.input);
        check(file.output);
    }
}

bool statesLevels(const GenerateArguments& arguments)
{
    const GenerateSettings& settings = arguments.settings;
    return arguments.levels || !arguments.strategy.empty() || settings.metric || arguments.weighted
           || settings.lockBorders || settings.lockSeams;
}

void resolveDefinition(GenerateArguments& arguments)
{
    DefinitionChoice& choice = arguments.settings.definition;
    choice.beside = !arguments.noLoddef;
    choice.waits = choice.beside && statesLevels(arguments);
    if (!arguments.loddef)
        return;
    if (arguments.loddef->empty())
        throw UsageError("--loddef: the file has no name");
    if (arguments.noLoddef)
        throw UsageError("--loddef and --no-loddef exclude each other");
    if (statesLevels(arguments))
        throw UsageError(
            "--loddef says what levels there are: it goes with none of --levels, --strategy, --metric, the "
            "weights, --lock-borders and --lock-seams");
    choice.given = *arguments.loddef;
}

void checkWeights(const GenerateArguments& arguments)
{
    const bool isClassic = arguments.settings.automatic.method == AutomaticLods::Method::Classic;
    const Metric usual = isClassic ? Metric::Curvature : Metric::Quadric;
    if (arguments.weighted && arguments.settings.metric.value_or(usual) == Metric::Curvature)
        throw UsageError("attribute weights count under the quadric metric alone: add --metric quadric");
}

void resolveLevels(GenerateArguments& arguments)
{
    if (!arguments.levels) {
        if (!arguments.strategy.empty())
            throw UsageError("--strategy needs --levels: the automatic levels are pixel counts");
        return;
    }
    arguments.settings.strategy = arguments.strategy.empty() ? "distance_sphere" : arguments.strategy;
    Result<std::vector<LevelSpec>> levels = parseLevelSpecs(*arguments.levels, orderOf(arguments.settings.strategy));
    if (!levels)
        throw UsageError("--levels: " + levels.error().message);
    arguments.settings.levels = std::move(levels).value();
}

std::vector<PlannedFile> planFiles(const GenerateArguments& arguments)
{
    Result<std::vector<PlannedFile>> planned = planOutputs(arguments.inputs, arguments.output);
    if (!planned)
        throw UsageError(planned.error().message);
    checkManualLevels(arguments.settings.levels, planned.value());
    if (arguments.settings.separateMeshes)
        checkSeparateNames(planned.value());
    std::vector<PlannedFile> plan = withoutHandMade(std::move(planned).value(), arguments.settings.definition);
    const auto isElsewhere = [&](const PlannedFile& file) { return !arguments.shard.contains(file.name); };
    plan.erase(std::remove_if(plan.begin(), plan.end(), isElsewhere), plan.end());
    return plan;
}

/// What was given on the command line and decides what comes out; whatever is not known to change nothing counts.
Json decidingOptions(const CLI::App& command)
{
    const std::set<std::string> indifferent{"IN",     "--output",     "--force",  "--cache", "--repeat",
                                            "--jobs", "--time-limit", "--memory", "--shard", "--json"};
    Json given = Json::object();
    for (const CLI::Option* option : command.get_options())
        if (option->count() > 0 && indifferent.count(option->get_name()) == 0)
            given[option->get_name()] = option->results().back();
    return given;
}

BatchJob makeJob(const PlannedFile& file, const GenerateArguments& arguments, OgreSession& session)
{
    const GenerateSettings& settings = arguments.settings;
    BatchJob job;
    job.file = file.input.string();
    job.inputBytes = fileBytes(file.input);
    job.outputDirectories = {directoryOf(file.output), directoryOf(recordFile(file.output))};
    if (!settings.cache.empty())
        job.outputDirectories.push_back(settings.cache);
    // Times are wanted.
    if (settings.repeat == 1)
        job.known = [&file, &arguments] { return upToDate(file, arguments.rules); };
    job.work = [&file, &arguments, &session](Progress& progress) -> Result<Json> {
        if (file.error)
            return *file.error;
        return buildMesh(arguments.settings, arguments.rules, file, session, progress);
    };
    return job;
}

Json completeRecord(const PlannedFile& file, const Result<Json>& outcome)
{
    if (!outcome)
        return failedRecord(file, outcome.error());
    Json record{{"input", file.input.string()}, {"output", file.output.string()}};
    record.update(outcome.value());
    record["error"] = nullptr;
    return record;
}

void resolveLimits(GenerateArguments& arguments)
{
    constexpr std::uint64_t kMib = std::uint64_t(1) << 20;
    const bool measures = arguments.settings.repeat > 1;
    arguments.batch.workers = arguments.jobs > 0 ? arguments.jobs : measures ? 1 : usableProcessors();
    if (arguments.memoryMib > 0)
        arguments.batch.memoryBytes = kMib * arguments.memoryMib;
    else if (const auto available = availableMemory())
        arguments.batch.memoryBytes = std::max<std::uint64_t>(1, *available / 4 * 3); // 0 would be no bound
}

void resolve(GenerateArguments& arguments, const CLI::App& command)
{
    arguments.settings.saysAutomatic = command.count("--automatic") > 0 || command.count("--pixels") > 0;
    if (arguments.levels && arguments.settings.saysAutomatic)
        throw UsageError("--automatic and --pixels say what automatic levels are like: they do not go with --levels");
    resolveDefinition(arguments);
    checkWeights(arguments);
    if (!holdsLevels(arguments.settings.write.format.version))
        throw UsageError("--mesh-version: OGRE writes no levels of detail in mesh formats 1.0 and 1.4");
    resolveLevels(arguments);
    resolveLimits(arguments);
    arguments.rules = {decidingOptions(command), arguments.settings.write.overwriting.existing == Existing::Replace};
}

/// How many meshes of a run came to what.
struct Tally {
    std::size_t made = 0, upToDate = 0, failed = 0;

    void add(const Json& record)
    {
        ++(!record["error"].is_null() ? failed : record["up_to_date"].get<bool>() ? upToDate : made);
    }
    std::string text() const
    {
        return std::to_string(made) + " made, " + std::to_string(upToDate) + " up to date, " + std::to_string(failed)
               + " failed";
    }
};

int runGenerate(GenerateArguments& arguments, const CLI::App& command)
{
    resolve(arguments, command);
    const std::vector<PlannedFile> plan = planFiles(arguments);
    // Fewer files than may be worked on at a time: each gets its share of the processors.
    arguments.settings.threads =
        std::max(1u, arguments.batch.workers / std::max(1u, static_cast<unsigned>(plan.size())));
    const std::set<fs::path> directories = outputDirectories(plan);
    for (const fs::path& directory : directories)
        AtomicFile::removeAbandoned(directory);
    // Once for all children, which begin where it has come to.
    OgreSession session;
    std::vector<BatchJob> jobs;
    jobs.reserve(plan.size());
    for (const PlannedFile& file : plan)
        jobs.push_back(makeJob(file, arguments, session));
    Tally tally;
    int exitCode = runBatch(jobs, arguments.batch, [&](std::size_t job, const Result<Json>& outcome) {
        const Json record = completeRecord(plan[job], outcome);
        tally.add(record);
        if (arguments.json)
            std::printf("%s\n", toLine(record).c_str());
        else if (outcome)
            std::printf("%s\n", generationReport(record, arguments.settings.repeat).c_str());
    });
    if (const Result<Done> synced = tally.made > 0 ? syncFileSystems(directories) : Done{}; !synced) {
        printError(synced.error());
        exitCode = kExitFailed;
    }
    if (plan.size() > 1)
        std::fprintf(stderr, "%s\n", tally.text().c_str());
    return exitCode;
}

void addSimplifierOptions(CLI::App& command, GenerateArguments& arguments)
{
    addParsedOption(command, "--metric",
                    "What a collapse costs: quadric or curvature [quadric; curvature with --automatic classic]",
                    [&arguments](const std::string& word) -> Result<Done> {
                        const Result<Metric> metric = parseMetric(word);
                        if (!metric)
                            return metric.error();
                        arguments.settings.metric = metric.value();
                        return Done{};
                    })
        ->type_name("METRIC");
    const auto addWeight = [&](const std::string& name, float& weight, const std::string& help) {
        addParsedOption(command, name, help, [&arguments, &weight](const std::string& text) -> Result<Done> {
            const Result<float> parsed = parseWeight(text);
            if (!parsed)
                return parsed.error();
            weight = parsed.value();
            arguments.weighted = true;
            return Done{};
        })->type_name("WEIGHT");
    };
    AttributeWeights& weights = arguments.settings.weights;
    addWeight("--normal-weight", weights.normal, "How much normals count beside shape; 0 for not at all");
    addWeight("--uv-weight", weights.uv, "How much texture coordinates count");
    addWeight("--colour-weight", weights.colour, "How much vertex colours count");
    addWeight("--bone-weight", weights.bone, "How much bone weights count");
    command.add_flag("--lock-borders", arguments.settings.lockBorders, "Leave vertices on borders alone");
    command.add_flag("--lock-seams", arguments.settings.lockSeams, "Leave vertices on seams alone");
}

void addAutomaticOptions(CLI::App& command, GenerateArguments& arguments)
{
    AutomaticLods& automatic = arguments.settings.automatic;
    addParsedOption(
        command, "--automatic", "What automatic levels are like: balanced or classic [balanced]",
        [&automatic](const std::string& word) -> Result<Done> {
            if (word != "balanced" && word != "classic")
                return Error{ErrorCode::InvalidSetting, "has to be balanced or classic, not '" + word + "'"};
            automatic.method = word == "classic" ? AutomaticLods::Method::Classic : AutomaticLods::Method::Balanced;
            return Done{};
        })
        ->type_name("METHOD");
    addNumberOption(command, "--pixels", automatic.pixels, AutomaticLods::kMinPixels, AutomaticLods::kMaxPixels,
                    "How far off automatic levels may be when they appear, in pixels [1]")
        ->type_name("PIXELS");
}

void addLevelOptions(CLI::App& command, GenerateArguments& arguments)
{
    addParsedOption(command, "--levels", "Levels, nearest first, as told below [automatic levels]",
                    [&arguments](const std::string& text) -> Result<Done> {
                        arguments.levels = text;
                        return Done{};
                    })
        ->type_name("SPEC,...");
    addParsedOption(command, "--strategy", "What VALUE is: distance or pixelcount [distance]",
                    [&arguments](const std::string& word) -> Result<Done> {
                        const Result<std::string> strategy = parseStrategy(word);
                        if (!strategy)
                            return strategy.error();
                        arguments.strategy = strategy.value();
                        return Done{};
                    })
        ->type_name("STRATEGY");
    addParsedOption(command, "--loddef",
                    "Levels of all meshes as this file says [the .loddef beside each mesh, if any]",
                    [&arguments](const std::string& file) -> Result<Done> {
                        arguments.loddef = file;
                        return Done{};
                    })
        ->type_name("FILE");
    command.add_flag("--no-loddef", arguments.noLoddef, "Pass over .loddef files beside the meshes");
}

void addRunOptions(CLI::App& command, GenerateArguments& arguments)
{
    command.add_flag("--share-buffers", arguments.settings.shareBuffers, "Let two levels share one index buffer");
    command.add_flag("--separate-meshes", arguments.settings.separateMeshes,
                     "Let levels that lose too many leaves become meshes of their own, OUT.lodN.mesh beside OUT.mesh");
    addCountOption(command, "--repeat", arguments.settings.repeat, 1, 100000,
                   "Generate N times, for the times reported [1]")
        ->type_name("N");
    addCountOption(
        command, "-j,--jobs", arguments.jobs, 1, 1024,
        "Work on N files at a time, on few large ones with as many threads [as many as there are processors; "
        "with --repeat 1]")
        ->type_name("N");
    addCountOption(command, "--memory", arguments.memoryMib, 1, 1U << 30,
                   "Memory for all of them, by estimate [three quarters of what is free]")
        ->type_name("MIB");
    addParsedOption(command, "--shard", "Do part I of N of the files, from 1; every file is in one of the N",
                    [&arguments](const std::string& text) -> Result<Done> {
                        const Result<Shard> shard = parseShard(text);
                        if (!shard)
                            return shard.error();
                        arguments.shard = shard.value();
                        return Done{};
                    })
        ->type_name("I/N");
    addParsedOption(command, "--cache",
                    "Keep levels in this directory, up to 1 GiB, and take from it what was made before",
                    [&arguments](const std::string& directory) -> Result<Done> {
                        if (directory.empty())
                            return Error{ErrorCode::InvalidSetting, "the directory has no name"};
                        arguments.settings.cache = directory;
                        return Done{};
                    })
        ->type_name("DIR");
    addTimeLimitOption(command, arguments.batch);
    command.add_flag("--json", arguments.json,
                     "Print one JSON object a mesh on standard output, and nothing else there");
    addWriteOptions(command, arguments.settings.write);
}

} // namespace

void addGenerateCommand(CLI::App& app, int& exitCode)
{
    const auto arguments = std::make_shared<GenerateArguments>();
    CLI::App* command = app.add_subcommand("generate", "Give meshes levels of detail");
    command->add_option("IN", arguments->inputs, "Meshes, or directories with meshes at any depth")->required();
    command
        ->add_option(
            "-o,--output", arguments->output,
            "Where the result goes: a file, or a directory when it is one, ends in '/', or there are several inputs")
        ->required()
        ->type_name("OUT");
    addLevelOptions(*command, *arguments);
    addAutomaticOptions(*command, *arguments);
    addSimplifierOptions(*command, *arguments);
    addRunOptions(*command, *arguments);
    command->footer(kExamples);
    command->callback([arguments, command, &exitCode] { exitCode = runGenerate(*arguments, *command); });
}

} // namespace lodsmith::cli
