#include "Commands.h"

#include "Configuration.h"
#include "ResultViews.h"

#include <algorithm>
#include <iostream>

namespace lodsmith::benchmarks {

namespace {

struct ShowArguments {
    std::string database;
    std::string view;
    std::string label;
};

/// A table of docs/benchmarks.md.
struct Table {
    const char* title;
    const char* sentence;
    const char* view;
    std::vector<Filter> filters;
};

std::vector<Table> benchmarkTables()
{
    const Filter halved{"configuration", kHalvings};
    const Filter atOgre{"configuration", std::string(kOgreCurvature) + "-counts"};
    const Filter atMeshoptimizer{"configuration", std::string(kMeshoptimizer) + "-counts"};
    return {
        {"Time",
         "Milliseconds for the chain of four levels, median; vertex-cache order not counted.",
         "speed_up",
         {halved}},
        {"Growth",
         "Over the planets; an exponent of at most 1 over n log n means no faster than n log n.",
         "growth",
         {halved}},
        {"Memory",
         "Growth of the peak resident memory while the chain is made, each generator in a process of its own.",
         "memory",
         {halved}},
        {"Error at the triangle counts of OGRE",
         "Two-sided deviation over OGRE's, geometric mean over the meshes whose level has the same number of triangles "
         "within 2%.",
         "quality",
         {atOgre, {"over that of", kOgreCurvature}}},
        {"Error at the triangle counts of meshoptimizer",
         "The same on the levels that meshoptimizer makes.",
         "quality",
         {atMeshoptimizer, {"over that of", kMeshoptimizer}}},
        {"Mean surface deviation, mesh by mesh, over OGRE's",
         "Lodsmith, at equal triangles.",
         "quality_by_mesh",
         {atOgre, {"over that of", kOgreCurvature}}},
        {"Mean surface deviation, mesh by mesh, over meshoptimizer's",
         "Lodsmith, at equal triangles.",
         "quality_by_mesh",
         {atMeshoptimizer, {"over that of", kMeshoptimizer}}},
        {"Faults",
         "Sums over all levels of all meshes; in brackets the number of meshes that have any.",
         "faults",
         {atOgre}},
        {"Visible error",
         "Greatest deviation in pixels when a level appears, of levels that say when they do.",
         "visible_error",
         {}},
        {"Triangles drawn",
         "From a radius of 512 pixels on: by doublings of the distance until it is 1.4 pixels, and by distance until "
         "it is 50 times as far. \"Moved\": each level shown from where it is one pixel off.",
         "triangles_drawn",
         {}},
        {"Cost of these levels", "", "cost_of_levels", {}},
        {"Levels by their size on screen", "", "by_size", {}},
        {"Vertex targets that are missed by more than 1%", "", "missed_targets", {halved}},
        {"Failures", "", "failures", {}},
        {"Worst cases", "", "worst_cases", {}},
    };
}

std::vector<Scope> existingScopes(Database& database, const ShowArguments& arguments)
{
    const std::vector<Scope> scopes = scopesOf(database, arguments.label);
    if (scopes.empty())
        throw DatabaseError(database.path() + ": has no results"
                            + (arguments.label.empty() ? "" : " of " + arguments.label));
    return scopes;
}

int show(const ShowArguments& arguments)
{
    Database database(arguments.database, Database::Mode::Existing);
    const std::vector<std::string> views = viewNames(database);
    if (std::count(views.begin(), views.end(), arguments.view) == 0) {
        std::cerr << "lodsmith_lab: no view " << arguments.view << "; there are";
        for (const std::string& view : views)
            std::cerr << (&view == &views.front() ? " " : ", ") << view;
        std::cerr << '\n';
        return kExitUsage;
    }
    for (const Scope& scope : existingScopes(database, arguments)) {
        std::cout << scope.label << " on " << scope.machine << "\n\n";
        viewTable(database, arguments.view, scope).print(std::cout);
    }
    return kExitDone;
}

int showTables(const ShowArguments& arguments)
{
    Database database(arguments.database, Database::Mode::Existing);
    for (const Scope& scope : existingScopes(database, arguments)) {
        std::cout << scope.label << " on " << scope.machine << "\n\n";
        for (const Table& table : benchmarkTables()) {
            std::cout << "## " << table.title << "\n\n";
            if (*table.sentence)
                std::cout << table.sentence << "\n\n";
            viewTable(database, table.view, scope, table.filters).print(std::cout);
        }
    }
    return kExitDone;
}

/// A full disk or a closed pipe is a failure, not half a table.
int finished(int exitCode)
{
    return std::cout.flush() ? exitCode : kExitFailed;
}

} // namespace

void addShowCommand(CLI::App& app, int& exitCode)
{
    auto arguments = std::make_shared<ShowArguments>();
    CLI::App* command = app.add_subcommand("show", "print a view of the database as a Markdown table");
    command->add_option("database", arguments->database, "the file")->required();
    command->add_option("view", arguments->view, "such as speed_up, quality or worst_cases")->required();
    command->add_option("--label", arguments->label, "of which build; default the one measured last");
    command->callback([arguments, &exitCode] { exitCode = finished(show(*arguments)); });
}

void addTablesCommand(CLI::App& app, int& exitCode)
{
    auto arguments = std::make_shared<ShowArguments>();
    CLI::App* command = app.add_subcommand("tables", "print the tables of docs/benchmarks.md");
    command->add_option("database", arguments->database, "the file")->required();
    command->add_option("--label", arguments->label, "of which build; default the one measured last");
    command->callback([arguments, &exitCode] { exitCode = finished(showTables(*arguments)); });
}

} // namespace lodsmith::benchmarks
