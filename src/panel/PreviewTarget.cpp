#include "PreviewTarget.h"

#include <OgreCamera.h>
#include <OgreHardwarePixelBuffer.h>
#include <OgreRenderTexture.h>
#include <OgreTextureManager.h>
#include <OgreViewport.h>

#include <algorithm>
#include <cmath>

namespace lodsmith {

namespace {

constexpr unsigned kStep = 512;
constexpr float kFieldOfView = 0.7f; // radians
const Ogre::ColourValue kBackground(0.20f, 0.21f, 0.23f);

unsigned roundedUp(unsigned size)
{
    return (size + kStep - 1) / kStep * kStep;
}

} // namespace

PreviewTarget::PreviewTarget(const Ogre::String& name, const Ogre::String& group, Ogre::Camera& camera)
    : mName(name), mGroup(group), mCamera(camera)
{
    makeTexture(kStep, kStep);
}

PreviewTarget::~PreviewTarget()
{
    dropTexture();
}

void PreviewTarget::dropTexture()
{
    if (!mTexture)
        return;
    mTarget->removeAllViewports();
    // Windows may hold the texture on, but not its name.
    Ogre::TextureManager::getSingleton().remove(mTexture);
    mTexture.reset();
}

void PreviewTarget::makeTexture(unsigned width, unsigned height)
{
    dropTexture();
    mTexture = Ogre::TextureManager::getSingleton().createManual(mName, mGroup, Ogre::TEX_TYPE_2D, width, height, 0,
                                                                 Ogre::PF_BYTE_RGB, Ogre::TU_RENDERTARGET);
    mTarget = mTexture->getBuffer()->getRenderTarget();
    mTarget->setAutoUpdated(false);
    makeViewports();
}

bool PreviewTarget::resize(unsigned width, unsigned height)
{
    width = std::clamp(width, 1u, kMaxSize);
    height = std::clamp(height, 1u, kMaxSize);
    if (width == mWidth && height == mHeight)
        return false;
    mWidth = width;
    mHeight = height;
    if (mWidth > mTexture->getWidth() || mHeight > mTexture->getHeight())
        makeTexture(std::max(roundedUp(mWidth), mTexture->getWidth()),
                    std::max(roundedUp(mHeight), mTexture->getHeight()));
    else
        makeViewports();
    return true;
}

void PreviewTarget::setCompare(CompareMode mode)
{
    mCompare = mode;
    makeViewports();
}

void PreviewTarget::makeViewports()
{
    mTarget->removeAllViewports();
    mViewports[1] = nullptr;
    const bool halves = mCompare == CompareMode::SideBySide && mWidth > 1;
    const unsigned half = halves ? mWidth / 2 : 0;
    // OGRE rounds shares down to pixels: half a pixel more makes them the right ones.
    const auto share = [](unsigned pixels, unsigned all) {
        return (static_cast<float>(pixels) + 0.5f) / static_cast<float>(all);
    };
    const auto add = [&](int number, unsigned left, unsigned width) {
        Ogre::Viewport* viewport =
            mTarget->addViewport(&mCamera, number, share(left, mTexture->getWidth()), 0,
                                 share(width, mTexture->getWidth()), share(mHeight, mTexture->getHeight()));
        viewport->setBackgroundColour(kBackground);
        viewport->setOverlaysEnabled(false);
        viewport->setShadowsEnabled(false);
        viewport->setSkiesEnabled(false);
        mViewports[number] = viewport;
    };
    add(0, 0, halves ? half : mWidth);
    if (mCompare != CompareMode::Off)
        add(1, half, mWidth - half);
    if (mCompare == CompareMode::Wipe)
        mViewports[1]->setClearEveryFrame(true, Ogre::FBT_DEPTH);
    const float aspect =
        static_cast<float>(mViewports[0]->getActualWidth()) / static_cast<float>(mViewports[0]->getActualHeight());
    // What fits into the whole picture fits into a narrow half of it.
    const float up = std::tan(kFieldOfView / 2) / (halves ? std::min(aspect, 1.0f) : 1.0f);
    mCamera.setAspectRatio(aspect);
    mCamera.setFOVy(Ogre::Radian(2 * std::atan(up)));
}

} // namespace lodsmith
