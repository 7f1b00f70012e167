#include "RenderTest.h"

#include <support/MeshBuilders.h>
#include <support/OgreMeshBuilder.h>

#include <lodsmith/analysis/ImageDifference.h>
#include <lodsmith/ogre/ProgressiveMeshGenerator.h>
#include <lodsmith/render/LevelRenderer.h>
#include <lodsmith/render/Png.h>

#include <OgreDataStream.h>
#include <OgreHardwarePixelBuffer.h>
#include <OgreImage.h>
#include <OgreMaterialManager.h>
#include <OgrePass.h>
#include <OgreSubMesh.h>
#include <OgreTechnique.h>
#include <OgreTextureManager.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace lodsmith::test {
namespace {

constexpr double kPi = 3.14159265358979323846;
const Ogre::Vector3 kFront = Ogre::Vector3::UNIT_Z;

/// Where a picture shows something.
struct Extent {
    int left = 1 << 20;  ///< the first column, as far as it is half covered at least
    int bottom = -1;     ///< the last row of that kind
    double width = 0.0;  ///< what the widest row covers, pixels and parts of them
    double height = 0.0; ///< the same of columns
};

Extent extentOf(const Image& image)
{
    Extent extent;
    std::vector<double> rows(image.height), columns(image.width);
    for (std::size_t y = 0; y < image.height; ++y)
        for (std::size_t x = 0; x < image.width; ++x) {
            const double covered = image.pixel(x, y)[3] / 255.0;
            rows[y] += covered;
            columns[x] += covered;
            if (covered > 0.5) {
                extent.left = std::min(extent.left, int(x));
                extent.bottom = std::max(extent.bottom, int(y));
            }
        }
    extent.width = *std::max_element(rows.begin(), rows.end());
    extent.height = *std::max_element(columns.begin(), columns.end());
    return extent;
}

/// A square from -1 to 1 that faces the front, with texture coordinates 0..1.
TestMesh makeSquare(double width = 2, double height = 2)
{
    return translated(makePatch(1, 1, [=](double u, double v) { return Point{u * width, v * height, 0}; }), -1, -1, 0);
}

class LevelRendererTest : public RenderTest {
protected:
    LevelRendererTest() : RenderTest(64, 64) {}

    void TearDown() override
    {
        mRenderer.reset();
        mTexture.reset();
    }

    void renderer(const Ogre::MeshPtr& mesh)
    {
        mRenderer.reset();
        auto made = LevelRenderer::create(mesh);
        ASSERT_TRUE(made) << describe(made.error());
        mRenderer = std::move(made).value();
    }

    Image picture(unsigned level, Paint paint, const Viewpoint& viewpoint)
    {
        Result<Image> image = mRenderer->picture(level, paint, viewpoint);
        EXPECT_TRUE(image) << describe(image.error());
        return image ? std::move(image).value() : Image{};
    }

    Image closeUp(unsigned level, Paint paint = Paint::Grey, unsigned size = 100)
    {
        return picture(level, paint, mRenderer->closeUp(kFront, size));
    }

    /// A material of the mesh's, without light, so that colours are what is stated.
    Ogre::Pass& unlitMaterial(Ogre::Mesh& mesh)
    {
        const Ogre::MaterialPtr material =
            Ogre::MaterialManager::getSingleton().create(mesh.getName() + " paint", mesh.getGroup());
        mesh.getSubMesh(0)->setMaterialName(material->getName(), mesh.getGroup());
        Ogre::Pass& pass = *material->getTechnique(0)->getPass(0);
        pass.setLightingEnabled(false);
        return pass;
    }

    /// A texture of white whose left half is not there.
    Ogre::TexturePtr halfTexture()
    {
        std::vector<std::uint8_t> rgba(std::size_t(4) * 64 * 64, 255);
        for (std::size_t pixel = 0; pixel < 64 * 64; ++pixel)
            rgba[4 * pixel + 3] = pixel % 64 < 32 ? 0 : 255;
        mTexture = Ogre::TextureManager::getSingleton().createManual("half", Ogre::RGN_DEFAULT, Ogre::TEX_TYPE_2D, 64,
                                                                     64, 0, Ogre::PF_BYTE_RGBA);
        mTexture->getBuffer()->blitFromMemory(Ogre::PixelBox(Ogre::Box(0, 0, 64, 64), Ogre::PF_BYTE_RGBA, rgba.data()));
        return mTexture;
    }

    std::unique_ptr<LevelRenderer> mRenderer;
    Ogre::TexturePtr mTexture;
};

TEST_F(LevelRendererTest, APictureIsTheSameEveryTime)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("sphere", makeUvSphere(24, 16));
    renderer(mesh);
    for (const Paint paint : {Paint::Own, Paint::Grey, Paint::Checker}) {
        const Image first = closeUp(0, paint);
        EXPECT_GT(coveredPixels(first), 1000);
        EXPECT_EQ(first.rgba, closeUp(0, paint).rgba);
    }
    EXPECT_NE(closeUp(0, Paint::Grey).rgba, closeUp(0, Paint::Checker).rgba);
    renderer(mesh);
    const Image again = closeUp(0);
    renderer(makeOgreMesh("other", makeUvSphere(24, 16)));
    EXPECT_EQ(closeUp(0).rgba, again.rgba) << "another mesh, of the same vertices";
}

TEST_F(LevelRendererTest, CloseUpTheMeshFillsThePictureUpToTheMargin)
{
    // Far from its origin, and wider than high.
    renderer(makeOgreMesh("sheet", translated(makeSquare(6, 2), 100, 40, -7)));
    for (const unsigned size : {64u, 300u}) {
        const Image image = closeUp(0, Paint::Grey, size);
        const int inner = int(size) - 16;
        EXPECT_EQ(image.width, size);
        EXPECT_NEAR(extentOf(image).width, inner, 1);
        EXPECT_NEAR(extentOf(image).height, inner / 3.0, 1);
        EXPECT_NEAR(coveredPixels(image), inner * inner / 3.0, 1.5 * inner);
    }
}

TEST_F(LevelRendererTest, AtItsSwitchTheBoundingDiscHasTheValueInPixels)
{
    // A disc that faces the camera is what the strategy counts.
    const Ogre::MeshPtr mesh = makeOgreMesh("disc", scaled(makeFan(256), 3));
    LodConfig config = proportional(mesh, {0.5});
    config.strategy = "pixel_count";
    for (const double pixels : {200000.0, 5000.0, 300.0}) {
        SCOPED_TRACE(pixels);
        config.levels[0].value = static_cast<Ogre::Real>(pixels);
        ASSERT_TRUE(ProgressiveMeshGenerator().generateLodLevels(config));
        renderer(mesh);
        const Result<Viewpoint> viewpoint = mRenderer->atSwitch(1, kFront);
        ASSERT_TRUE(viewpoint) << describe(viewpoint.error());
        const Image image = picture(0, Paint::Grey, viewpoint.value());
        const double diameter = 2 * std::sqrt(pixels / kPi);
        EXPECT_NEAR(extentOf(image).width, diameter, 1);
        EXPECT_NEAR(extentOf(image).height, diameter, 1);
        EXPECT_NEAR(coveredPixels(image), pixels, 0.01 * pixels);
        EXPECT_NEAR(image.width, diameter + 16, 3) << "only the part that shows the mesh";
        EXPECT_NEAR(pixelsOf(mesh->getBoundingSphereRadius(), viewpoint.value().distance, {}), diameter / 2, 1e-3);
    }
}

TEST_F(LevelRendererTest, WhatIsBeyondTheScreenIsCutOff)
{
    renderer(makeOgreMesh("square", makeSquare()));
    Viewpoint near;
    near.distance = 0.5; // where 2 units are about 2600 pixels
    const Image image = picture(0, Paint::Grey, near);
    EXPECT_EQ(image.width, 1920u);
    EXPECT_EQ(image.height, 1080u);
    EXPECT_EQ(coveredPixels(image), 1920 * 1080);
    near.target = Ogre::Vector3(50, 0, 0); // past it
    EXPECT_EQ(coveredPixels(picture(0, Paint::Grey, near)), 0);
}

TEST_F(LevelRendererTest, TheFieldOfViewAndTheScreenSayHowLargeItIs)
{
    renderer(makeOgreMesh("square", makeSquare()));
    Viewpoint viewpoint;
    viewpoint.distance = 10;
    viewpoint.screen = {800, 600, kPi / 2};
    // At 90 degrees half the screen's height is as long as the distance.
    EXPECT_NEAR(extentOf(picture(0, Paint::Grey, viewpoint)).width, 2.0 / 10 * 300, 1);
}

TEST_F(LevelRendererTest, AHandMadeLevelIsSeenAsItIs)
{
    const Ogre::MeshPtr half = makeOgreMesh("half", makeSquare(2, 1)), mesh = makeOgreMesh("whole", makeSquare());
    setHandMadeLevel(*mesh, "half");
    renderer(mesh);
    EXPECT_EQ(mRenderer->levels(), 2u);
    const Image whole = closeUp(0), lower = closeUp(1);
    const ImageDifference difference = compareImages(whole, lower);
    EXPECT_NEAR(difference.coverage, 0.5, 0.02);
    EXPECT_NEAR(difference.silhouette.share, 0.5, 0.02);
    EXPECT_NEAR(difference.silhouette.distance, 42, 1);
    EXPECT_EQ(extentOf(lower).bottom, extentOf(whole).bottom) << "rows go down from the top";
}

TEST_F(LevelRendererTest, AlphaTestedHolesAreHoles)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("leaf", makeSquare());
    Ogre::Pass& pass = unlitMaterial(*mesh);
    pass.setAlphaRejectSettings(Ogre::CMPF_GREATER_EQUAL, 128);
    pass.createTextureUnitState()->setTexture(halfTexture());
    renderer(mesh);
    for (const Paint paint : {Paint::Own, Paint::Grey, Paint::Checker}) {
        const Image image = closeUp(0, paint);
        EXPECT_NEAR(extentOf(image).left, 50, 2) << "the left half is a hole";
        EXPECT_NEAR(coveredPixels(image), 84 * 84 / 2.0, 84 * 2);
    }
}

TEST_F(LevelRendererTest, WhatIsBlendedCoversAsMuchAsItHides)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("glass", makeSquare());
    Ogre::Pass& pass = unlitMaterial(*mesh);
    pass.setSceneBlending(Ogre::SBT_TRANSPARENT_ALPHA);
    Ogre::TextureUnitState& unit = *pass.createTextureUnitState();
    unit.setColourOperationEx(Ogre::LBX_SOURCE1, Ogre::LBS_MANUAL, Ogre::LBS_CURRENT, Ogre::ColourValue(1, 0, 0));
    unit.setAlphaOperation(Ogre::LBX_SOURCE1, Ogre::LBS_MANUAL, Ogre::LBS_CURRENT, 0.25f);
    unit.setTexture(halfTexture());
    renderer(mesh);
    const Image image = closeUp(0, Paint::Own);
    const std::uint8_t* const middle = image.pixel(50, 50);
    EXPECT_NEAR(middle[3], 0.25 * 255, 2);
    EXPECT_NEAR(middle[0], 0.25 * 255, 2);
    EXPECT_EQ(middle[1], 0);
}

TEST_F(LevelRendererTest, OwnMaterialsAreSeenAndMissingOnesAreGrey)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("green", makeSquare());
    unlitMaterial(*mesh).createTextureUnitState()->setColourOperationEx(Ogre::LBX_SOURCE1, Ogre::LBS_MANUAL,
                                                                        Ogre::LBS_CURRENT, Ogre::ColourValue(0, 1, 0));
    renderer(mesh);
    const Image green = closeUp(0, Paint::Own);
    EXPECT_EQ(green.pixel(50, 50)[1], 255);
    EXPECT_EQ(green.pixel(50, 50)[0], 0);
    renderer(makeOgreMesh("bare", makeSquare()));
    EXPECT_EQ(closeUp(0, Paint::Own).rgba, closeUp(0, Paint::Grey).rgba);
}

TEST_F(LevelRendererTest, WithoutNormalsAMeshIsOneShade)
{
    TestMesh square = makeSquare();
    square.buffers[0].normals.clear();
    renderer(makeOgreMesh("flat", square));
    for (const Paint paint : {Paint::Grey, Paint::Checker, Paint::Own}) {
        const Image image = closeUp(0, paint);
        EXPECT_GT(image.pixel(50, 50)[0], 150);
        for (std::size_t x = 20; x < 80; ++x)
            ASSERT_EQ(image.pixel(x, 50)[0], image.pixel(50, 50)[0]);
    }
}

TEST_F(LevelRendererTest, AMeshWithoutTrianglesIsRefused)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("empty", makeSquare());
    mesh->getSubMesh(0)->indexData->indexCount = 0;
    const auto made = LevelRenderer::create(mesh);
    ASSERT_FALSE(made);
    EXPECT_EQ(made.error().code, ErrorCode::InvalidGeometry) << describe(made.error());
    EXPECT_EQ(made.error().file, "empty");
}

TEST_F(LevelRendererTest, APngHasThePixelsBack)
{
    Image image = Image::empty(3, 2);
    const std::uint8_t pixels[] = {255, 0, 0, 255, 0, 64, 0, 128, 10, 20, 30, 255};
    std::copy(std::begin(pixels), std::end(pixels), image.rgba.begin());
    const Result<std::string> png = pngBytes(image);
    ASSERT_TRUE(png) << describe(png.error());
    std::string bytes = png.value();
    Ogre::Image back;
    back.load(std::make_shared<Ogre::MemoryDataStream>(bytes.data(), bytes.size()), "png");
    ASSERT_EQ(back.getWidth(), 3u);
    ASSERT_EQ(back.getHeight(), 2u);
    EXPECT_EQ(back.getColourAt(0, 0, 0), Ogre::ColourValue(1, 0, 0));
    EXPECT_NEAR(back.getColourAt(1, 0, 0).g, 0.5, 0.01) << "not multiplied by alpha";
    EXPECT_NEAR(back.getColourAt(1, 0, 0).a, 0.5, 0.01);
    EXPECT_EQ(back.getColourAt(0, 1, 0).a, 0);
}

} // namespace
} // namespace lodsmith::test
