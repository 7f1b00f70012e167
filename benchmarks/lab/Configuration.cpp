#include "Configuration.h"

#include <lodsmith/analysis/LevelChoice.h>
#include <lodsmith/core/Simplify.h>
#include <lodsmith/ogre/AutomaticLods.h>

#include <chrono>
#include <cmath>
#include <memory>
#include <stdexcept>

namespace lodsmith::benchmarks {

namespace {

using Targets = std::vector<LevelTarget>;

std::function<bool(const Peer&)> whoKnows(LevelTarget::Kind kind)
{
    return [kind](const Peer& generator) { return generator.knows(kind); };
}

/// Levels that nobody has said when to show.
Plan anywhere(const Targets& targets)
{
    Plan plan;
    for (const LevelTarget& target : targets)
        plan.push_back({target, 0.0});
    return plan;
}

/// pixel_count of a disc of so many pixels in radius.
double pixelsOfRadius(double radius)
{
    constexpr double kPi = 3.14159265358979323846;
    return kPi * radius * radius;
}

Plan planAutomatic(Subject& subject, const Peer& generator)
{
    AutomaticLods automatic;
    automatic.metric = generator.options()->metric;
    const LodConfig config = automaticLodConfig(subject.mesh(), automatic);
    Targets targets;
    for (const LodLevel& level : config.levels)
        targets.push_back(level.target);
    const Result<LodChain> chain = simplify(subject.view(), targets, *generator.options());
    if (!chain)
        throw std::runtime_error(describe(chain.error()));
    std::vector<LevelCandidate> candidates;
    for (std::size_t i = 0; i < targets.size(); ++i)
        candidates.push_back({std::sqrt(double(config.levels[i].value)), chain.value().levels[i].triangles});
    Plan plan;
    for (const std::size_t i : chooseLevels(subject.triangles(), candidates, config.mostLevels))
        plan.push_back({targets[i], double(config.levels[i].value)});
    return plan;
}

/// The formula of 2012, which is OGRE's own autoconfiguration too.
Plan planClassic(Subject& subject, const Peer&)
{
    const double radius = subject.mesh()->getBoundingSphereRadius();
    Plan plan;
    for (const double i : {2.0, 3.0, 4.0, 5.0})
        plan.push_back(
            {{LevelTarget::Kind::CollapseCost, radius * std::pow(i, 5) / 100000.0}, 3388608.0 / std::pow(i, 4)});
    return plan;
}

Plan planPlain(Subject& subject, const Peer&)
{
    constexpr double kFullHeight = 540.0; // half of 1080
    Plan plan;
    for (const double share : {0.5, 0.25, 0.125}) {
        const LevelTarget target{LevelTarget::Kind::Triangles, std::floor(share * subject.triangles())};
        plan.push_back({target, pixelsOfRadius(share * kFullHeight)});
    }
    return plan;
}

/// The triangle counts at which another generator's halvings arrive, found once a mesh.
class ArrivalCounts {
public:
    explicit ArrivalCounts(std::unique_ptr<Peer> reference) : mReference(std::move(reference)) {}

    Plan plan(Subject& subject, const Peer& generator)
    {
        // Who knows no such target takes part where it arrives at the same count by itself.
        if (!generator.knows(LevelTarget::Kind::Triangles))
            return anywhere(halvings());
        if (mMesh != subject.mesh())
            find(subject);
        return anywhere(triangleTargets(mCounts));
    }

private:
    void find(Subject& subject)
    {
        mReference->generate(subject, halvings());
        mCounts.clear();
        for (const PeerLevel& level : mReference->levels(subject))
            mCounts.push_back(triangleCount(level.indices));
        mReference->reset(subject);
        mMesh = subject.mesh();
    }

    std::unique_ptr<Peer> mReference;
    Ogre::MeshPtr mMesh; // kept, so that no other mesh can be at its address
    std::vector<std::uint32_t> mCounts;
};

Configuration atCountsOf(const std::string& reference)
{
    const auto counts = std::make_shared<ArrivalCounts>(makePeer(reference));
    Configuration configuration;
    configuration.name = reference + "-counts";
    configuration.rule =
        "triangle counts at which " + reference + " arrives with 50, 75, 87.5 and 93.75% of the vertices removed";
    // The core's shapes are those of kLodsmith.
    configuration.suits = [](const Peer& generator) { return generator.name() != kLodsmithCore; };
    configuration.plan = [counts](Subject& subject, const Peer& generator) { return counts->plan(subject, generator); };
    configuration.timed = false;
    return configuration;
}

} // namespace

std::vector<Configuration> makeConfigurations()
{
    return {
        {kHalvings, "50, 75, 87.5 and 93.75% of the vertices removed", whoKnows(LevelTarget::Kind::Proportional),
         [](Subject&, const Peer&) { return anywhere(halvings()); }},
        {kAutomatic, "what the library does by itself, with the generator's metric",
         [](const Peer& generator) { return generator.options() != nullptr; }, planAutomatic},
        {kClassic, "i = 2..5: 3388608 / i^4 pixels, collapse cost radius * i^5 / 100000",
         whoKnows(LevelTarget::Kind::CollapseCost), planClassic},
        {"plain", "50, 25 and 12.5% of the triangles at 1/2, 1/4 and 1/8 of a height of 1080 pixels",
         whoKnows(LevelTarget::Kind::Triangles), planPlain},
        atCountsOf(kOgreCurvature),
        atCountsOf(kMeshoptimizer),
    };
}

Making make(Subject& subject, const Configuration& configuration, Peer& generator)
{
    const auto start = std::chrono::steady_clock::now();
    Plan plan = configuration.plan(subject, generator);
    const std::chrono::duration<double> planning = std::chrono::steady_clock::now() - start;
    Targets targets;
    for (const PlannedLevel& level : plan)
        targets.push_back(level.target);
    const double seconds = generator.generate(subject, targets);
    return {std::move(plan), planning.count(), planning.count() + seconds};
}

} // namespace lodsmith::benchmarks
