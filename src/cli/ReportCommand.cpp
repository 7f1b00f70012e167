#include "CommandOptions.h"
#include "Commands.h"
#include "Numbers.h"
#include "Table.h"
#include "report/ReportRun.h"

#include <cstdio>
#include <memory>

namespace fs = std::filesystem;

namespace lodsmith::cli {

namespace {

constexpr const char* kExamples = R"(Examples:
  lodsmith report tree.mesh -o tree-report
      one page, tree-report/index.html, with everything in it
  lodsmith report models -o report -j 2
      every .mesh below models/: an overview, and a page a mesh
A mesh that has levels is judged by them; one that has none by those that its definition, or else the automatic
configuration, would give it.
)";

constexpr double kLeastBudget = 0.01, kMostBudget = 1000.0;

struct ReportArguments {
    std::vector<std::string> inputs;
    std::string output;
    ReportSettings settings;
    BatchOptions batch;
    bool force = false;
};

std::string line(const Json& mesh)
{
    const Json& drawn = mesh["drawn"];
    const double now = drawn["now"].get<double>(), saved = drawn["saved"].get<double>();
    return printable(mesh["mesh"].get<std::string>()) + ": " + std::to_string(mesh["levels"].size() - 1) + " levels ("
           + mesh["levels_from"].get<std::string>() + "), "
           + (saved > 0.0 ? formatNumber(100.0 * saved / now, 3) + " % can be saved" : "nothing can be saved") + ", "
           + std::to_string(mesh["warnings"].size()) + " warnings"
           + (mesh["no_pictures"].is_null() ? ""
                                            : "; no pictures: " + printable(mesh["no_pictures"].get<std::string>()));
}

int runReport(const ReportArguments& arguments)
{
    if (arguments.output.empty())
        throw UsageError("-o: the output has no name");
    const Result<std::vector<ReportPage>> pages = planPages(arguments.inputs, arguments.output);
    if (!pages)
        throw UsageError(pages.error().message);
    const Existing existing = arguments.force ? Existing::Replace : Existing::Keep;
    if (auto allowed = ReportFiles::check(arguments.output, existing); !allowed) {
        printError(allowed.error());
        return kExitFailed;
    }
    ReportRun run(pages.value(), arguments.settings, arguments.output);
    const int exitCode = runBatch(run.jobs(), arguments.batch, [&](std::size_t job, const Result<Json>& outcome) {
        const Json mesh = run.take(job, outcome);
        if (!mesh.is_null() && mesh["error"].is_null())
            std::printf("%s\n", line(mesh).c_str());
    });
    if (auto published = run.finish(); !published) {
        printError(published.error());
        return kExitFailed;
    }
    std::printf("%s\n", printable((fs::path(arguments.output) / "index.html").string()).c_str());
    return finishOutput() ? exitCode : kExitFailed;
}

} // namespace

void addReportCommand(CLI::App& app, int& exitCode)
{
    const auto arguments = std::make_shared<ReportArguments>();
    CLI::App* command = app.add_subcommand("report", "Write pages that say what levels save and how they look");
    command->add_option("MESH", arguments->inputs, "Meshes, or directories with meshes at any depth")->required();
    command->add_option("-o,--output", arguments->output, "The directory of the report")->required()->type_name("DIR");
    addNumberOption(*command, "--pixels", arguments->settings.pixelBudget, kLeastBudget, kMostBudget,
                    "Visible error that a level may have where it appears, in pixels [1]")
        ->type_name("PIXELS");
    addCountOption(*command, "--samples", arguments->settings.samples, 1, 100000000, "Points on each surface [100000]")
        ->type_name("N");
    addCountOption(*command, "-j,--jobs", arguments->batch.workers, 1, 1024, "Work on N files at a time [1]")
        ->type_name("N");
    addTimeLimitOption(*command, arguments->batch);
    command->add_flag("--force", arguments->force, "Put the report into a directory that holds other things too");
    command->footer(kExamples);
    command->callback([arguments, &exitCode] { exitCode = runReport(*arguments); });
}

} // namespace lodsmith::cli
