#include "OgrePeer.h"

#include "StoredLevels.h"

#include <OgreDistanceLodStrategy.h>
#include <OgreLodCollapseCostQuadric.h>
#include <OgreLodConfig.h>
#include <OgreMeshLodGenerator.h>

#include <chrono>

namespace lodsmith::benchmarks {

namespace {

Ogre::LodLevel::VertexReductionMethod methodFor(LevelTarget::Kind kind)
{
    return kind == LevelTarget::Kind::CollapseCost ? Ogre::LodLevel::VRM_COLLAPSE_COST
                                                   : Ogre::LodLevel::VRM_PROPORTIONAL;
}

} // namespace

double OgrePeer::generate(Subject& subject, const Plan& plan)
{
    Ogre::MeshPtr mesh = subject.mesh();
    Ogre::LodConfig config(mesh, Ogre::DistanceLodSphereStrategy::getSingletonPtr());
    config.advanced.useBackgroundQueue = false;
    Ogre::Real distance = 0;
    for (const LevelTarget& target : targetsOf(plan))
        config.createGeneratedLodLevel(distance += 100, Ogre::Real(target.amount), methodFor(target.kind));

    const auto start = std::chrono::steady_clock::now();
    Ogre::LodCollapseCostPtr cost;
    if (mCost == Cost::Quadric)
        cost.reset(new Ogre::LodCollapseCostQuadric());
    Ogre::MeshLodGenerator::getSingleton().generateLodLevels(config, cost);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;

    mSkipped.clear();
    for (const Ogre::LodLevel& level : config.levels)
        mSkipped.push_back(level.outSkipped);
    return taken.count();
}

std::vector<PeerLevel> OgrePeer::levels(const Subject& subject) const
{
    return storedLevels(subject, mSkipped);
}

} // namespace lodsmith::benchmarks
