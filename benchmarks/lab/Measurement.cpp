#include "Measurement.h"

#include "MeshHash.h"

#include "../MeshoptPeer.h"
#include "../PeakMemory.h"
#include "../StoredLevels.h"

#include <lodsmith/analysis/MeshStatistics.h>

#include <limits>
#include <stdexcept>

namespace lodsmith::benchmarks {

namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

std::uint64_t indexBytes(const MeshView& original, const LevelIndices& level)
{
    std::uint64_t bytes = 0;
    for (std::size_t i = 0; i < level.size(); ++i)
        bytes += level[i].size() * std::uint64_t(original.subMeshes[i].indexBytes);
    return bytes;
}

std::vector<LevelRecord> measureMade(const Subject& subject, const Plan& plan, const std::vector<PeerLevel>& made,
                                     const DeviationOptions& options)
{
    const std::vector<MeasuredLevel> measured = measureLevels(subject, made, options);
    LevelIndices before = originalIndices(subject.view());
    std::vector<LevelRecord> levels;
    for (std::size_t i = 0; i < plan.levels.size(); ++i) {
        const auto& [target, pixels] = plan.levels[i];
        levels.push_back({target, pixels, measured[i], indexBytes(subject.view(), made[i].indices),
                          made[i].indices == before, visiblePixels(subject, pixels, measured[i])});
        before = made[i].indices;
    }
    return levels;
}

/// Everything but the times. The generator is warm afterwards.
RunRecord measureOnce(Subject& subject, const std::string& origin, const Configuration& configuration, Peer& generator,
                      const DeviationOptions& options)
{
    RunRecord record;
    record.generator = generator.name();
    const Trial trial = tryInOwnProcess({kPeakCommand, origin, generator.name(), configuration.name});
    record.peakKb = trial.peakKb;
    record.error = trial.trouble;
    if (!record.error.empty())
        return record;
    try {
        const Plan plan = make(subject, configuration, generator).plan;
        const std::vector<PeerLevel> made = plan.levels.empty() ? std::vector<PeerLevel>() : generator.levels(subject);
        generator.reset(subject);
        record.levels = measureMade(subject, plan, made, options);
    } catch (const std::exception& error) {
        record.error = error.what();
    }
    return record;
}

double referenceSeconds(Subject& subject, Peer& reference)
{
    const double start = processorSeconds();
    reference.generate(subject, halvings());
    const double taken = processorSeconds() - start;
    reference.reset(subject);
    return taken;
}

Round timeOnce(Subject& subject, const Configuration& configuration, Peer& generator, Peer& reference)
{
    const double before = configuration.timed ? referenceSeconds(subject, reference) : kUnknown;
    const double start = processorSeconds();
    const Making making = make(subject, configuration, generator);
    const double processor = processorSeconds() - start;
    generator.reset(subject);
    return {making.seconds, making.planning, processor, before};
}

} // namespace

MeshRecord describeMesh(const Subject& subject)
{
    const Result<MeshStatistics> statistics = meshStatistics(subject.view());
    if (!statistics)
        throw std::runtime_error(describe(statistics.error()));
    return {subject.name(),
            meshHash(subject.view()),
            subject.triangles(),
            statistics.value().vertices,
            statistics.value().radius,
            subject.hasNormals(),
            subject.hasUvs()};
}

std::vector<RunRecord> measureTogether(Subject& subject, const std::string& origin, const Configuration& configuration,
                                       const std::vector<Peer*>& generators, const MeasurementOptions& options)
{
    std::vector<RunRecord> records;
    std::vector<std::size_t> able;
    for (Peer* generator : generators) {
        records.push_back(measureOnce(subject, origin, configuration, *generator, options.deviation));
        if (records.back().error.empty())
            able.push_back(records.size() - 1);
    }
    MeshoptPeer reference(kMeshoptimizer);
    const auto once = [&](std::size_t i) {
        std::vector<Round>& rounds = records[able[i]].rounds;
        rounds.push_back(timeOnce(subject, configuration, *generators[able[i]], reference));
        return rounds.back().seconds;
    };
    repeatInTurn(able.size(), configuration.timed ? options.timing : TimingOptions{1, 0.0}, once);
    return records;
}

} // namespace lodsmith::benchmarks
