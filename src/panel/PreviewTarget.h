#pragma once

#include <lodsmith/panel/MeshPreview.h>

#include <OgreTexture.h>

namespace Ogre {
class RenderTarget;
class Viewport;
} // namespace Ogre

namespace lodsmith {

/// The texture that the preview draws into, and its one or two viewports, which show the top left part of it. Drawn on request alone.
class PreviewTarget {
public:
    static constexpr unsigned kMaxSize = 4096;

    /// @param name of the texture, which nothing else in OGRE has, and of its resource group
    PreviewTarget(const Ogre::String& name, const Ogre::String& group, Ogre::Camera& camera);
    ~PreviewTarget();
    PreviewTarget(const PreviewTarget&) = delete;
    PreviewTarget& operator=(const PreviewTarget&) = delete;

    /// Pixels that are shown, limited to 1..kMaxSize. The texture grows in large steps and never shrinks: to make one takes
    /// time, and OGRE keeps a depth buffer for each size it ever had. Returns whether the size is another one.
    bool resize(unsigned width, unsigned height);
    unsigned width() const { return mWidth; }
    unsigned height() const { return mHeight; }

    /// Off: one viewport; SideBySide: one half each; Wipe: both all over, the second not clearing what the first has drawn.
    void setCompare(CompareMode mode);
    Ogre::Viewport& viewport(unsigned number) { return *mViewports[number]; }

    const Ogre::TexturePtr& texture() const { return mTexture; }
    Ogre::RenderTarget& target() { return *mTarget; }

private:
    void makeTexture(unsigned width, unsigned height);
    void makeViewports();
    void dropTexture();

    Ogre::String mName;
    Ogre::String mGroup;
    Ogre::Camera& mCamera;
    Ogre::TexturePtr mTexture;
    Ogre::RenderTarget* mTarget = nullptr;
    Ogre::Viewport* mViewports[2] = {nullptr, nullptr};
    CompareMode mCompare = CompareMode::Off;
    unsigned mWidth = 1;
    unsigned mHeight = 1;
};

} // namespace lodsmith
