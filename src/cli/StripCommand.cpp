#include "CommandOptions.h"
#include "Commands.h"
#include "OgreSession.h"
#include "OutputPlan.h"
#include "Table.h"

#include <lodsmith/ogre/MeshWriter.h>

#include <cstdio>
#include <memory>

namespace lodsmith::cli {

namespace {

constexpr const char* kExamples = R"(Example:
  lodsmith strip tree-lod.mesh -o tree.mesh
)";

struct StripArguments {
    std::vector<std::string> inputs;
    std::string output;
    WriteOptions write;
    BatchOptions batch;
};

Result<Json> stripFile(const PlannedFile& file, const WriteOptions& options)
{
    OgreSession session;
    const Result<Ogre::MeshPtr> mesh = session.load(file.input);
    if (!mesh)
        return mesh.error();
    const unsigned levels = mesh.value()->getNumLodLevels() - 1u;
    MeshWriter::removeLevels(*mesh.value());
    std::vector<std::string> notes;
    const std::vector<Companion> companions = findSkeleton(*mesh.value(), file.input, notes);
    const Result<std::string> bytes = meshBytes(*mesh.value(), options.format);
    if (!bytes)
        return bytes.error();
    const Result<Done> written = writeMeshFiles(file.output, bytes.value(), companions, options.overwriting);
    if (!written)
        return written.error();
    return Json{{"levels", levels}, {"notes", notes}};
}

BatchJob makeJob(const PlannedFile& file, const WriteOptions& options)
{
    BatchJob job;
    job.file = file.input.string();
    job.inputBytes = fileBytes(file.input);
    job.outputDirectories = {file.output.has_parent_path() ? file.output.parent_path() : std::filesystem::path(".")};
    job.work = [&file, &options](Progress&) -> Result<Json> {
        return file.error ? Result<Json>(*file.error) : stripFile(file, options);
    };
    return job;
}

void show(const PlannedFile& file, const Json& record)
{
    std::printf("%s -> %s: %u levels taken out\n", printable(file.input.string()).c_str(),
                printable(file.output.string()).c_str(), record["levels"].get<unsigned>());
    for (const Json& note : record["notes"])
        std::printf("note: %s\n", printable(note.get<std::string>()).c_str());
}

int runStrip(const StripArguments& arguments)
{
    const Result<std::vector<PlannedFile>> plan = planOutputs(arguments.inputs, arguments.output);
    if (!plan)
        throw UsageError(plan.error().message);
    std::vector<BatchJob> jobs;
    for (const PlannedFile& file : plan.value())
        jobs.push_back(makeJob(file, arguments.write));
    return runBatch(jobs, arguments.batch, [&](std::size_t job, const Result<Json>& outcome) {
        if (outcome)
            show(plan.value()[job], outcome.value());
    });
}

} // namespace

void addStripCommand(CLI::App& app, int& exitCode)
{
    const auto arguments = std::make_shared<StripArguments>();
    CLI::App* command = app.add_subcommand("strip", "Take levels of detail out of meshes again");
    command->add_option("MESH", arguments->inputs, "Meshes, or directories with meshes at any depth")->required();
    command->add_option("-o,--output", arguments->output, "Where the result goes, as with generate")
        ->required()
        ->type_name("OUT");
    addWriteOptions(*command, arguments->write);
    addTimeLimitOption(*command, arguments->batch);
    command->footer(kExamples);
    command->callback([arguments, &exitCode] { exitCode = runStrip(*arguments); });
}

} // namespace lodsmith::cli
