#include "PreviewFixture.h"

#include <CeguiPreview.h>

#include <CEGUI/CEGUI.h>
#include <CEGUI/RendererModules/Ogre/Renderer.h>

#include <OgreRenderTarget.h>
#include <OgreResourceGroupManager.h>
#include <OgreViewport.h>

#include <gtest/gtest.h>

namespace lodsmith::test {
namespace {

/// CEGUI in a window, with a preview's image in a part of it.
class PreviewImageTest : public PreviewFixture {
protected:
    PreviewImageTest() : PreviewFixture(800, 600) {}

    void SetUp() override
    {
        PreviewFixture::SetUp();
        if (!mSession)
            return;
        CEGUI::OgreRenderer::bootstrapSystem(*mSession->viewport().getTarget());
        loadSkin();
        mShown = std::make_unique<CeguiPreview>(*mAnalyser);
        mWindow = CEGUI::WindowManager::getSingleton().createWindow("TaharezLook/StaticImage");
        mWindow->setProperty("FrameEnabled", "false");
        mWindow->setProperty("BackgroundEnabled", "false");
        CEGUI::System::getSingleton().getDefaultGUIContext().setRootWindow(mWindow);
    }

    void TearDown() override
    {
        mShown.reset();
        if (CEGUI::System::getSingletonPtr())
            CEGUI::OgreRenderer::destroySystem();
        PreviewFixture::TearDown();
    }

    static void loadSkin()
    {
        for (const std::string group : {"schemes", "imagesets", "fonts", "looknfeel"})
            Ogre::ResourceGroupManager::getSingleton().addResourceLocation(LODSMITH_CEGUI_DATA_DIR "/" + group,
                                                                           "FileSystem", group);
        CEGUI::ImageManager::setImagesetDefaultResourceGroup("imagesets");
        CEGUI::Font::setDefaultResourceGroup("fonts");
        CEGUI::WidgetLookManager::setDefaultResourceGroup("looknfeel");
        CEGUI::SchemeManager::getSingleton().createFromFile("TaharezLook.scheme", "schemes");
    }

    /// Gives window and preview a size and draws. Returns what the screen shows in the window's place.
    Picture onScreen(std::uint32_t width, std::uint32_t height)
    {
        mWindow->setArea(CEGUI::UVector2(), CEGUI::USize(CEGUI::UDim(0, float(width)), CEGUI::UDim(0, float(height))));
        mShown->preview.resize(width, height);
        mShown->image.follow();
        EXPECT_TRUE(mShown->preview.update(0));
        const Picture screen = columns(mSession->picture(), 0, width);
        Picture part{width, height, screen.rgb};
        part.rgb.resize(std::size_t(3) * width * height);
        return part;
    }

    std::unique_ptr<CeguiPreview> mShown;
    CEGUI::Window* mWindow = nullptr;
};

TEST_F(PreviewImageTest, ScreenShowsThePreviewPixelByPixel)
{
    ASSERT_TRUE(mShown->preview.show(model("cottage")));
    mWindow->setProperty("Image", mShown->image.name());
    for (const auto& [width, height] : {std::pair(400u, 300u), std::pair(700u, 500u), std::pair(123u, 457u)}) {
        const Picture screen = onScreen(width, height);
        keep(screen, "screen");
        EXPECT_GT(covered(screen), 2000u);
        EXPECT_LT(differences(screen, pictureOf(mShown->preview)), 20u) << width;
    }
}

TEST_F(PreviewImageTest, LegendGoesFromBlueToRed)
{
    mWindow->setProperty("Image", mShown->legend.name());
    const Picture screen = onScreen(400, 300);
    keep(screen, "legend");
    const auto* left = &screen.rgb[3 * (150 * 400 + 2)];
    const auto* right = &screen.rgb[3 * (150 * 400 + 397)];
    EXPECT_GT(left[2], 2 * left[0]);
    EXPECT_GT(right[0], 2 * right[2]);
}

} // namespace
} // namespace lodsmith::test
