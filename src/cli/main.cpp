#include "CommandOptions.h"
#include "Commands.h"

#include <cstdio>
#include <exception>

namespace {

constexpr const char* kDescription = "lodsmith gives OGRE meshes levels of detail, and looks at those they have.";

constexpr const char* kFooter = R"(Examples:
  lodsmith import bunny.obj -o bunny.mesh
  lodsmith generate bunny.mesh -o bunny-lod.mesh --levels 10:proportional:0.5,30:proportional:0.75
  lodsmith measure bunny-lod.mesh
`lodsmith COMMAND --help` says more about each command.
Exit status: 0 done, 1 some inputs failed, 2 the command line is wrong.
)";

int run(int argc, char** argv)
{
    int exitCode = lodsmith::cli::kExitDone;
    CLI::App app(kDescription, "lodsmith");
    app.set_version_flag("--version", "lodsmith " LODSMITH_VERSION);
    app.require_subcommand(1);
    app.footer(kFooter);
    lodsmith::cli::addGenerateCommand(app, exitCode);
    lodsmith::cli::addInspectCommand(app, exitCode);
    lodsmith::cli::addMeasureCommand(app, exitCode);
    lodsmith::cli::addCostCommand(app, exitCode);
    lodsmith::cli::addRenderCommand(app, exitCode);
    lodsmith::cli::addImportCommand(app, exitCode);
    lodsmith::cli::addReportCommand(app, exitCode);
    lodsmith::cli::addStripCommand(app, exitCode);
    lodsmith::cli::addValidateCommand(app, exitCode);
    try {
        app.parse(argc, argv);
        return exitCode;
    } catch (const CLI::Success& wish) {
        app.exit(wish);
        return lodsmith::cli::finishOutput() ? lodsmith::cli::kExitDone : lodsmith::cli::kExitFailed;
    } catch (const CLI::ParseError& error) {
        std::fprintf(stderr, "lodsmith: %s\nlodsmith --help says what is possible.\n", error.what());
        return lodsmith::cli::kExitUsage;
    }
}

} // namespace

int main(int argc, char** argv)
{
    try {
        return run(argc, argv);
    } catch (const std::exception& exception) {
        std::fprintf(stderr, "lodsmith: %s\n", exception.what());
    } catch (...) {
        std::fprintf(stderr, "lodsmith: an unknown error\n");
    }
    return lodsmith::cli::kExitFailed;
}
