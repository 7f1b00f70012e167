#include "LodsmithPeer.h"

#include "StoredLevels.h"

#include <chrono>
#include <stdexcept>

namespace lodsmith::benchmarks {

LodConfig levelsAtDistances(const Ogre::MeshPtr& mesh, const std::vector<LevelTarget>& targets)
{
    LodConfig config;
    config.mesh = mesh;
    Ogre::Real distance = 0;
    for (const LevelTarget& target : targets)
        config.levels.push_back({distance += 100, target, ""});
    return config;
}

namespace {

void letChoose(LodConfig& config, const Plan& plan)
{
    config.strategy = "pixel_count";
    for (std::size_t i = 0; i < plan.levels.size(); ++i)
        config.levels[i].value = static_cast<Ogre::Real>(plan.levels[i].pixels);
    config.mostLevels = plan.mostLevels;
}

} // namespace

double LodsmithPeer::generate(Subject& subject, const Plan& plan)
{
    LodConfig config = levelsAtDistances(subject.mesh(), targetsOf(plan));
    if (plan.mostLevels > 0)
        letChoose(config, plan);
    config.options = mOptions;

    const auto start = std::chrono::steady_clock::now();
    Result<LodReport> report = ProgressiveMeshGenerator().generateLodLevels(config);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;

    if (!report)
        throw std::runtime_error(name() + ": " + describe(report.error()));
    mReport = std::move(report).value();
    return taken.count() - mReport.orderSeconds;
}

std::vector<PeerLevel> LodsmithPeer::levels(const Subject& subject) const
{
    std::vector<bool> skipped;
    for (const LodLevelReport& level : mReport.levels)
        skipped.push_back(level.skipped);
    std::vector<PeerLevel> levels = storedLevels(subject, skipped);
    for (std::size_t i = 0; i < levels.size(); ++i)
        levels[i].stop = stopWord(mReport.levels[i].stop);
    return levels;
}

} // namespace lodsmith::benchmarks
