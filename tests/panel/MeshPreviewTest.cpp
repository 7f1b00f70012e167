#include "PreviewFixture.h"

#include <support/MeshBuilders.h>
#include <support/OgreMeshBuilder.h>

#include <OgreSubMesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace lodsmith::test {
namespace {

class MeshPreviewTest : public PreviewFixture {};

/// Pixels of a colour of their own.
std::size_t coloured(const Picture& picture)
{
    std::size_t count = 0;
    for (std::size_t i = 0; i < picture.rgb.size(); i += 3) {
        const auto [least, most] = std::minmax({picture.rgb[i], picture.rgb[i + 1], picture.rgb[i + 2]});
        count += most - least > 12;
    }
    return count;
}

/// The first column that is not empty.
int leftEdge(const Picture& picture)
{
    std::uint32_t column = 0;
    while (column < picture.width && covered(columns(picture, 0, column + 1)) == 0)
        ++column;
    return static_cast<int>(column);
}

TEST_F(MeshPreviewTest, IsPossibleWithOpenGl)
{
    const auto possible = MeshPreview::isPossible();
    EXPECT_TRUE(possible) << describe(possible.error());
}

TEST_F(MeshPreviewTest, EmptyWithoutAMesh)
{
    EXPECT_EQ(covered(picture()), 0u);
    EXPECT_EQ(mPreview->mesh(), nullptr);
    EXPECT_EQ(mPreview->triangles(), 0u);
    EXPECT_EQ(mPreview->shownLevel(), 0u);
    EXPECT_TRUE(mPreview->animations().empty());
    EXPECT_FALSE(mPreview->deviationScale());
    for (const ViewMode mode : {ViewMode::Deviation, ViewMode::Checker}) {
        mPreview->setMode(mode);
        EXPECT_EQ(covered(picture()), 0u);
    }
    mPreview->compare(CompareMode::Wipe, 1, 2, 0.5f);
    EXPECT_EQ(covered(picture()), 0u);
    mPreview->orbit(1, 1);
    mPreview->pan(1, 1);
    mPreview->zoom(1);
    EXPECT_FALSE(mPreview->viewAt("distance_sphere", 10));
    EXPECT_FALSE(mPreview->show(nullptr));
}

TEST_F(MeshPreviewTest, ShowsAllOfAMesh)
{
    const Ogre::MeshPtr mesh = model("cottage");
    show(mesh);
    const Picture whole = picture();
    keep(whole, "shaded");
    EXPECT_EQ(mPreview->mesh(), mesh);
    EXPECT_GT(covered(whole), 400u * 300u / 10u);
    EXPECT_EQ(covered(columns(whole, 0, 5)), 0u);
    EXPECT_EQ(covered(columns(whole, 395, 400)), 0u);
    mPreview->clear();
    EXPECT_EQ(covered(picture()), 0u);
    EXPECT_EQ(mPreview->mesh(), nullptr);
}

TEST_F(MeshPreviewTest, LoadsAMeshThatIsNotLoaded)
{
    const Ogre::MeshPtr mesh = model("cottage");
    mesh->unload();
    show(mesh);
    EXPECT_GT(covered(picture()), 0u);
}

TEST_F(MeshPreviewTest, TheSameMeshOnceMoreKeepsTheView)
{
    const Ogre::MeshPtr mesh = model("cottage");
    show(mesh);
    mPreview->zoom(3);
    const float distance = mPreview->distance();
    show(mesh);
    EXPECT_EQ(mPreview->distance(), distance);
    show(model("lantern"));
    EXPECT_NE(mPreview->distance(), distance);
}

TEST_F(MeshPreviewTest, DrawsOnlyWhenSomethingHasChanged)
{
    show(model("cottage"));
    EXPECT_TRUE(frame());
    EXPECT_FALSE(frame());
    mPreview->orbit(10, 0);
    EXPECT_TRUE(frame());
    EXPECT_FALSE(frame());
    mPreview->redraw();
    EXPECT_TRUE(frame());
    mPreview->setMode(mPreview->mode());
    mPreview->setLevel(mPreview->level());
    mPreview->compare(CompareMode::Off, 0, 0, 0.5f);
    mPreview->resize(mPreview->width(), mPreview->height());
    EXPECT_FALSE(frame());
}

TEST_F(MeshPreviewTest, ModesPaintDifferently)
{
    show(model("cottage"));
    std::vector<Picture> pictures;
    for (const auto& [mode, name] :
         {std::pair(ViewMode::Shaded, "mode-shaded"), std::pair(ViewMode::Flat, "mode-flat"),
          std::pair(ViewMode::Wireframe, "mode-wireframe"), std::pair(ViewMode::Checker, "mode-checker"),
          std::pair(ViewMode::Deviation, "mode-deviation")}) {
        mPreview->setMode(mode);
        mPreview->setLevel(2);
        finish();
        pictures.push_back(picture());
        keep(pictures.back(), name);
        for (std::size_t i = 0; i + 1 < pictures.size(); ++i)
            EXPECT_GT(differences(pictures.back(), pictures[i]), 5000u) << name << " and mode " << i;
    }
}

TEST_F(MeshPreviewTest, MissingMaterialIsGrey)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("ball", makeIcosphere(3));
    mesh->getSubMesh(0)->setMaterialName("no such material", mSession->group());
    show(mesh);
    const Picture shown = picture();
    keep(shown, "missing-material");
    EXPECT_GT(covered(shown), 20000u);
    EXPECT_EQ(coloured(shown), 0u);
    EXPECT_LT(*std::max_element(shown.rgb.begin(), shown.rgb.end()), 240);
}

TEST_F(MeshPreviewTest, CheckerNeedsTextureCoordinates)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("ball", makeIcosphere(3));
    show(mesh);
    EXPECT_EQ(mPreview->note(), "");
    mPreview->setMode(ViewMode::Checker);
    EXPECT_NE(mPreview->note(), "");
    EXPECT_EQ(coloured(picture()), 0u);
    show(makeOgreMesh("globe", makeUvSphere(24, 16)));
    EXPECT_EQ(mPreview->note(), "");
    const Picture checker = picture();
    keep(checker, "checker-ball");
    EXPECT_GT(coloured(checker), 1000u);
}

TEST_F(MeshPreviewTest, MeshWithoutNormalsIsShownInAllModes)
{
    show(makeOgreMesh("tetrahedron", makeTetrahedron()));
    for (const ViewMode mode : {ViewMode::Shaded, ViewMode::Flat, ViewMode::Wireframe, ViewMode::Checker}) {
        mPreview->setMode(mode);
        EXPECT_GT(covered(picture()), 1000u) << static_cast<int>(mode);
    }
}

TEST_F(MeshPreviewTest, DragsAndWheelMoveTheView)
{
    show(model("cottage"));
    const Picture before = picture();
    const float distance = mPreview->distance();
    mPreview->orbit(40, 0);
    EXPECT_GT(differences(picture(), before), 5000u);
    mPreview->orbit(-40, 0);
    EXPECT_LT(differences(picture(), before), 200u);
    mPreview->pan(50, 0);
    EXPECT_NEAR(leftEdge(picture()), leftEdge(before) + 50, 8); // what is nearer moves farther
    EXPECT_EQ(mPreview->distance(), distance);
    mPreview->zoom(2);
    EXPECT_LT(mPreview->distance(), distance);
    mPreview->resetCamera();
    EXPECT_EQ(mPreview->distance(), distance);
    EXPECT_EQ(differences(picture(), before), 0u);
}

TEST_F(MeshPreviewTest, ExtremeDragsHarmNothing)
{
    show(model("cottage"));
    mPreview->zoom(1e30f);
    EXPECT_GT(mPreview->distance(), 0.0f);
    picture();
    mPreview->zoom(-1e30f);
    picture();
    mPreview->zoom(-1e30f);
    EXPECT_EQ(covered(picture()), 0u); // a speck, beyond a million radii
    for (const float much :
         {1e30f, -1e30f, std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()}) {
        mPreview->orbit(much, much);
        mPreview->pan(much, much);
        mPreview->zoom(much);
        picture();
    }
    mPreview->resetCamera();
    EXPECT_GT(covered(picture()), 10000u);
}

TEST_F(MeshPreviewTest, AnySizeWillDo)
{
    show(model("cottage"));
    mPreview->resize(0, 0);
    EXPECT_EQ(mPreview->width(), 1u);
    EXPECT_EQ(mPreview->height(), 1u);
    picture();
    for (const CompareMode mode : {CompareMode::SideBySide, CompareMode::Wipe, CompareMode::Off}) {
        mPreview->compare(mode, 0, 1, 0.5f);
        EXPECT_EQ(picture().rgb.size(), 3u);
    }
    mPreview->resize(4000000000u, 3);
    EXPECT_EQ(mPreview->width(), 4096u);
    EXPECT_EQ(mPreview->height(), 3u);
    picture();
    mPreview->resize(3, 4000000000u);
    picture();
    mPreview->resize(1300, 700);
    mPreview->resetCamera();
    EXPECT_GT(covered(picture()), 1300u * 700u / 10u);
}

TEST_F(MeshPreviewTest, TextureStaysForSmallerSizes)
{
    mPreview->resize(500, 500);
    const Ogre::TexturePtr texture = mPreview->texture();
    mPreview->resize(20, 480);
    mPreview->resize(512, 512);
    EXPECT_EQ(mPreview->texture(), texture);
    mPreview->resize(513, 100);
    EXPECT_NE(mPreview->texture(), texture);
    EXPECT_GE(mPreview->texture()->getHeight(), 512u);
}

TEST_F(MeshPreviewTest, TwoPreviewsDoNotDisturbEachOther)
{
    show(model("cottage"));
    const Picture alone = picture();
    {
        MeshPreview other(*mAnalyser);
        other.resize(100, 100);
        ASSERT_TRUE(other.show(model("lantern")));
        ASSERT_TRUE(other.update(0));
        EXPECT_NE(other.texture()->getName(), mPreview->texture()->getName());
        mPreview->redraw();
        EXPECT_EQ(differences(picture(), alone), 0u);
    }
    mPreview->redraw();
    EXPECT_EQ(differences(picture(), alone), 0u);
}

} // namespace
} // namespace lodsmith::test
