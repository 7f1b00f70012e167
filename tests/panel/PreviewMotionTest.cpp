#include "PreviewFixture.h"

#include <support/MeshBuilders.h>
#include <support/OgreMeshBuilder.h>

#include <lodsmith/ogre/ProgressiveMeshGenerator.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace lodsmith::test {
namespace {

class PreviewAnimationTest : public PreviewFixture {};
class PreviewDeviationTest : public PreviewFixture {};

TEST_F(PreviewAnimationTest, PlaysAndRests)
{
    show(model("drake"));
    const Picture atRest = picture();
    ASSERT_FALSE(mPreview->animations().empty());
    const std::string name = mPreview->animations().front();
    ASSERT_TRUE(mPreview->play(name));
    EXPECT_EQ(mPreview->animation(), name);
    EXPECT_TRUE(frame(0.3f));
    EXPECT_TRUE(frame(0.3f));
    EXPECT_FALSE(frame(0)) << "it stands still";
    const Picture moved = picture();
    keep(moved, "animation");
    EXPECT_GT(differences(moved, atRest), 500u);
    ASSERT_TRUE(mPreview->play(""));
    EXPECT_EQ(differences(picture(), atRest), 0u);
}

TEST_F(PreviewAnimationTest, UnknownOneIsAnError)
{
    show(model("drake"));
    const auto played = mPreview->play("no such animation");
    ASSERT_FALSE(played);
    EXPECT_EQ(played.error().code, ErrorCode::NotFound);
    EXPECT_EQ(mPreview->animation(), "");
}

TEST_F(PreviewAnimationTest, SpeedCounts)
{
    show(model("drake"));
    ASSERT_TRUE(mPreview->play(mPreview->animations().front()));
    frame(0.2f);
    const Picture later = picture();
    mPreview->setSpeed(0);
    EXPECT_FALSE(frame(0.2f));
    mPreview->setSpeed(std::numeric_limits<float>::quiet_NaN());
    EXPECT_TRUE(frame(0.2f));
    ASSERT_TRUE(mPreview->play(mPreview->animation()));
    mPreview->setSpeed(2);
    frame(0.1f);
    EXPECT_EQ(differences(picture(), later), 0u);
    mPreview->setSpeed(-2);
    frame(0.1f);
    frame(0.1f);
    EXPECT_GT(differences(picture(), later), 500u);
}

TEST_F(PreviewAnimationTest, GoesOnWhenTheMeshIsReloaded)
{
    const Ogre::MeshPtr mesh = model("drake");
    show(mesh);
    mPreview->setLevel(0);
    ASSERT_TRUE(mPreview->play(mPreview->animations().front()));
    frame(0.4f);
    const Picture before = picture();
    mesh->reload();
    EXPECT_EQ(differences(picture(), before), 0u);
}

TEST_F(PreviewDeviationTest, ScaleIsKnownOnceItIsMeasured)
{
    show(model("cottage"));
    frame();
    EXPECT_FALSE(mPreview->deviationScale());
    mPreview->setMode(ViewMode::Deviation);
    mPreview->setLevel(2);
    frame();
    EXPECT_FALSE(mPreview->deviationScale());
    finish();
    ASSERT_TRUE(mPreview->deviationScale()) << mPreview->deviationError();
    const double middle = *mPreview->deviationScale();
    EXPECT_GT(middle, 0);
    mPreview->setLevel(3);
    finish();
    ASSERT_TRUE(mPreview->deviationScale());
    EXPECT_GT(*mPreview->deviationScale(), middle);
    mPreview->setLevel(2);
    frame();
    EXPECT_EQ(mPreview->deviationScale(), middle) << "known from before";
    mPreview->setLevel(0);
    frame();
    EXPECT_EQ(mPreview->deviationScale(), 0.0);
    mPreview->setMode(ViewMode::Shaded);
    frame();
    EXPECT_FALSE(mPreview->deviationScale());
}

TEST_F(PreviewDeviationTest, ShowsLevelZeroBlueWhereNothingIsOff)
{
    const Ogre::MeshPtr mesh = model("cottage");
    show(mesh);
    mPreview->setMode(ViewMode::Deviation);
    mPreview->setLevel(0);
    const Picture blue = picture();
    EXPECT_GT(covered(blue), 10000u);
    for (std::size_t i = 0; i < blue.rgb.size(); i += 3)
        EXPECT_LE(std::max(blue.rgb[i], blue.rgb[i + 1]), blue.rgb[i + 2]);
    const std::size_t triangles = mPreview->triangles();
    mPreview->setLevel(3);
    finish();
    const Picture hot = picture();
    keep(hot, "deviation-hot");
    EXPECT_EQ(mPreview->triangles(), triangles);
    EXPECT_EQ(mPreview->shownLevel(), 3u);
    std::size_t red = 0;
    for (std::size_t i = 0; i < hot.rgb.size(); i += 3)
        red += hot.rgb[i] > 100 && hot.rgb[i] > 2 * hot.rgb[i + 1] && hot.rgb[i] > 2 * hot.rgb[i + 2];
    EXPECT_GT(red, 50u);
}

TEST_F(PreviewDeviationTest, FollowsNewLevels)
{
    const Ogre::MeshPtr mesh = model("cottage", {0.5});
    show(mesh);
    mPreview->setMode(ViewMode::Deviation);
    mPreview->setLevel(1);
    finish();
    ASSERT_TRUE(mPreview->deviationScale());
    const double before = *mPreview->deviationScale();
    ASSERT_TRUE(ProgressiveMeshGenerator().generateLodLevels(proportional(mesh, {0.9})));
    frame();
    EXPECT_FALSE(mPreview->deviationScale());
    finish();
    ASSERT_TRUE(mPreview->deviationScale());
    EXPECT_GT(*mPreview->deviationScale(), before);
    mesh->freeEdgeList();
    mesh->removeLodLevels();
    finish();
    EXPECT_EQ(mPreview->deviationScale(), 0.0);
    mesh->reload();
    finish();
    EXPECT_EQ(mPreview->deviationScale(), 0.0);
}

TEST_F(PreviewDeviationTest, TwoLevelsShareTheScale)
{
    show(model("cottage"));
    mPreview->setMode(ViewMode::Deviation);
    mPreview->compare(CompareMode::SideBySide, 1, 3);
    finish();
    ASSERT_TRUE(mPreview->deviationScale());
    const double both = *mPreview->deviationScale();
    const Picture halves = picture();
    keep(halves, "deviation-side-by-side");
    EXPECT_GT(differences(columns(halves, 0, 200), columns(halves, 200, 400)), 1000u);
    mPreview->compare(CompareMode::Off, 0, 0);
    mPreview->setLevel(3);
    finish();
    EXPECT_EQ(mPreview->deviationScale(), both);
}

TEST_F(PreviewDeviationTest, MayGoAwayWhileItMeasures)
{
    const Ogre::MeshPtr mesh = model("drake");
    show(mesh);
    mPreview->setMode(ViewMode::Deviation);
    mPreview->setLevel(2);
    frame();
    mPreview->clear();
    finish();
    show(mesh);
    frame();
    mesh->unload();
    finish();
    mesh->load();
    frame();
    mPreview.reset();
    mSession->frame();
    mAnalyser->finishAll();
}

TEST_F(PreviewDeviationTest, MeshWithoutNormalsIsShaded)
{
    show(makeOgreMesh("tetrahedron", makeTetrahedron()));
    mPreview->setMode(ViewMode::Deviation);
    finish();
    const Picture shown = picture();
    std::size_t shades = 0;
    std::vector<bool> seen(256);
    for (std::size_t i = 0; i < shown.rgb.size(); i += 3)
        if (!seen[shown.rgb[i + 2]]) {
            seen[shown.rgb[i + 2]] = true;
            ++shades;
        }
    EXPECT_GT(shades, 3u);
}

} // namespace
} // namespace lodsmith::test
