#include "Commands.h"

#include "Configuration.h"
#include "ResultViews.h"
#include "SvgPlot.h"

#include "../../src/files/AtomicFile.h"

#include <cmath>
#include <filesystem>
#include <iostream>
#include <map>

namespace lodsmith::benchmarks {

namespace {

using soci::into;
using soci::session;
using soci::use;

constexpr const char* kOurs = "#0b6e4f";
constexpr const char* kTheirs = "#b3541e";
constexpr const char* kShownAsSaid = "#888";

struct PlotsArguments {
    std::string database;
    std::string directory;
    std::string label;
};

/// The levels of one configuration and generator.
struct Chain {
    std::string configuration;
    std::string generator;
};
const Chain kBalanced = {kCandidates, kLodsmith};
const Chain kFormula = {kClassic, kLodsmithCurvature};

std::vector<PlotTick> sizeTicks()
{
    std::vector<PlotTick> ticks;
    for (int size = 512; size >= 2; size /= 2)
        ticks.push_back({double(size), std::to_string(size)});
    return ticks;
}

PlotAxis sizeAxis(const std::string& label)
{
    return {label, 600.0, 1.7, true, sizeTicks()};
}

struct Row {
    int run = 0;
    PlotPoint point;
};

/// @param source three columns of a view, a run, x and y, and the beginning of a condition
std::vector<Row> rowsOf(session& session, const Scope& scope, const Chain& chain, const std::string& source)
{
    Row row;
    soci::statement statement =
        (session.prepare << "SELECT " + source
                                + " AND label = :label AND machine = :machine AND configuration = :configuration "
                                  "AND generator = :generator ORDER BY 1, 2 DESC",
         use(scope.label), use(scope.machine), use(chain.configuration), use(chain.generator), into(row.run),
         into(row.point.x), into(row.point.y));
    statement.execute();
    std::vector<Row> rows;
    while (statement.fetch())
        rows.push_back(row);
    return rows;
}

/// What is left of the meshes as they recede, as the geometric mean of shares of their triangles.
std::vector<PlotPoint> trianglesLeft(session& session, const Scope& scope, const Chain& chain, bool moved)
{
    constexpr double kStep = 1.02;
    const std::string source =
        "run_id, radius, 1.0 * triangles / mesh_triangles FROM appearance WHERE moved = " + std::to_string(int(moved));
    std::map<int, std::map<double, double>> levels; // by run, by radius
    for (const Row& row : rowsOf(session, scope, chain, source))
        levels[row.run][row.point.x] = row.point.y;
    std::vector<PlotPoint> points;
    for (double size = 600.0; size >= 1.7 && !levels.empty(); size /= kStep) {
        double logarithms = 0.0;
        for (const auto& [number, of] : levels)
            logarithms += std::log(of.lower_bound(size)->second);
        points.push_back({size, std::exp(logarithms / double(levels.size()))});
    }
    return points;
}

SvgPlot trianglesPlot(session& session, const Scope& scope)
{
    SvgPlot plot;
    plot.title = "Triangles left over the size on screen";
    plot.x = sizeAxis("radius on screen, pixels (the mesh recedes to the right)");
    plot.y = {"triangles left (geometric mean)", 0.01, 1.0, true, {}};
    for (const int percent : {1, 2, 5, 10, 20, 50, 100})
        plot.y.ticks.push_back({percent / 100.0, std::to_string(percent) + " %"});
    plot.series = {
        {"all nine candidates, at most 1 px off", kOurs, true, trianglesLeft(session, scope, kBalanced, false)},
        {"the levels of 2012, shown when they are 1 px off", kTheirs, true,
         trianglesLeft(session, scope, kFormula, true)},
        {"the levels of 2012 where they are shown", kShownAsSaid, true, trianglesLeft(session, scope, kFormula, false)},
    };
    plot.legendX = 0.47;
    plot.legendY = 0.04;
    return plot;
}

std::vector<PlotPoint> visibleErrors(session& session, const Scope& scope, const Chain& chain)
{
    std::vector<PlotPoint> points;
    for (const Row& row : rowsOf(session, scope, chain,
                                 "run_id, sqrt(pixels / pi()), visible_px FROM result_level "
                                 "WHERE NOT skipped AND pixels > 0 AND visible_px IS NOT NULL"))
        points.push_back(row.point);
    return points;
}

SvgPlot errorPlot(session& session, const Scope& scope)
{
    SvgPlot plot;
    plot.title = "Visible error of each level of each mesh";
    plot.x = sizeAxis("radius on screen at which the level appears, pixels");
    plot.y = {"visible error, pixels", 0.0, 8.0, false, {}};
    for (int pixels = 0; pixels <= 8; ++pixels)
        plot.y.ticks.push_back({double(pixels), std::to_string(pixels)});
    plot.series = {
        {"all nine candidates", kOurs, false, visibleErrors(session, scope, kBalanced)},
        {"the formula of 2012", kTheirs, false, visibleErrors(session, scope, kFormula)},
    };
    plot.legendX = 0.65;
    return plot;
}

void write(const std::string& file, const SvgPlot& plot)
{
    for (const PlotSeries& series : plot.series)
        if (series.points.empty())
            throw DatabaseError(file + ": the database has nothing on \"" + series.name + '"');
    AtomicFile output(file, Existing::Replace, Durability::None);
    Result<Done> done = output.prepare(toSvg(plot));
    if (done)
        done = output.commit();
    if (!done)
        throw DatabaseError(describe(done.error()));
}

int plots(const PlotsArguments& arguments)
{
    Database database(arguments.database, Database::Mode::Existing);
    const std::vector<Scope> scopes = scopesOf(database, arguments.label);
    if (scopes.size() != 1) {
        std::cerr << "lodsmith_lab: " << arguments.database << ": has results of " << scopes.size()
                  << " machines for this label; plots are of one\n";
        return kExitFailed;
    }
    database.use([&](session& session) {
        const std::filesystem::path directory = arguments.directory;
        write((directory / "automatic-triangles.svg").string(), trianglesPlot(session, scopes.front()));
        write((directory / "automatic-error.svg").string(), errorPlot(session, scopes.front()));
    });
    return kExitDone;
}

} // namespace

void addPlotsCommand(CLI::App& app, int& exitCode)
{
    auto arguments = std::make_shared<PlotsArguments>();
    CLI::App* command = app.add_subcommand("plots", "write the plots of docs/automatic-lod.md");
    command->add_option("database", arguments->database, "the file")->required();
    command->add_option("-o,--output", arguments->directory, "the directory for them")
        ->required()
        ->check(CLI::ExistingDirectory);
    command->add_option("--label", arguments->label, "of which build; default the one measured last");
    command->callback([arguments, &exitCode] { exitCode = plots(*arguments); });
}

} // namespace lodsmith::benchmarks
