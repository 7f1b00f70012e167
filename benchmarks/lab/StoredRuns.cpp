#include "StoredRuns.h"

#include <limits>

namespace lodsmith::benchmarks {

namespace {

using soci::into;
using soci::session;
using soci::use;

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// Columns of the table `level`, and words, in the order of LevelFigure.
struct FigureName {
    const char* column;
    const char* words;
};
constexpr std::array<FigureName, kLevelFigures> kFigureNames{{
    {"triangles", "triangles"},
    {"vertices", "vertices"},
    {"bytes", "bytes"},
    {"surface_mean", "mean surface"},
    {"surface_rms", "RMS surface"},
    {"surface_maximum", "maximum surface"},
    {"normal_mean", "mean normal"},
    {"normal_rms", "RMS normal"},
    {"normal_maximum", "maximum normal"},
    {"uv_mean", "mean UV"},
    {"uv_rms", "RMS UV"},
    {"uv_maximum", "maximum UV"},
    {"visible_px", "visible error"},
    {"new_border_edges", "new border edges"},
    {"new_non_manifold_edges", "new non-manifold edges"},
    {"flipped_triangles", "flipped triangles"},
    {"repeated_triangles", "repeated triangles"},
    {"degenerate_triangles", "degenerate triangles"},
}};

using RunsById = std::map<long long, StoredRun*>;

RunsById readKeys(session& session, const std::string& label, const std::string& machine, StoredRuns& runs)
{
    RunsById byId;
    RunKey key;
    long long id = 0, failed = 0;
    double radius = 0.0, peak = 0.0;
    soci::indicator hasPeak = soci::i_null;
    soci::statement statement =
        (session.prepare << "SELECT run_id, result.configuration, generator, mesh, hash, rule, samples, mesh_radius, "
                            "peak_kb, error IS NOT NULL FROM result JOIN (SELECT id AS run_id, samples FROM run) "
                            "USING (run_id) JOIN mesh ON mesh.id = mesh_id "
                            "JOIN configuration ON configuration.id = configuration_id "
                            "WHERE label = :label AND machine = :machine",
         use(label), use(machine), into(id), into(key.configuration), into(key.generator), into(key.mesh),
         into(key.meshHash), into(key.rule), into(key.samples), into(radius), into(peak, hasPeak), into(failed));
    statement.execute();
    while (statement.fetch()) {
        StoredRun& run = runs[key];
        run.meshRadius = radius;
        run.failed = failed != 0;
        if (hasPeak == soci::i_ok)
            run.peakKb = peak;
        byId[id] = &run;
    }
    return byId;
}

void readRounds(session& session, const RunsById& runs)
{
    long long id = 0;
    double processor = 0.0, reference = 0.0;
    soci::indicator hasProcessor = soci::i_null, hasReference = soci::i_null;
    soci::statement statement =
        (session.prepare << "SELECT run_id, processor_seconds, reference_seconds FROM round ORDER BY run_id, number",
         into(id), into(processor, hasProcessor), into(reference, hasReference));
    statement.execute();
    while (statement.fetch())
        if (const auto run = runs.find(id); run != runs.end()) {
            if (hasProcessor == soci::i_ok)
                run->second->processor.push_back(processor);
            if (hasReference == soci::i_ok)
                run->second->reference.push_back(reference);
        }
}

void readFigure(session& session, std::size_t figure, const RunsById& runs)
{
    long long id = 0;
    int number = 0;
    double value = 0.0;
    soci::indicator known = soci::i_null;
    soci::statement statement =
        (session.prepare << std::string("SELECT run_id, number, 1.0 * ") + kFigureNames[figure].column + " FROM level",
         into(id), into(number), into(value, known));
    statement.execute();
    while (statement.fetch())
        if (const auto run = runs.find(id); run != runs.end())
            run->second->levels[number][figure] = known == soci::i_ok ? value : kUnknown;
}

} // namespace

const char* nameOf(LevelFigure figure)
{
    return kFigureNames[static_cast<std::size_t>(figure)].words;
}

StoredRuns readRuns(Database& database, const std::string& label, const std::string& machine)
{
    StoredRuns runs;
    database.use([&](session& session) {
        const RunsById byId = readKeys(session, label, machine, runs);
        readRounds(session, byId);
        for (std::size_t figure = 0; figure < kLevelFigures; ++figure)
            readFigure(session, figure, byId);
    });
    return runs;
}

} // namespace lodsmith::benchmarks
