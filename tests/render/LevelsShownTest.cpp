#include "RenderTest.h"

#include <support/MeshBuilders.h>
#include <support/OgreMeshBuilder.h>

#include <lodsmith/ogre/ProgressiveMeshGenerator.h>

#include <OgreCamera.h>
#include <OgreEntity.h>
#include <OgreLodListener.h>
#include <OgreLodStrategy.h>
#include <OgreSceneManager.h>
#include <OgreSceneNode.h>
#include <OgreSubMesh.h>
#include <OgreViewport.h>

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <ostream>
#include <set>
#include <string>
#include <vector>

namespace lodsmith::test {
namespace {

/// The level that each entity had in the last frame, as OGRE tells its listeners.
class LevelRecord : public Ogre::LodListener {
public:
    bool prequeueEntityMeshLodChanged(Ogre::EntityMeshLodChangedEvent& event) override
    {
        mLevels[event.entity] = event.newLodIndex;
        return false;
    }

    int of(Ogre::Entity& entity) const { return mLevels.at(&entity); }
    void forget() { mLevels.clear(); }

private:
    std::map<Ogre::Entity*, int> mLevels;
};

/// The triangles that an entity draws of a level.
std::size_t trianglesOf(const Ogre::Mesh& mesh, int level)
{
    std::size_t indices = 0;
    if (level > 0 && !mesh.getLodLevel(level).manualName.empty())
        return trianglesOf(*mesh.getLodLevel(level).manualMesh, 0);
    for (const Ogre::SubMesh* subMesh : mesh.getSubMeshes())
        indices += level == 0 ? subMesh->indexData->indexCount : subMesh->mLodFaceList[level - 1]->indexCount;
    return indices / 3;
}

/// Entities that a camera goes away from, up to the horizon, and comes back to.
class LevelsShownTest : public RenderTest {
protected:
    LevelsShownTest() : RenderTest(1280, 1024) {}

    void SetUp() override
    {
        RenderTest::SetUp();
        if (!mSession)
            return;
        mSession->camera().setFOVy(Ogre::Degree(90));
        mSession->scene().addLodListener(&mRecord);
    }

    void TearDown() override { mMeshes.clear(); }

    Ogre::MeshPtr model(const std::string& name)
    {
        return mSession->load(LODSMITH_MEDIA_DIR "/" + name + "/" + name + ".mesh");
    }

    static void generate(const LodConfig& config)
    {
        const auto report = ProgressiveMeshGenerator().generateLodLevels(config);
        ASSERT_TRUE(report) << describe(report.error());
        if (config.mostLevels > 0) { // some of them
            ASSERT_GE(config.mesh->getNumLodLevels(), 4);
            return;
        }
        ASSERT_EQ(config.mesh->getNumLodLevels(), config.levels.size() + 1);
        for (std::size_t i = 0; i < config.levels.size(); ++i)
            ASSERT_EQ(config.mesh->getLodLevel(i + 1).userValue, config.levels[i].value);
    }

    /// Shows a mesh as large as if its bounding radius were 1, behind those that are there.
    void show(const Ogre::MeshPtr& mesh)
    {
        Ogre::Entity& entity = mSession->show(mesh, {0, 0, -0.3f * static_cast<float>(mEntities.size())});
        entity.getParentSceneNode()->setScale(Ogre::Vector3(1.0f / mesh->getBoundingSphereRadius()));
        mMeshes.push_back(mesh);
        mEntities.push_back(&entity);
    }

    /// What each of OGRE's strategies is said to measure; larger where the camera is farther away.
    double farness(const Ogre::Entity& entity) const
    {
        const Ogre::Vector3 camera = mSession->cameraNode()._getDerivedPosition();
        const double distance = (entity.getParentNode()->_getDerivedPosition() - camera).length();
        const double radius = entity.getBoundingRadiusScaled();
        const Ogre::String& strategy = entity.getMesh()->getLodStrategy()->getName();
        if (strategy == "distance_sphere")
            return std::sqrt(distance * distance - radius * radius);
        if (strategy == "distance_box")
            return std::sqrt(entity.getWorldBoundingBox().squaredDistance(camera));
        const Ogre::Viewport& viewport = mSession->viewport();
        const double onScreen = radius * viewport.getActualHeight() / 2.0 / distance; // at 90 degrees
        const double pixels = 3.14159265358979323846 * onScreen * onScreen;
        return strategy == "pixel_count"
                   ? -pixels
                   : -pixels / (static_cast<double>(viewport.getActualWidth()) * viewport.getActualHeight());
    }

    int expectedLevel(const Ogre::Entity& entity) const
    {
        const Ogre::Mesh& mesh = *entity.getMesh();
        const double sign = mesh.getLodStrategy()->getName().compare(0, 8, "distance") == 0 ? 1.0 : -1.0;
        int level = 0;
        while (level + 1 < mesh.getNumLodLevels()
               && farness(entity) >= sign * mesh.getLodLevel(static_cast<Ogre::ushort>(level + 1)).userValue)
            ++level;
        return level;
    }

    /// Draws a frame and compares what it showed.
    void expectLevelsAt(double distance)
    {
        SCOPED_TRACE("from a distance of " + std::to_string(distance));
        mSession->cameraNode().setPosition(0, 0, static_cast<Ogre::Real>(distance));
        mRecord.forget();
        const std::size_t drawn = mSession->frame().triangleCount;
        std::size_t triangles = 0;
        for (Ogre::Entity* entity : mEntities) {
            const int level = expectedLevel(*entity);
            EXPECT_EQ(mRecord.of(*entity), level) << entity->getMesh()->getName();
            triangles += trianglesOf(*entity->getMesh(), level);
            mSeen[entity].insert(level);
        }
        EXPECT_EQ(drawn, triangles);
    }

    /// @param nearest level that the way begins with
    void expectLevelsOnTheWay(int nearest = 0)
    {
        std::vector<double> way;
        for (double distance = 1.2; distance < 500.0; distance *= 1.13)
            way.push_back(distance);
        way.insert(way.end(), way.rbegin(), way.rend());
        for (const double distance : way)
            expectLevelsAt(distance);
        for (Ogre::Entity* entity : mEntities)
            EXPECT_EQ(mSeen[entity].size(), std::size_t(entity->getMesh()->getNumLodLevels() - nearest))
                << entity->getMesh()->getName();
    }

    std::vector<Ogre::MeshPtr> mMeshes;
    std::vector<Ogre::Entity*> mEntities;
    std::map<Ogre::Entity*, std::set<int>> mSeen;
    LevelRecord mRecord;
};

struct Strategy {
    std::string name;
    std::vector<Ogre::Real> values;
};

void PrintTo(const Strategy& strategy, std::ostream* stream)
{
    *stream << strategy.name;
}

class StrategyTest : public LevelsShownTest, public testing::WithParamInterface<Strategy> {};

TEST_P(StrategyTest, EachEntityShowsItsLevelUpToTheHorizonAndBack)
{
    const double removed[] = {0.4, 0.7, 0.9};
    std::vector<Ogre::MeshPtr> meshes;
    for (const char* name : {"tree", "cottage", "lantern", "drake"})
        meshes.push_back(model(name));
    meshes.push_back(makeOgreMesh("ball", makeUvSphere(40, 30)));
    makeOgreMesh("hand-made ball", makeIcosphere(1));
    for (const Ogre::MeshPtr& mesh : meshes) {
        LodConfig config;
        config.mesh = mesh;
        config.strategy = GetParam().name;
        for (std::size_t i = 0; i < GetParam().values.size(); ++i)
            config.levels.push_back({GetParam().values[i], {LevelTarget::Kind::Proportional, removed[i]}, {}});
        if (mesh->getName() == "ball")
            config.levels[1].manualMeshName = "hand-made ball";
        generate(config);
        show(mesh);
    }
    expectLevelsOnTheWay();
}

INSTANTIATE_TEST_SUITE_P(Ogre, StrategyTest,
                         testing::Values(Strategy{"distance_sphere", {5, 25, 120}},
                                         Strategy{"distance_box", {5, 25, 120}},
                                         Strategy{"pixel_count", {9000, 300, 12}},
                                         Strategy{"screen_ratio_pixel_count", {0.03f, 0.001f, 0.00004f}}),
                         [](const auto& strategy) { return strategy.param.name; });

TEST_F(LevelsShownTest, AutomaticLevelsAppearOneAfterTheOther)
{
    for (const char* name : {"cottage", "drake"}) {
        const Ogre::MeshPtr mesh = model(name);
        generate(automaticLodConfig(mesh));
        show(mesh);
    }
    expectLevelsOnTheWay(1); // the first appears when the mesh is larger than this window
}

} // namespace
} // namespace lodsmith::test
