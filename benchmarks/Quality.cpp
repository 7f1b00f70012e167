#include "Quality.h"

#include <lodsmith/analysis/MeshStatistics.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace lodsmith::benchmarks {

namespace {

std::uint32_t weldedVertices(const MeshView& view)
{
    const Result<MeshStatistics> statistics = meshStatistics(view);
    if (!statistics)
        throw std::runtime_error(describe(statistics.error()));
    return statistics.value().vertices;
}

MeasuredLevel countLevel(const MeshView& view, const PeerLevel& level, std::uint32_t target)
{
    return {target, triangleCount(level.indices), weldedVertices(levelView(view, level.indices)), level.stop, {}};
}

Peer* find(const std::vector<Peer*>& peers, const std::string& name)
{
    const auto found = std::find_if(peers.begin(), peers.end(), [&](Peer* peer) { return peer->name() == name; });
    return found == peers.end() ? nullptr : *found;
}

std::vector<std::uint32_t> triangleCounts(const std::vector<PeerLevel>& levels)
{
    std::vector<std::uint32_t> counts;
    for (const PeerLevel& level : levels)
        counts.push_back(triangleCount(level.indices));
    return counts;
}

std::vector<PeerLevel> makeChain(Peer& peer, Subject& subject, const std::vector<LevelTarget>& targets)
{
    peer.generate(subject, targets);
    std::vector<PeerLevel> levels = peer.levels(subject);
    peer.reset(subject);
    return levels;
}

} // namespace

std::vector<MeasuredLevel> countChain(Peer& peer, Subject& subject)
{
    const std::vector<LevelTarget> targets = halvings();
    const std::vector<PeerLevel> levels = makeChain(peer, subject, targets);
    const std::uint32_t vertices = weldedVertices(subject.view());
    std::vector<MeasuredLevel> counted;
    for (std::size_t i = 0; i < targets.size(); ++i) {
        const auto target = static_cast<std::uint32_t>(std::lround((1.0 - targets[i].amount) * vertices));
        counted.push_back(countLevel(subject.view(), levels[i], target));
    }
    return counted;
}

std::vector<MeasuredLevel> measureLevels(const Subject& subject, const std::vector<PeerLevel>& levels,
                                         const std::vector<std::uint32_t>& targets, const DeviationOptions& options)
{
    std::vector<MeasuredLevel> measured;
    for (std::size_t i = 0; i < levels.size(); ++i) {
        MeasuredLevel& level = measured.emplace_back(countLevel(subject.view(), levels[i], targets[i]));
        if (level.triangles == 0)
            continue;
        const MeshView view = levelView(subject.view(), levels[i].indices);
        const Result<Deviation> deviation = measureDeviation(subject.view(), view, options);
        if (!deviation)
            throw std::runtime_error(describe(deviation.error()));
        level.deviation = deviation.value();
    }
    return measured;
}

MeasuredChains measureAtOgreCounts(const std::vector<Peer*>& peers, Subject& subject, const DeviationOptions& options)
{
    MeasuredChains chains;
    Peer* ogre = find(peers, kOgreCurvature);
    if (!ogre)
        throw std::runtime_error(std::string("quality is measured at the triangle counts of ") + kOgreCurvature);
    const std::vector<PeerLevel> ogreLevels = makeChain(*ogre, subject, halvings());
    const std::vector<std::uint32_t> counts = triangleCounts(ogreLevels);
    chains[kOgreCurvature] = measureLevels(subject, ogreLevels, counts, options);
    for (Peer* peer : peers) {
        if (peer == ogre || peer->name() == kLodsmithCore)
            continue;
        const auto targets = peer->knows(LevelTarget::Kind::Triangles) ? triangleTargets(counts) : halvings();
        chains[peer->name()] = measureLevels(subject, makeChain(*peer, subject, targets), counts, options);
    }
    Peer* ours = find(peers, kLodsmith);
    if (ours && chains.count(kMeshoptimizer)) {
        std::vector<std::uint32_t> theirs;
        for (const MeasuredLevel& level : chains[kMeshoptimizer])
            theirs.push_back(level.triangles);
        chains[kLodsmithAtMeshoptimizer] =
            measureLevels(subject, makeChain(*ours, subject, triangleTargets(theirs)), theirs, options);
    }
    return chains;
}

bool reached(const MeasuredLevel& level)
{
    const double tolerance = std::max(2.0, 0.02 * level.target);
    return level.deviation && std::abs(double(level.triangles) - double(level.target)) <= tolerance;
}

} // namespace lodsmith::benchmarks
