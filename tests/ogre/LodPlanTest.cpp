#include <support/OgreMeshBuilder.h>
#include <support/OgreSession.h>

#include <lodsmith/ogre/MeshReader.h>
#include <lodsmith/ogre/MeshWriter.h>
#include <lodsmith/ogre/ProgressiveMeshGenerator.h>

#include <OgreCamera.h>
#include <OgreEntity.h>
#include <OgreLodStrategy.h>
#include <OgreMeshManager.h>
#include <OgreMeshSerializer.h>
#include <OgreRoot.h>
#include <OgreSceneManager.h>
#include <OgreSceneNode.h>
#include <OgreSubMesh.h>

#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <limits>

namespace lodsmith::test {
namespace {

/// A configuration whose settings are wrong must be refused before anything is done, and leave the mesh as it was.
class LodPlanTest : public testing::Test {
protected:
    LodPlanTest()
    {
        // Levels that must survive a refusal.
        mMesh->_setLodInfo(2);
        Ogre::MeshLodUsage usage;
        usage.userValue = 3;
        usage.value = 9;
        mMesh->_setLodUsage(1, usage);
        mMesh->_setSubMeshLodFaceList(0, 1, makeIndexData({0, 1, 6}));
        mMesh->buildEdgeList();
    }

    LodConfig config(const std::string& strategy, const std::vector<Ogre::Real>& values) const
    {
        LodConfig config;
        config.mesh = mMesh;
        config.strategy = strategy;
        for (const Ogre::Real value : values)
            config.levels.push_back({value, {}, {}});
        return config;
    }

    void expectRefused(const LodConfig& config, ErrorCode code, const std::string& about)
    {
        const Ogre::IndexData* level = mMesh->getSubMesh(0)->mLodFaceList[0];
        const auto report = ProgressiveMeshGenerator().generateLodLevels(config);
        ASSERT_FALSE(report);
        EXPECT_EQ(report.error().code, code);
        EXPECT_EQ(report.error().file, mMesh->getName());
        EXPECT_THAT(report.error().message, testing::HasSubstr(about));

        EXPECT_EQ(mMesh->getNumLodLevels(), 2);
        EXPECT_EQ(mMesh->getLodLevel(1).userValue, 3);
        EXPECT_EQ(mMesh->getLodStrategy()->getName(), "distance_sphere");
        EXPECT_EQ(mMesh->getSubMesh(0)->mLodFaceList[0], level);
        EXPECT_TRUE(mMesh->isEdgeListBuilt());
    }

    Ogre::MeshPtr makeOther(const std::string& name) { return makeOgreMesh(name, makeTetrahedron()); }

    Ogre::Entity* addEntity(const Ogre::MeshPtr& mesh)
    {
        if (!mScene) {
            mScene = Ogre::Root::getSingleton().createSceneManager();
        }
        Ogre::Entity* entity = mScene->createEntity(mesh);
        mScene->getRootSceneNode()->attachObject(entity);
        return entity;
    }

    OgreSession mSession;
    Ogre::MeshPtr mMesh = makeOgreMesh("mesh", makeGrid(4, 4));
    Ogre::SceneManager* mScene = nullptr;
};

TEST_F(LodPlanTest, AnUnknownStrategyIsRefused)
{
    expectRefused(config("nonsense", {10}), ErrorCode::InvalidSetting, "\"nonsense\"");
    expectRefused(config("", {10}), ErrorCode::InvalidSetting, "strategy");
}

TEST_F(LodPlanTest, ValuesHaveToBePositiveNumbers)
{
    for (const Ogre::Real value : {Ogre::Real(0), Ogre::Real(-1), Ogre::Real(NAN), Ogre::Real(INFINITY)})
        for (const char* strategy : {"distance_sphere", "pixel_count"})
            expectRefused(config(strategy, {value}), ErrorCode::InvalidSetting, "level 1");
}

TEST_F(LodPlanTest, DistancesRiseAndPixelsFall)
{
    for (const char* strategy : {"distance_sphere", "distance_box"}) {
        expectRefused(config(strategy, {20, 10}), ErrorCode::InvalidSetting, "level 2: the value 10 has to be greater");
        expectRefused(config(strategy, {10, 10}), ErrorCode::InvalidSetting, "level 2");
    }
    for (const char* strategy : {"pixel_count", "screen_ratio_pixel_count"}) {
        expectRefused(config(strategy, {10, 20}), ErrorCode::InvalidSetting, "level 2: the value 20 has to be smaller");
        expectRefused(config(strategy, {10, 10}), ErrorCode::InvalidSetting, "level 2");
    }
}

TEST_F(LodPlanTest, ValuesThatTheStrategyCannotTellApartAreRefused)
{
    // Distances are compared as squares, which leave the range of a float before the distances do.
    expectRefused(config("distance_sphere", {Ogre::Real(1e30)}), ErrorCode::InvalidSetting, "level 1");
    expectRefused(config("distance_sphere", {Ogre::Real(1e-30)}), ErrorCode::InvalidSetting, "level 1");
    expectRefused(config("pixel_count", {std::numeric_limits<Ogre::Real>::max()}), ErrorCode::InvalidSetting,
                  "level 1");
}

TEST_F(LodPlanTest, MoreLevelsThanOgreCountsAreRefused)
{
    std::vector<Ogre::Real> values(65535);
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = static_cast<Ogre::Real>(i + 1);
    expectRefused(config("distance_sphere", values), ErrorCode::InvalidSetting, "65534");
}

TEST_F(LodPlanTest, AManualMeshHasToExist)
{
    LodConfig missing = config("distance_sphere", {10, 20});
    missing.levels[1].manualMeshName = "missing.mesh";
    expectRefused(missing, ErrorCode::NotFound, "level 2: there is no mesh \"missing.mesh\"");
    EXPECT_FALSE(Ogre::MeshManager::getSingleton().getByName("missing.mesh", "General"));
}

TEST_F(LodPlanTest, AMeshCannotBeItsOwnLevel)
{
    LodConfig own = config("distance_sphere", {10});
    own.levels[0].manualMeshName = mMesh->getName();
    expectRefused(own, ErrorCode::InvalidSetting, "its own");
}

TEST_F(LodPlanTest, AManualMeshHasNoLevelsOfItsOwn)
{
    const Ogre::MeshPtr other = makeOther("other");
    other->_setLodInfo(2);
    other->_setSubMeshLodFaceList(0, 1, makeIndexData({0, 1, 2}));
    LodConfig nested = config("distance_sphere", {10});
    nested.levels[0].manualMeshName = "other";
    expectRefused(nested, ErrorCode::Unsupported, "levels of its own");
}

TEST_F(LodPlanTest, ManualLevelsAreRefusedWhileAnEntityLives)
{
    const Ogre::MeshPtr other = makeOther("other");
    Ogre::Entity* entity = addEntity(mMesh);
    addEntity(other);
    LodConfig manual = config("distance_sphere", {10});
    manual.levels[0].manualMeshName = "other";
    expectRefused(manual, ErrorCode::Unsupported, "entity");

    mScene->destroyEntity(entity);
    EXPECT_TRUE(MeshWriter::write(manual, MeshReader::read(*mMesh).value(), {}));
    // The mark of manual levels stays on the mesh: entities look for them where generated ones are now.
    addEntity(mMesh);
    const auto report = ProgressiveMeshGenerator().generateLodLevels(config("distance_sphere", {10}));
    ASSERT_FALSE(report);
    EXPECT_EQ(report.error().code, ErrorCode::Unsupported);
    EXPECT_TRUE(mMesh->_isManualLodLevel(1));
}

TEST_F(LodPlanTest, AManualMeshThatCannotBeLoadedIsNamed)
{
    std::ofstream(mSession.directory() / "broken.mesh") << "this is no mesh";
    const Ogre::MeshPtr mesh = mSession.saveAndReload(makeOther("other"));
    LodConfig broken;
    broken.mesh = mesh;
    broken.levels.push_back({10, {}, "broken.mesh"});
    const auto report = ProgressiveMeshGenerator().generateLodLevels(broken);
    ASSERT_FALSE(report);
    EXPECT_EQ(report.error().code, ErrorCode::NotFound);
    EXPECT_THAT(report.error().message, testing::HasSubstr("broken.mesh"));
    EXPECT_EQ(mesh->getNumLodLevels(), 1);
}

} // namespace
} // namespace lodsmith::test
