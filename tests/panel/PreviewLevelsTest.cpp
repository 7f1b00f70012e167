#include "PreviewFixture.h"

#include <support/MeshBuilders.h>
#include <support/OgreMeshBuilder.h>

#include <lodsmith/ogre/ProgressiveMeshGenerator.h>

#include <OgreCamera.h>
#include <OgreEntity.h>
#include <OgreLodStrategy.h>
#include <OgreLodStrategyManager.h>
#include <OgreMeshManager.h>
#include <OgreRoot.h>
#include <OgreSceneManager.h>
#include <OgreSubMesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <ostream>

namespace lodsmith::test {
namespace {

std::size_t trianglesOf(const Ogre::Mesh& mesh, unsigned level)
{
    std::size_t indices = 0;
    for (const Ogre::SubMesh* part : mesh.getSubMeshes())
        indices += (level == 0 ? part->indexData : part->mLodFaceList[level - 1])->indexCount;
    return indices / 3;
}

class PreviewLevelsTest : public PreviewFixture {
protected:
    void expectShown(const Ogre::MeshPtr& mesh, unsigned level)
    {
        frame();
        EXPECT_EQ(mPreview->shownLevel(), level);
        EXPECT_EQ(mPreview->triangles(), trianglesOf(*mesh, level));
    }

    Picture pictureOfLevel(std::optional<unsigned> level)
    {
        mPreview->compare(CompareMode::Off, 0, 0);
        mPreview->setLevel(level);
        return picture();
    }
};

TEST_F(PreviewLevelsTest, ForcedLevelIsShown)
{
    const Ogre::MeshPtr mesh = model("drake");
    show(mesh);
    for (const unsigned level : {0u, 3u, 1u, 2u}) {
        mPreview->setLevel(level);
        expectShown(mesh, level);
    }
    mPreview->setLevel(77);
    expectShown(mesh, 3);
    EXPECT_EQ(mPreview->level(), 77u);
}

TEST_F(PreviewLevelsTest, CameraDecidesWhenNoneIsForced)
{
    const Ogre::MeshPtr mesh = model("cottage");
    show(mesh);
    mPreview->setLevel(2);
    expectShown(mesh, 2);
    mPreview->setLevel({});
    mPreview->zoom(100);
    expectShown(mesh, 0);
    mPreview->zoom(-60);
    expectShown(mesh, 3);
}

TEST_F(PreviewLevelsTest, LevelsThatComeAndGoAreDrawn)
{
    const Ogre::MeshPtr mesh = model("cottage");
    show(mesh);
    mPreview->setLevel(3);
    expectShown(mesh, 3);
    EXPECT_FALSE(frame());
    ASSERT_TRUE(ProgressiveMeshGenerator().generateLodLevels(proportional(mesh, {0.3, 0.6, 0.9})));
    expectShown(mesh, 3);
    EXPECT_FALSE(frame());
    ASSERT_TRUE(ProgressiveMeshGenerator().generateLodLevels(proportional(mesh, {0.9})));
    expectShown(mesh, 1);
    mesh->freeEdgeList();
    mesh->removeLodLevels();
    expectShown(mesh, 0);
    ASSERT_TRUE(ProgressiveMeshGenerator().generateLodLevels(proportional(mesh, {0.3, 0.6, 0.9})));
    expectShown(mesh, 3);
}

TEST_F(PreviewLevelsTest, SameCountsElsewhereAreAChangeToo)
{
    const Ogre::MeshPtr mesh = model("cottage", {0.5});
    show(mesh);
    frame();
    LodConfig config = proportional(mesh, {0.5});
    config.levels[0].value = 11;
    ASSERT_TRUE(ProgressiveMeshGenerator().generateLodLevels(config));
    EXPECT_TRUE(frame());
}

TEST_F(PreviewLevelsTest, HandMadeLevelsReachThePlayingMesh)
{
    const Ogre::MeshPtr mesh = model("drake", {0.5});
    makeOgreMesh("ball", makeIcosphere(2))->clone("hand-made", mesh->getGroup());
    show(mesh);
    const std::string animation = mPreview->animations().at(0);
    ASSERT_TRUE(mPreview->play(animation));
    mPreview->setLevel(2);
    frame(0.1f);
    LodConfig config = proportional(mesh, {0.5, 0.8});
    config.levels[1].manualMeshName = "hand-made";
    config.reinitialiseEntities = true;
    const auto report = ProgressiveMeshGenerator().generateLodLevels(config);
    ASSERT_TRUE(report) << describe(report.error());
    EXPECT_TRUE(frame(0.1f));
    EXPECT_EQ(mPreview->shownLevel(), 2u);
    EXPECT_EQ(mPreview->triangles(), 20u * 16u);
    EXPECT_EQ(mPreview->animation(), animation);
    mPreview->setLevel(1);
    const Picture before = picture();
    frame(0.4f);
    EXPECT_GT(differences(picture(), before), 100u);
    mPreview->setMode(ViewMode::Flat);
    mPreview->setLevel(2);
    const Picture handMade = picture();
    keep(handMade, "hand-made");
    EXPECT_GT(*std::max_element(handMade.rgb.begin(), handMade.rgb.end()), 150) << "the light reaches it";
    config = proportional(mesh, {0.5});
    config.reinitialiseEntities = true;
    ASSERT_TRUE(ProgressiveMeshGenerator().generateLodLevels(config));
    expectShown(mesh, 1);
}

TEST_F(PreviewLevelsTest, ReloadedMeshIsShownAgain)
{
    const Ogre::MeshPtr mesh = model("drake");
    show(mesh);
    mPreview->setLevel(0);
    const Picture before = picture();
    mesh->reload();
    EXPECT_TRUE(frame());
    EXPECT_EQ(differences(picture(), before), 0u);
    EXPECT_EQ(mPreview->mesh(), mesh);
}

TEST_F(PreviewLevelsTest, UnloadedMeshIsShownWhenItIsBack)
{
    const Ogre::MeshPtr mesh = model("cottage");
    show(mesh);
    mPreview->setLevel(0);
    const Picture before = picture();
    mesh->unload();
    EXPECT_FALSE(mPreview->viewAt("distance_sphere", 10));
    EXPECT_TRUE(mPreview->animations().empty());
    EXPECT_EQ(covered(picture()), 0u);
    EXPECT_FALSE(frame());
    mesh->load();
    EXPECT_EQ(differences(picture(), before), 0u);
}

TEST_F(PreviewLevelsTest, RemovedMeshIsLetGo)
{
    Ogre::MeshPtr mesh = model("cottage");
    show(mesh);
    picture();
    const std::weak_ptr<Ogre::Mesh> watched = mesh;
    Ogre::MeshManager::getSingleton().remove(mesh);
    mesh.reset();
    EXPECT_EQ(covered(picture()), 0u);
    EXPECT_EQ(mPreview->mesh(), nullptr);
    EXPECT_TRUE(watched.expired());
    show(model("cottage"));
    EXPECT_GT(covered(picture()), 1000u);
    Ogre::MeshManager::getSingleton().removeAll();
    EXPECT_EQ(covered(picture()), 0u);
}

TEST_F(PreviewLevelsTest, SidesOfAComparisonAreTheirLevels)
{
    const Ogre::MeshPtr mesh = model("drake");
    show(mesh);
    mPreview->compare(CompareMode::SideBySide, 0, 3);
    const Picture both = picture();
    keep(both, "side-by-side");
    EXPECT_EQ(mPreview->shownLevel(), 0u);
    EXPECT_EQ(mPreview->triangles(), trianglesOf(*mesh, 0) + trianglesOf(*mesh, 3));
    const Picture left = columns(both, 0, 200), right = columns(both, 200, 400);
    EXPECT_GT(differences(left, right), 1000u);
    mPreview->compare(CompareMode::SideBySide, 0, 0);
    EXPECT_EQ(differences(left, columns(picture(), 0, 200)), 0u);
    mPreview->compare(CompareMode::SideBySide, 3, 3);
    const Picture coarse = picture();
    EXPECT_EQ(differences(right, columns(coarse, 200, 400)), 0u);
    EXPECT_LT(differences(right, columns(coarse, 0, 200)), 30u); // the same view, rounded otherwise
}

TEST_F(PreviewLevelsTest, WipeIsLeftOfOneAndRightOfTheOther)
{
    show(model("drake"));
    const Picture fine = pictureOfLevel(0), coarse = pictureOfLevel(3);
    ASSERT_GT(differences(fine, coarse), 1000u);
    for (const std::uint32_t edge : {0u, 137u, 200u, 263u, 400u}) {
        mPreview->compare(CompareMode::Wipe, 0, 3, static_cast<float>(edge) / 400.0f);
        const Picture wiped = picture();
        if (edge == 200)
            keep(wiped, "wipe");
        EXPECT_EQ(differences(columns(wiped, 0, edge), columns(fine, 0, edge)), 0u) << edge;
        EXPECT_EQ(differences(columns(wiped, edge, 400), columns(coarse, edge, 400)), 0u) << edge;
    }
}

TEST_F(PreviewLevelsTest, ComparedLevelsAreLimitedAndSharesToo)
{
    const Ogre::MeshPtr mesh = model("cottage", {0.5});
    show(mesh);
    mPreview->compare(CompareMode::Wipe, 99, 5, 17);
    frame();
    EXPECT_EQ(mPreview->shownLevel(), 1u);
    mPreview->compare(CompareMode::Wipe, 0, 1, std::numeric_limits<float>::quiet_NaN());
    frame();
    mesh->freeEdgeList();
    mesh->removeLodLevels();
    frame();
    EXPECT_EQ(mPreview->triangles(), 2 * trianglesOf(*mesh, 0));
}

struct Strategy {
    std::string name;
    double value;
};

void PrintTo(const Strategy& strategy, std::ostream* stream)
{
    *stream << strategy.name;
}

class PreviewSwitchTest : public PreviewLevelsTest, public testing::WithParamInterface<Strategy> {
protected:
    /// The preview's own camera and entity.
    static const Ogre::Camera* camera()
    {
        const Ogre::Camera* found = nullptr;
        for (const auto& [name, scene] : Ogre::Root::getSingleton().getSceneManagers())
            for (const auto& [cameraName, camera] : scene->getCameras())
                if (name.find("preview") != std::string::npos)
                    found = camera;
        return found;
    }

    static Ogre::Real valueOf(const Ogre::LodStrategy& strategy)
    {
        for (const auto& [name, object] : camera()->getSceneManager()->getMovableObjects("Entity"))
            return strategy.getValue(object, camera());
        return -1;
    }
};

TEST_P(PreviewSwitchTest, LevelAppearsJustThere)
{
    const Ogre::MeshPtr mesh = model("cottage", {});
    LodConfig config = proportional(mesh, {0.7});
    config.strategy = GetParam().name;
    config.levels[0].value = static_cast<Ogre::Real>(GetParam().value);
    ASSERT_TRUE(ProgressiveMeshGenerator().generateLodLevels(config));
    show(mesh);
    mPreview->orbit(31, 17);
    mPreview->pan(20, -9);
    const auto seen = mPreview->viewAt(GetParam().name, GetParam().value);
    ASSERT_TRUE(seen) << describe(seen.error());
    expectShown(mesh, 1);
    const Ogre::LodStrategy& strategy = *Ogre::LodStrategyManager::getSingleton().getStrategy(GetParam().name);
    const Ogre::Real wanted = strategy.transformUserValue(static_cast<Ogre::Real>(GetParam().value));
    EXPECT_NEAR(valueOf(strategy) / wanted, 1, 1e-5);
    mPreview->zoom(1e-4f);
    expectShown(mesh, 0);
}

INSTANTIATE_TEST_SUITE_P(Ogre, PreviewSwitchTest,
                         testing::Values(Strategy{"distance_sphere", 40}, Strategy{"distance_box", 25},
                                         Strategy{"pixel_count", 9000}, Strategy{"screen_ratio_pixel_count", 0.05}),
                         [](const auto& strategy) { return strategy.param.name; });

TEST_F(PreviewLevelsTest, ViewAtDistanceIsThatDistance)
{
    const Ogre::MeshPtr ball = makeOgreMesh("ball", makeIcosphere(3, 2.0));
    show(ball);
    ASSERT_TRUE(mPreview->viewAt("distance_sphere", 50));
    EXPECT_NEAR(mPreview->distance(), std::hypot(50, ball->getBoundingSphereRadius()), 1e-3);
    ASSERT_TRUE(mPreview->viewAt("pixel_count", 3000));
    frame();
    double pixels = static_cast<double>(covered(picture()));
    EXPECT_NEAR(pixels / 3000, 1, 0.05);
    mPreview->resize(800, 600);
    ASSERT_TRUE(mPreview->viewAt("pixel_count", 3000));
    pixels = static_cast<double>(covered(picture()));
    EXPECT_NEAR(pixels / 3000, 1, 0.05);
}

TEST_F(PreviewLevelsTest, ViewAtNowhereIsAnErrorAndMovesNothing)
{
    show(makeOgreMesh("ball", makeIcosphere(3)));
    const float distance = mPreview->distance();
    for (const double value :
         {0.0, -5.0, 1e30, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e12}) {
        const auto seen = mPreview->viewAt("distance_sphere", value);
        ASSERT_FALSE(seen) << value;
        EXPECT_EQ(seen.error().code, ErrorCode::InvalidSetting);
    }
    EXPECT_FALSE(mPreview->viewAt("pixel_count", 1e-30));
    EXPECT_FALSE(mPreview->viewAt("no such strategy", 1));
    EXPECT_EQ(mPreview->distance(), distance);
}

} // namespace
} // namespace lodsmith::test
