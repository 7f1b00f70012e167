#include "MeshBuild.h"

#include "BuildRecord.h"
#include "ProductFiles.h"

#include <chrono>

namespace lodsmith::cli {

namespace {

/// What differs from run to run is no part of a record, whose bytes are the same whenever the mesh's are.
constexpr const char* kMeasured[] = {"cached",   "read_ms",    "generate_ms", "generate_min_ms",
                                     "order_ms", "foliage_ms", "write_ms",    "peak_kb"};

bool isInPlace(const PlannedFile& file)
{
    return identity(file.input) == identity(file.output);
}

Result<Done> write(const PlannedFile& file, const GenerateSettings& settings, const BuildRules& rules,
                   const GeneratedMesh& mesh)
{
    if (isInPlace(file))
        return writeMeshFiles(file.output, mesh.bytes, mesh.companions, settings.write.overwriting);
    BuildRecord record{recordVersion(), rules.options, file.input, mesh.read, {}, mesh.record};
    for (const char* member : kMeasured)
        record.result.erase(member);
    return writeProduct(file.output, mesh, std::move(record), rules.force);
}

} // namespace

std::optional<Json> upToDate(const PlannedFile& file, const BuildRules& rules)
{
    if (file.error || rules.force || isInPlace(file))
        return std::nullopt;
    std::optional<BuildRecord> record = readRecord(file.output);
    if (!record || identity(record->input) != identity(file.input) || !isCurrent(*record, rules.options)
        || !isWhole(*record))
        return std::nullopt;
    for (const char* member : kMeasured)
        record->result[member] = nullptr;
    record->result["up_to_date"] = true;
    return std::move(record->result);
}

Result<Json> buildMesh(const GenerateSettings& settings, const BuildRules& rules, const PlannedFile& file,
                       OgreSession& session, Progress& progress)
{
    // Before the work rather than after it; writing looks again.
    const auto allowed = isInPlace(file) ? checkOutput(file.output, settings.write.overwriting.existing)
                                         : checkProduct(file.output, rules.force);
    if (!allowed)
        return allowed.error();
    Result<GeneratedMesh> mesh = generateMesh(settings, file, session, progress);
    if (!mesh)
        return mesh.error();
    const auto start = std::chrono::steady_clock::now();
    if (auto written = write(file, settings, rules, mesh.value()); !written)
        return written.error();
    Json record = std::move(mesh).value().record;
    const std::chrono::duration<double, std::milli> writing = std::chrono::steady_clock::now() - start;
    record["write_ms"] = writing.count();
    record["up_to_date"] = false;
    return record;
}

} // namespace lodsmith::cli
