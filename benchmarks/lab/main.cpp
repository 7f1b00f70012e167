// The benchmark database: measures generators, keeps what was measured, shows and compares it.

#include "Commands.h"

#include <exception>
#include <iostream>

namespace {

int run(int argc, char** argv)
{
    using namespace lodsmith::benchmarks;
    int exitCode = kExitDone;
    CLI::App app("Measures LOD generators on meshes and keeps the results in a database (docs/benchmark-database.md).",
                 "lodsmith_lab");
    app.require_subcommand(1);
    app.footer("Exit status: 0 done, 1 something failed or has got worse, 2 the command line is wrong.");
    addRunCommand(app, exitCode);
    addPeakCommand(app, exitCode);
    addShowCommand(app, exitCode);
    addTablesCommand(app, exitCode);
    addPlotsCommand(app, exitCode);
    addCompareCommand(app, exitCode);
    try {
        app.parse(argc, argv);
        return exitCode;
    } catch (const CLI::Success& wish) {
        return app.exit(wish);
    } catch (const CLI::ParseError& error) {
        std::cerr << "lodsmith_lab: " << error.what() << "\nlodsmith_lab --help says what is possible.\n";
        return kExitUsage;
    }
}

} // namespace

int main(int argc, char** argv)
{
    try {
        return run(argc, argv);
    } catch (const std::exception& error) {
        std::cerr << "lodsmith_lab: " << error.what() << '\n';
        return lodsmith::benchmarks::kExitFailed;
    }
}
