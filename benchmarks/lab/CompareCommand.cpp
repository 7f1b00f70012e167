#include "Commands.h"

#include "Comparison.h"
#include "ResultViews.h"

#include "../MarkdownTable.h"

#include <cmath>
#include <iostream>

namespace lodsmith::benchmarks {

namespace {

struct CompareArguments {
    std::string database;
    std::vector<std::string> others; ///< two labels, or another database
};

/// One side of the comparison.
struct Side {
    Scope scope;
    StoredRuns runs;
};

Side read(Database& database, const std::string& label)
{
    const std::vector<Scope> scopes = scopesOf(database, label);
    if (scopes.empty())
        throw DatabaseError(database.path() + ": has no results" + (label.empty() ? "" : " of " + label));
    // Of several machines the one of the newest run.
    const Scope& scope = scopes.front();
    return {scope, readRuns(database, scope.label, scope.machine)};
}

const char* wordFor(Verdict verdict)
{
    switch (verdict) {
    case Verdict::Same: return "same";
    case Verdict::Better: return "better";
    case Verdict::Worse: return "WORSE";
    }
    return "";
}

std::string chanceText(double chance)
{
    return chance < 0.0001 ? "< 0.0001" : fixed(chance, 4);
}

void printTimes(const Comparison& comparison)
{
    if (comparison.times.empty())
        return;
    std::cout
        << "## Time\n\nNew over old, processor time in shares of the reference. The other generators have moved by "
        << fixed(100.0 * (std::exp(comparison.shift) - 1.0), 1) << "% and vary by "
        << fixed(100.0 * comparison.spread, 1) << "%, which is the machine's doing.\n\n";
    MarkdownTable table({"configuration", "generator", "meshes", "new / old", "chance of no change", "verdict"});
    for (const TimeChange& change : comparison.times)
        table.addRow({change.configuration, change.generator, std::to_string(change.meshes), fixed(change.ratio, 3),
                      chanceText(change.chance), wordFor(change.verdict)});
    table.print(std::cout);
}

void printMeshes(const Comparison& comparison)
{
    if (comparison.meshes.empty())
        return;
    std::cout << "## Single meshes\n\n";
    MarkdownTable table({"configuration", "generator", "mesh", "figure", "old", "new", "new / old", "verdict"});
    for (const MeshChange& change : comparison.meshes)
        table.addRow({change.key.configuration, change.key.generator, change.key.mesh, change.figure,
                      fixed(change.before, 2), fixed(change.after, 2), fixed(change.ratio, 3),
                      wordFor(change.verdict)});
    table.print(std::cout);
}

void printFigures(const Comparison& comparison)
{
    if (comparison.figures.empty())
        return;
    std::cout << "## Levels\n\nOf each figure less is better.\n\n";
    MarkdownTable table({"configuration", "generator", "figure", "levels", "better", "worse", "new / old", "most lost",
                         "where", "verdict"});
    for (const FigureChange& change : comparison.figures)
        table.addRow({change.configuration, change.generator, change.figure, std::to_string(change.levels),
                      std::to_string(change.better), std::to_string(change.worse), fixed(change.ratio, 4),
                      change.worstLevel.empty() ? "-" : fixed(change.worst, 3), change.worstLevel,
                      wordFor(change.verdict)});
    table.print(std::cout);
}

template <class Change>
std::size_t count(const std::vector<Change>& changes, Verdict verdict)
{
    std::size_t number = 0;
    for (const Change& change : changes)
        number += change.verdict == verdict;
    return number;
}

std::size_t countAll(const Comparison& comparison, Verdict verdict)
{
    return count(comparison.times, verdict) + count(comparison.meshes, verdict) + count(comparison.figures, verdict);
}

int report(const Side& before, const Side& after)
{
    std::cout << "# " << before.scope.label << " -> " << after.scope.label << "\n\n";
    const Comparison comparison = compare(before.runs, after.runs, before.scope.machine == after.scope.machine);
    if (comparison.compared == 0)
        throw std::runtime_error("the two have no run of Lodsmith's generators in common");
    printTimes(comparison);
    printMeshes(comparison);
    printFigures(comparison);
    for (const std::string& note : comparison.notes)
        std::cout << note << "\n\n";
    std::cout << comparison.compared << " runs compared: " << countAll(comparison, Verdict::Worse) << " worse, "
              << countAll(comparison, Verdict::Better) << " better." << std::endl;
    return std::cout && !comparison.hasRegression() ? kExitDone : kExitFailed;
}

int compareFiles(const CompareArguments& arguments)
{
    Database database(arguments.database, Database::Mode::Existing);
    if (arguments.others.size() == 2)
        return report(read(database, arguments.others[0]), read(database, arguments.others[1]));
    Database other(arguments.others.front(), Database::Mode::Existing);
    return report(read(database, ""), read(other, ""));
}

} // namespace

void addCompareCommand(CLI::App& app, int& exitCode)
{
    auto arguments = std::make_shared<CompareArguments>();
    CLI::App* command =
        app.add_subcommand("compare", "say what got better and worse; exit status 1 when anything got worse");
    command->add_option("database", arguments->database, "the file")->required();
    command
        ->add_option("others", arguments->others,
                     "OLD NEW: two labels; or another database, whose newest label is the new one")
        ->required()
        ->expected(1, 2);
    command->callback([arguments, &exitCode] { exitCode = compareFiles(*arguments); });
}

} // namespace lodsmith::benchmarks
