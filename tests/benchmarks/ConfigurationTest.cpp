#include "Configuration.h"

#include "../../benchmarks/OgreSession.h"
#include "../../benchmarks/Quality.h"
#include "../../benchmarks/StoredLevels.h"

#include <lodsmith/ogre/ProgressiveMeshGenerator.h>

#include <OgreLodConfig.h>
#include <OgreMeshLodGenerator.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace lodsmith::benchmarks {

namespace {

const Configuration& find(const std::vector<Configuration>& all, const std::string& name)
{
    for (const Configuration& configuration : all)
        if (configuration.name == name)
            return configuration;
    throw std::runtime_error(name + " is missing");
}

class ConfigurationTest : public testing::Test {
protected:
    Plan planOf(const std::string& configuration, const std::string& generator)
    {
        return find(mAll, configuration).plan(*mSubject, *makePeer(generator));
    }

    bool suits(const std::string& configuration, const std::string& generator) const
    {
        return find(mAll, configuration).suits(*makePeer(generator));
    }

    const OgreSession mSession;
    std::vector<Configuration> mAll = makeConfigurations();
    std::unique_ptr<Subject> mSubject = sourceFrom("planet-1k").load();
};

TEST_F(ConfigurationTest, theClassicOneIsOgresOwnAutoconfiguration)
{
    Ogre::LodConfig ogre;
    Ogre::MeshPtr mesh = mSubject->mesh();
    Ogre::MeshLodGenerator::getSingleton().getAutoconfig(mesh, ogre);
    const Plan plan = planOf("classic", kOgreCurvature);
    ASSERT_EQ(plan.levels.size(), ogre.levels.size());
    for (std::size_t i = 0; i < plan.levels.size(); ++i) {
        EXPECT_EQ(ogre.levels[i].reductionMethod, Ogre::LodLevel::VRM_COLLAPSE_COST);
        EXPECT_EQ(plan.levels[i].target.kind, LevelTarget::Kind::CollapseCost);
        EXPECT_NEAR(plan.levels[i].target.amount, ogre.levels[i].reductionValue, 1e-5 * ogre.levels[i].reductionValue);
        EXPECT_NEAR(plan.levels[i].pixels, ogre.levels[i].distance, 1e-5 * ogre.levels[i].distance);
    }
}

TEST_F(ConfigurationTest, nobodyIsAskedForWhatTheyDoNotKnow)
{
    EXPECT_FALSE(suits("automatic", kOgreCurvature));
    EXPECT_FALSE(suits("automatic", kMeshoptimizer));
    EXPECT_FALSE(suits("classic", "ogre-quadric")); // whose costs are no lengths
    EXPECT_FALSE(suits("plain", kOgreCurvature));
    EXPECT_TRUE(suits("plain", kMeshoptimizer));
    EXPECT_TRUE(suits("automatic", kLodsmith));
    EXPECT_TRUE(suits("automatic", kLodsmithCurvature));
    for (const std::unique_ptr<Peer>& peer : makePeers())
        EXPECT_TRUE(suits("halvings", peer->name())) << peer->name();
}

TEST_F(ConfigurationTest, theAutomaticOneMakesWhatTheLibraryMakes)
{
    const Ogre::MeshPtr mesh = mSubject->mesh();
    const Result<LodReport> report = ProgressiveMeshGenerator().generateAutoconfiguredLodLevels(mesh);
    ASSERT_TRUE(report);
    std::vector<LevelIndices> stored;
    for (unsigned short level = 1; level < mesh->getNumLodLevels(); ++level)
        stored.push_back(mSubject->storedLevel(level));
    mSubject->removeLevels();
    ASSERT_GT(stored.size(), 2U);

    const std::unique_ptr<Peer> ours = makePeer(kLodsmith);
    make(*mSubject, find(mAll, "automatic"), *ours);
    std::vector<LevelIndices> made;
    for (const PeerLevel& level : ours->levels(*mSubject))
        if (level.indices != (made.empty() ? originalIndices(mSubject->view()) : made.back()))
            made.push_back(level.indices);
    ours->reset(*mSubject);
    EXPECT_EQ(made, stored);
}

TEST_F(ConfigurationTest, likeTheClassicOneItMayBeAsFarOffAsThatOneIs)
{
    const std::unique_ptr<Peer> ours = makePeer(kLodsmith);
    const auto most = [&](const char* name, const std::unique_ptr<Peer>& peer) {
        const Plan plan = make(*mSubject, find(mAll, name), *peer).plan;
        const std::vector<MeasuredLevel> levels = measureLevels(*mSubject, peer->levels(*mSubject), {});
        peer->reset(*mSubject);
        double pixels = 0.0;
        for (std::size_t i = 0; i < levels.size(); ++i)
            pixels = std::max(pixels, visiblePixels(*mSubject, plan.levels[i].pixels, levels[i]));
        return pixels;
    };
    const double classic = most("classic", makePeer(kLodsmithCurvature));
    const double alike = most("automatic-like-classic", ours);
    EXPECT_LE(alike, classic);
    EXPECT_GT(alike, most("automatic", ours));
}

TEST_F(ConfigurationTest, thePlainOneHalvesTrianglesAsTheMeshHalvesItsSize)
{
    const Plan plan = planOf("plain", kLodsmith);
    ASSERT_EQ(plan.levels.size(), 3U);
    double share = 0.5;
    for (const PlannedLevel& level : plan.levels) {
        EXPECT_NEAR(level.target.amount, share * mSubject->triangles(), 1.0);
        EXPECT_NEAR(std::sqrt(level.pixels / std::acos(-1.0)), share * 540.0, 1e-9);
        share /= 2.0;
    }
}

TEST_F(ConfigurationTest, atTheCountsOfAnotherEverybodyArrivesWhereThatOneDoes)
{
    const Configuration& configuration = find(mAll, "ogre-curvature-counts");
    const std::unique_ptr<Peer> ogre = makePeer(kOgreCurvature), ours = makePeer(kLodsmith);
    make(*mSubject, configuration, *ogre);
    const std::vector<PeerLevel> theirs = ogre->levels(*mSubject);
    ogre->reset(*mSubject);
    make(*mSubject, configuration, *ours);
    const std::vector<PeerLevel> levels = ours->levels(*mSubject);
    ours->reset(*mSubject);
    ASSERT_EQ(levels.size(), theirs.size());
    for (std::size_t i = 0; i < levels.size(); ++i)
        EXPECT_NEAR(triangleCount(levels[i].indices), triangleCount(theirs[i].indices), 2.0);
}

TEST_F(ConfigurationTest, levelsThatAnotherDoesNotReachAreNotCompared)
{
    const std::unique_ptr<Subject> cottage = chosenSubjects({"cottage"}).at(0).load(); // full of seams
    const std::unique_ptr<Peer> ours = makePeer(kLodsmith);
    const Making making = make(*cottage, find(mAll, "meshoptimizer-counts"), *ours);
    EXPECT_TRUE(making.plan.levels.empty());
    EXPECT_EQ(cottage->mesh()->getNumLodLevels(), 1);
    EXPECT_EQ(planOf("meshoptimizer-counts", kLodsmith).levels.size(), 4U);
}

TEST_F(ConfigurationTest, namesAndRulesAreUnique)
{
    std::set<std::string> names, rules;
    for (const Configuration& configuration : mAll) {
        names.insert(configuration.name);
        rules.insert(configuration.rule);
    }
    EXPECT_EQ(names.size(), mAll.size());
    EXPECT_EQ(rules.size(), mAll.size());
}

} // namespace

} // namespace lodsmith::benchmarks
