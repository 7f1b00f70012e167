#include "PreviewFixture.h"

#include <support/OgreMeshBuilder.h>

#include <lodsmith/ogre/ProgressiveMeshGenerator.h>

#include <OgreHardwarePixelBuffer.h>
#include <OgreImage.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <thread>

namespace lodsmith::test {

void PreviewFixture::SetUp()
{
    if (!VirtualDisplay::isAvailable())
        GTEST_SKIP() << "Xvfb is not installed";
    mSession = std::make_unique<RenderSession>(mWidth, mHeight);
    mAnalyser = std::make_unique<LevelAnalyser>();
    mPreview = std::make_unique<MeshPreview>(*mAnalyser);
    mPreview->resize(400, 300);
}

void PreviewFixture::TearDown()
{
    mPreview.reset();
    mAnalyser.reset();
}

Ogre::MeshPtr PreviewFixture::model(const std::string& name, const std::vector<double>& removed)
{
    const Ogre::MeshPtr mesh = mSession->load(LODSMITH_MEDIA_DIR "/" + name + "/" + name + ".mesh");
    const auto report = ProgressiveMeshGenerator().generateLodLevels(proportional(mesh, removed));
    EXPECT_TRUE(report) << describe(report.error());
    return mesh;
}

void PreviewFixture::show(const Ogre::MeshPtr& mesh)
{
    const auto shown = mPreview->show(mesh);
    ASSERT_TRUE(shown) << describe(shown.error());
}

bool PreviewFixture::frame(float seconds)
{
    mSession->frame();
    const auto drawn = mPreview->update(seconds);
    EXPECT_TRUE(drawn) << describe(drawn.error());
    return drawn && drawn.value();
}

void PreviewFixture::finish()
{
    frame();
    while (!mAnalyser->isIdle()) {
        frame();
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
}

Picture PreviewFixture::picture()
{
    while (frame()) {
    }
    return pictureOf(*mPreview);
}

Picture pictureOf(const MeshPreview& preview)
{
    Picture picture{preview.width(), preview.height(), {}};
    picture.rgb.resize(std::size_t(3) * picture.width * picture.height);
    const Ogre::Box shown(0, 0, picture.width, picture.height);
    preview.texture()->getBuffer()->blitToMemory(shown, Ogre::PixelBox(shown, Ogre::PF_BYTE_RGB, picture.rgb.data()));
    return picture;
}

std::size_t differences(const Picture& a, const Picture& b)
{
    if (a.width != b.width || a.height != b.height)
        return std::max(a.rgb.size(), b.rgb.size());
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.rgb.size(); i += 3)
        count += !std::equal(a.rgb.begin() + static_cast<long>(i), a.rgb.begin() + static_cast<long>(i + 3),
                             b.rgb.begin() + static_cast<long>(i));
    return count;
}

Picture columns(const Picture& picture, std::uint32_t left, std::uint32_t right)
{
    Picture part{right - left, picture.height, {}};
    for (std::uint32_t row = 0; row < picture.height; ++row) {
        const auto begin = picture.rgb.begin() + 3L * (long(row) * picture.width + left);
        part.rgb.insert(part.rgb.end(), begin, begin + 3L * (right - left));
    }
    return part;
}

std::size_t covered(const Picture& picture)
{
    Picture background = picture;
    for (std::size_t i = 0; i < background.rgb.size(); ++i)
        background.rgb[i] = picture.rgb[i % 3];
    return differences(picture, background);
}

void keep(const Picture& picture, const std::string& name)
{
    const char* directory = std::getenv("LODSMITH_PICTURES"); // NOLINT(concurrency-mt-unsafe)
    if (!directory)
        return;
    Picture copy = picture;
    Ogre::Image image;
    image.loadDynamicImage(copy.rgb.data(), copy.width, copy.height, Ogre::PF_BYTE_RGB);
    image.save(std::string(directory) + "/" + name + ".png");
}

} // namespace lodsmith::test
