#include "RunStore.h"

#include <cmath>

namespace lodsmith::benchmarks {

namespace {

using soci::into;
using soci::session;
using soci::use;

long long machineId(session& session, const Machine& machine)
{
    long long id = 0;
    session << "INSERT OR IGNORE INTO machine (cpu, cores, memory_gib, kernel) VALUES (:cpu, :cores, :memory, :kernel)",
        use(machine.cpu), use(machine.cores), use(machine.memoryGib), use(machine.kernel);
    session
        << "SELECT id FROM machine WHERE cpu = :cpu AND cores = :cores AND memory_gib = :memory AND kernel = :kernel",
        use(machine.cpu), use(machine.cores), use(machine.memoryGib), use(machine.kernel), into(id);
    return id;
}

long long buildId(session& session, const Build& build)
{
    long long id = 0;
    session << "INSERT OR IGNORE INTO build (label, version, revision, compiler, build_type) "
               "VALUES (:label, :version, :revision, :compiler, :type)",
        use(build.label), use(build.version), use(build.revision), use(build.compiler), use(build.buildType);
    session << "SELECT id FROM build WHERE label = :label AND version = :version AND revision = :revision "
               "AND compiler = :compiler AND build_type = :type",
        use(build.label), use(build.version), use(build.revision), use(build.compiler), use(build.buildType), into(id);
    return id;
}

long long meshId(session& session, const MeshRecord& mesh)
{
    long long id = 0;
    const int normals = mesh.hasNormals, uvs = mesh.hasUvs;
    session << "INSERT OR IGNORE INTO mesh (name, hash, triangles, vertices, radius, has_normals, has_uvs) "
               "VALUES (:name, :hash, :triangles, :vertices, :radius, :normals, :uvs)",
        use(mesh.name), use(mesh.hash), use(mesh.triangles), use(mesh.vertices), use(mesh.radius), use(normals),
        use(uvs);
    session << "SELECT id FROM mesh WHERE name = :name AND hash = :hash", use(mesh.name), use(mesh.hash), into(id);
    return id;
}

long long configurationId(session& session, const Configuration& configuration)
{
    long long id = 0;
    session << "INSERT OR IGNORE INTO configuration (name, rule) VALUES (:name, :rule)", use(configuration.name),
        use(configuration.rule);
    session << "SELECT id FROM configuration WHERE name = :name AND rule = :rule", use(configuration.name),
        use(configuration.rule), into(id);
    return id;
}

/// NULL for a figure that is not known.
soci::indicator known(double value)
{
    return std::isnan(value) ? soci::i_null : soci::i_ok;
}

void insertRounds(session& session, long long run, const std::vector<Round>& rounds)
{
    for (std::size_t i = 0; i < rounds.size(); ++i) {
        const Round& round = rounds[i];
        const int number = int(i) + 1;
        soci::indicator reference = known(round.reference);
        session
            << "INSERT INTO round (run_id, number, seconds, planning_seconds, processor_seconds, reference_seconds) "
               "VALUES (:run, :number, :seconds, :planning, :processor, :reference)",
            use(run), use(number), use(round.seconds), use(round.planning), use(round.processor),
            use(round.reference, reference);
    }
}

void insertLevel(session& session, long long run, int number, const LevelRecord& level)
{
    const std::string kind = toString(level.target.kind);
    const MeasuredLevel& measured = level.measured;
    const int skipped = level.skipped;
    const long long bytes = static_cast<long long>(level.bytes);
    soci::indicator pixels = level.pixels > 0.0 ? soci::i_ok : soci::i_null, visible = known(level.visiblePixels);
    session
        << "INSERT INTO level (run_id, number, target_kind, target_amount, vertices, triangles, pixels, visible_px, "
           "bytes, skipped, stop) VALUES (:run, :number, :kind, :amount, :vertices, :triangles, :pixels, :visible, "
           ":bytes, :skipped, :stop)",
        use(run), use(number), use(kind), use(level.target.amount), use(measured.vertices), use(measured.triangles),
        use(level.pixels, pixels), use(level.visiblePixels, visible), use(bytes), use(skipped), use(measured.stop);
    if (!measured.deviation)
        return;
    const Deviation& deviation = *measured.deviation;
    session << "UPDATE level SET surface_mean = :a, surface_rms = :b, surface_maximum = :c, normal_mean = :d, "
               "normal_rms = :e, normal_maximum = :f, uv_mean = :g, uv_rms = :h, uv_maximum = :i, "
               "new_border_edges = :j, new_non_manifold_edges = :k, flipped_triangles = :l, repeated_triangles = :m, "
               "degenerate_triangles = :n WHERE run_id = :run AND number = :number",
        use(deviation.surface.mean), use(deviation.surface.rms), use(deviation.surface.maximum),
        use(deviation.normal.mean), use(deviation.normal.rms), use(deviation.normal.maximum), use(deviation.uv.mean),
        use(deviation.uv.rms), use(deviation.uv.maximum), use(deviation.newBorderEdges),
        use(deviation.newNonManifoldEdges), use(deviation.flippedTriangles), use(deviation.repeatedTriangles),
        use(deviation.degenerateTriangles), use(run), use(number);
}

} // namespace

RunStore::RunStore(Database& database, const Machine& machine, const Build& build, const MeasurementOptions& options)
    : mDatabase(database), mOptions(options)
{
    mDatabase.change([&](session& session) {
        mMachine = machineId(session, machine);
        mBuild = buildId(session, build);
    });
}

RunStore::Place RunStore::place(const MeshRecord& mesh, const Configuration& configuration)
{
    Place place;
    mDatabase.change([&](session& session) {
        place = {meshId(session, mesh), configurationId(session, configuration),
                 configuration.timed ? mOptions.timing.rounds : 1};
    });
    return place;
}

std::set<std::string> RunStore::done(const Place& place)
{
    std::set<std::string> generators;
    mDatabase.use([&](session& session) { generators = doneIn(session, place); });
    return generators;
}

std::set<std::string> RunStore::doneIn(session& session, const Place& place) const
{
    const soci::rowset<std::string> names =
        (session.prepare << "SELECT generator FROM run WHERE machine_id = :machine AND build_id = :build "
                            "AND mesh_id = :mesh AND configuration_id = :configuration AND samples = :samples "
                            "AND (error IS NOT NULL "
                            "OR (SELECT count(*) FROM round WHERE run_id = run.id) >= :rounds)",
         use(mMachine), use(mBuild), use(place.mesh), use(place.configuration), use(mOptions.deviation.samples),
         use(place.rounds));
    return {names.begin(), names.end()};
}

long long RunStore::insertRun(session& session, const Place& place, const RunRecord& record) const
{
    const long peak = record.peakKb.value_or(0);
    soci::indicator peakKnown = record.peakKb ? soci::i_ok : soci::i_null;
    soci::indicator hasError = record.error.empty() ? soci::i_null : soci::i_ok;
    session << "DELETE FROM run WHERE machine_id = :machine AND build_id = :build AND mesh_id = :mesh "
               "AND configuration_id = :configuration AND generator = :generator AND samples = :samples",
        use(mMachine), use(mBuild), use(place.mesh), use(place.configuration), use(record.generator),
        use(mOptions.deviation.samples);
    session << "INSERT INTO run (machine_id, build_id, mesh_id, configuration_id, generator, samples, peak_kb, error) "
               "VALUES (:machine, :build, :mesh, :configuration, :generator, :samples, :peak, :error)",
        use(mMachine), use(mBuild), use(place.mesh), use(place.configuration), use(record.generator),
        use(mOptions.deviation.samples), use(peak, peakKnown), use(record.error, hasError);
    long long run = 0;
    session << "SELECT last_insert_rowid()", into(run);
    return run;
}

void RunStore::save(const Place& place, const RunRecord& record, IfDone ifDone)
{
    mDatabase.change([&](session& session) {
        if (ifDone == IfDone::Keep && doneIn(session, place).count(record.generator) > 0)
            return;
        const long long run = insertRun(session, place, record);
        insertRounds(session, run, record.rounds);
        for (std::size_t i = 0; i < record.levels.size(); ++i)
            insertLevel(session, run, int(i) + 1, record.levels[i]);
    });
}

} // namespace lodsmith::benchmarks
