#include "Configuration.h"

#include "../Quality.h"

#include <lodsmith/ogre/AutomaticLods.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>

namespace lodsmith::benchmarks {

namespace {

std::function<bool(const Peer&)> whoKnows(LevelTarget::Kind kind)
{
    return [kind](const Peer& generator) { return generator.knows(kind); };
}

/// Whether somebody would use the generator's levels as they are. The core's are those of kLodsmith, and positions only are
/// there for what attributes cost.
bool isForUse(const Peer& generator)
{
    return generator.name() != kLodsmithCore && generator.name() != kLodsmithPositions;
}

std::function<bool(const Peer&)> whoMayUse(LevelTarget::Kind kind)
{
    return [kind](const Peer& generator) { return isForUse(generator) && generator.knows(kind); };
}

bool isLodsmith(const Peer& generator)
{
    return generator.name() == kLodsmith;
}

/// pixel_count of a disc of so many pixels in radius.
double pixelsOfRadius(double radius)
{
    constexpr double kPi = 3.14159265358979323846;
    return kPi * radius * radius;
}

/// What the library does by itself, with the generator's metric.
Plan planAutomatic(Subject& subject, const Peer& generator, double pixels)
{
    AutomaticLods automatic;
    automatic.metric = generator.options()->metric;
    automatic.pixels = pixels;
    const LodConfig config = automaticLodConfig(subject.mesh(), automatic);
    Plan plan;
    for (const LodLevel& level : config.levels)
        plan.levels.push_back({level.target, double(level.value)});
    plan.mostLevels = config.mostLevels;
    return plan;
}

Plan planCandidates(Subject& subject, const Peer& generator)
{
    Plan plan = planAutomatic(subject, generator, 1.0);
    plan.mostLevels = 0;
    return plan;
}

/// The formula of 2012, which is OGRE's own autoconfiguration too.
Plan planClassic(Subject& subject, const Peer&)
{
    const double radius = subject.mesh()->getBoundingSphereRadius();
    Plan plan;
    for (const double i : {2.0, 3.0, 4.0, 5.0})
        plan.levels.push_back(
            {{LevelTarget::Kind::CollapseCost, radius * std::pow(i, 5) / 100000.0}, 3388608.0 / std::pow(i, 4)});
    return plan;
}

Plan planPlain(Subject& subject, const Peer&)
{
    constexpr double kFullHeight = 540.0; // half of 1080
    Plan plan;
    for (const double share : {0.5, 0.25, 0.125}) {
        const LevelTarget target{LevelTarget::Kind::Triangles, std::floor(share * subject.triangles())};
        plan.levels.push_back({target, pixelsOfRadius(share * kFullHeight)});
    }
    return plan;
}

/// The triangle counts at which another generator's halvings arrive, as long as that is where they were to go; found once a
/// mesh.
class ArrivalCounts {
public:
    explicit ArrivalCounts(std::unique_ptr<Peer> reference) : mReference(std::move(reference)) {}

    Plan plan(Subject& subject, const Peer& generator)
    {
        // Who knows no such target takes part where it arrives at the same count by itself.
        if (!generator.knows(LevelTarget::Kind::Triangles))
            return halvings();
        if (mMesh != subject.mesh())
            find(subject);
        return atTriangles(mCounts);
    }

private:
    void find(Subject& subject)
    {
        mReference->generate(subject, halvings());
        mCounts.clear();
        const Plan plan = halvings();
        const std::vector<PeerLevel> levels = mReference->levels(subject);
        for (std::size_t i = 0; i < levels.size() && arrives(levels[i], plan.levels[i], subject); ++i)
            mCounts.push_back(triangleCount(levels[i].indices));
        mReference->reset(subject);
        mMesh = subject.mesh();
    }

    /// A target of vertices is met by what knows no triangles; the others may stop before.
    bool arrives(const PeerLevel& level, const PlannedLevel& planned, const Subject& subject) const
    {
        constexpr double kTolerance = 1.02;
        return !mReference->knows(LevelTarget::Kind::Triangles)
               || triangleCount(level.indices)
                      <= 2.0 + kTolerance * (1.0 - planned.target.amount) * subject.triangles();
    }

    std::unique_ptr<Peer> mReference;
    Ogre::MeshPtr mMesh; // kept, so that no other mesh can be at its address
    std::vector<std::uint32_t> mCounts;
};

/// The greatest error that levels of the formula of 2012 have on a mesh when they appear, found once a mesh.
class ClassicError {
public:
    double pixels(Subject& subject)
    {
        if (mMesh != subject.mesh())
            find(subject);
        return mPixels;
    }

private:
    void find(Subject& subject)
    {
        const Plan plan = planClassic(subject, *mClassic);
        mClassic->generate(subject, plan);
        const std::vector<MeasuredLevel> levels = measureLevels(subject, mClassic->levels(subject), kFewSamples);
        mClassic->reset(subject);
        mPixels = AutomaticLods::kMinPixels;
        for (std::size_t i = 0; i < levels.size(); ++i)
            if (levels[i].deviation)
                mPixels = std::max(mPixels, visiblePixels(subject, plan.levels[i].pixels, levels[i]));
        mPixels = std::min(mPixels, AutomaticLods::kMaxPixels);
        mMesh = subject.mesh();
    }

    std::unique_ptr<Peer> mClassic = makePeer(kLodsmithCurvature);
    Ogre::MeshPtr mMesh; // kept, so that no other mesh can be at its address
    double mPixels = 0.0;
};

Configuration automaticLikeClassic()
{
    const auto error = std::make_shared<ClassicError>();
    Configuration configuration;
    configuration.name = "automatic-like-classic";
    configuration.rule = "automatic, where as many pixels are allowed as a classic level of the mesh is off at most";
    configuration.suits = isLodsmith;
    configuration.plan = [error](Subject& subject, const Peer& generator) {
        return planAutomatic(subject, generator, error->pixels(subject));
    };
    configuration.timed = false;
    return configuration;
}

Configuration atCountsOf(const std::string& reference)
{
    const auto counts = std::make_shared<ArrivalCounts>(makePeer(reference));
    Configuration configuration;
    configuration.name = reference + "-counts";
    configuration.rule =
        "triangle counts at which " + reference + " arrives with 50, 75, 87.5 and 93.75% of the vertices removed";
    if (makePeer(reference)->knows(LevelTarget::Kind::Triangles))
        configuration.rule += ", until it stops before what was asked";
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
         [](Subject&, const Peer&) { return halvings(); }},
        {kAutomatic, "what the library does by itself, with the generator's metric",
         [](const Peer& generator) { return isForUse(generator) && generator.chooses(); },
         [](Subject& subject, const Peer& generator) { return planAutomatic(subject, generator, 1.0); }},
        {kCandidates, "the levels among which the library chooses", isLodsmith, planCandidates},
        {kClassic, "i = 2..5: 3388608 / i^4 pixels, collapse cost radius * i^5 / 100000",
         whoMayUse(LevelTarget::Kind::CollapseCost), planClassic},
        {"plain", "50, 25 and 12.5% of the triangles at 1/2, 1/4 and 1/8 of a height of 1080 pixels",
         whoMayUse(LevelTarget::Kind::Triangles), planPlain},
        automaticLikeClassic(),
        atCountsOf(kOgreCurvature),
        atCountsOf(kMeshoptimizer),
    };
}

Making make(Subject& subject, const Configuration& configuration, Peer& generator)
{
    const auto start = std::chrono::steady_clock::now();
    Plan plan = configuration.plan(subject, generator);
    const std::chrono::duration<double> planning = std::chrono::steady_clock::now() - start;
    const double seconds = plan.levels.empty() ? 0.0 : generator.generate(subject, plan);
    return {std::move(plan), planning.count(), planning.count() + seconds};
}

} // namespace lodsmith::benchmarks
