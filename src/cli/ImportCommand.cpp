#include "CommandOptions.h"
#include "Commands.h"
#include "ModelImport.h"
#include "OgreSession.h"
#include "Table.h"

#include <cstdio>
#include <memory>

namespace fs = std::filesystem;

namespace lodsmith::cli {

namespace {

constexpr const char* kExamples = R"(Examples:
  lodsmith import bunny.obj
      makes bunny.mesh beside it
  lodsmith import scene.gltf -o meshes/scene.mesh
)";

struct ImportArguments {
    std::string model;
    std::string output;
    WriteOptions write;
    BatchOptions batch;
};

fs::path outputOf(const ImportArguments& arguments)
{
    fs::path renamed = fs::path(arguments.model).replace_extension(".mesh");
    std::error_code ignored;
    if (arguments.output.empty())
        return renamed;
    if (arguments.output.back() == '/' || fs::is_directory(arguments.output, ignored))
        return fs::path(arguments.output) / renamed.filename();
    return arguments.output;
}

Result<Json> importFile(const ImportArguments& arguments, const fs::path& output)
{
    if (auto allowed = checkOutput(output, arguments.write.overwriting.existing); !allowed)
        return allowed.error();
    OgreSession session;
    const Ogre::MeshPtr mesh = session.create(output.filename().string());
    const Result<ImportReport> report = importModel(arguments.model, *mesh);
    if (!report)
        return report.error();
    const Result<std::string> bytes = meshBytes(*mesh, arguments.write.format);
    if (!bytes)
        return bytes.error();
    const Result<Done> written = writeMeshFiles(output, bytes.value(), {}, arguments.write.overwriting);
    if (!written)
        return written.error();
    return Json{{"submeshes", report.value().subMeshes},
                {"vertices", report.value().vertices},
                {"triangles", report.value().triangles},
                {"notes", report.value().notes}};
}

void show(const ImportArguments& arguments, const fs::path& output, const Json& record)
{
    std::printf("%s -> %s: %zu submeshes, %zu vertices, %zu triangles\n", printable(arguments.model).c_str(),
                printable(output.string()).c_str(), record["submeshes"].get<std::size_t>(),
                record["vertices"].get<std::size_t>(), record["triangles"].get<std::size_t>());
    for (const Json& note : record["notes"])
        std::printf("note: %s\n", printable(note.get<std::string>()).c_str());
}

int runImport(const ImportArguments& arguments)
{
    const fs::path output = outputOf(arguments);
    BatchJob job;
    job.file = arguments.model;
    job.inputBytes = fileBytes(arguments.model);
    job.outputDirectories = {output.has_parent_path() ? output.parent_path() : fs::path(".")};
    job.work = [&](Progress&) { return importFile(arguments, output); };
    return runBatch({job}, arguments.batch, [&](std::size_t, const Result<Json>& outcome) {
        if (outcome)
            show(arguments, output, outcome.value());
    });
}

} // namespace

void addImportCommand(CLI::App& app, int& exitCode)
{
    const auto arguments = std::make_shared<ImportArguments>();
    CLI::App* command = app.add_subcommand("import", "Make an OGRE mesh of a model (OBJ, glTF, FBX, PLY, STL ...)");
    command->add_option("MODEL", arguments->model, "A model in any format that assimp reads")->required();
    command
        ->add_option("-o,--output", arguments->output, "The mesh, or a directory for it [MODEL with the ending .mesh]")
        ->type_name("OUT");
    addWriteOptions(*command, arguments->write);
    addTimeLimitOption(*command, arguments->batch);
    command->footer(kExamples);
    command->callback([arguments, &exitCode] { exitCode = runImport(*arguments); });
}

} // namespace lodsmith::cli
