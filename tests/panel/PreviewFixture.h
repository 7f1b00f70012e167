#pragma once

#include <lodsmith/ogre/LevelAnalyser.h>
#include <lodsmith/panel/MeshPreview.h>

#include <support/RenderSession.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace lodsmith::test {

/// A preview in OGRE's OpenGL render system, and what it shows. Skipped where there is no Xvfb.
class PreviewFixture : public testing::Test {
protected:
    /// @param width pixels of the window, which shows nothing of it
    explicit PreviewFixture(std::uint32_t width = 64, std::uint32_t height = 64) : mWidth(width), mHeight(height) {}

    void SetUp() override;
    void TearDown() override;

    /// One of media/, with levels that remove these shares of its vertices, at distances of 10, 20, ...
    Ogre::MeshPtr model(const std::string& name, const std::vector<double>& removed = {0.5, 0.8, 0.95});
    void show(const Ogre::MeshPtr& mesh);

    /// A frame of OGRE's, and an update. Returns whether the preview has drawn.
    bool frame(float seconds = 0.0f);
    /// Frames until nothing is measured any more.
    void finish();
    /// Frames until nothing is drawn any more, and then the picture.
    Picture picture();

    std::unique_ptr<RenderSession> mSession;
    std::unique_ptr<LevelAnalyser> mAnalyser;
    std::unique_ptr<MeshPreview> mPreview;

private:
    std::uint32_t mWidth;
    std::uint32_t mHeight;
};

/// What a preview shows now.
Picture pictureOf(const MeshPreview& preview);

/// Pixels that are not the same.
std::size_t differences(const Picture& a, const Picture& b);
/// Columns `left`..`right` - 1.
Picture columns(const Picture& picture, std::uint32_t left, std::uint32_t right);
/// Pixels that are not the background.
std::size_t covered(const Picture& picture);
/// Writes a picture for people, when the environment variable LODSMITH_PICTURES names a directory.
void keep(const Picture& picture, const std::string& name);

} // namespace lodsmith::test
