#include "OffscreenTarget.h"

#include <OgreCamera.h>
#include <OgreHardwarePixelBuffer.h>
#include <OgreRenderTexture.h>
#include <OgreTextureManager.h>
#include <OgreViewport.h>

namespace lodsmith {

namespace {

constexpr unsigned kStep = 256;

unsigned roundedUp(unsigned size)
{
    return (size + kStep - 1) / kStep * kStep;
}

// OGRE rounds shares down to pixels: half a pixel more makes them the right ones.
float share(unsigned pixels, unsigned all)
{
    return pixels == all ? 1.0f : (static_cast<float>(pixels) + 0.5f) / static_cast<float>(all);
}

} // namespace

OffscreenTarget::~OffscreenTarget()
{
    if (auto* textures = Ogre::TextureManager::getSingletonPtr())
        for (const auto& [size, texture] : mTextures)
            textures->remove(texture);
}

Ogre::TexturePtr OffscreenTarget::textureFor(unsigned width, unsigned height)
{
    Ogre::TexturePtr& texture = mTextures[{roundedUp(width), roundedUp(height)}];
    if (!texture) {
        texture = Ogre::TextureManager::getSingleton().createManual(
            mName + " " + std::to_string(roundedUp(width)) + "x" + std::to_string(roundedUp(height)), mGroup,
            Ogre::TEX_TYPE_2D, roundedUp(width), roundedUp(height), 0, Ogre::PF_BYTE_RGB, Ogre::TU_RENDERTARGET);
        texture->getBuffer()->getRenderTarget()->setAutoUpdated(false);
    }
    return texture;
}

std::vector<std::uint8_t> OffscreenTarget::draw(Ogre::Camera& camera, unsigned width, unsigned height,
                                                const Ogre::ColourValue& background)
{
    const Ogre::TexturePtr texture = textureFor(width, height);
    Ogre::RenderTexture& target = *texture->getBuffer()->getRenderTarget();
    target.removeAllViewports();
    Ogre::Viewport* const viewport =
        target.addViewport(&camera, 0, 0, 0, share(width, texture->getWidth()), share(height, texture->getHeight()));
    viewport->setBackgroundColour(background);
    viewport->setOverlaysEnabled(false);
    viewport->setShadowsEnabled(false);
    viewport->setSkiesEnabled(false);
    target.update();
    std::vector<std::uint8_t> rgb(std::size_t(3) * width * height);
    const Ogre::Box part(0, 0, width, height);
    texture->getBuffer()->blitToMemory(part, Ogre::PixelBox(part, Ogre::PF_BYTE_RGB, rgb.data()));
    return rgb;
}

} // namespace lodsmith
