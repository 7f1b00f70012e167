#include "Overlay.h"

#include <OgreFontManager.h>
#include <OgreMaterialManager.h>
#include <OgreOverlay.h>
#include <OgreOverlayContainer.h>
#include <OgreOverlayManager.h>
#include <OgrePass.h>
#include <OgreResourceGroupManager.h>
#include <OgreTechnique.h>
#include <OgreTextAreaOverlayElement.h>
#include <OgreViewport.h>

namespace lodsmith::samples {

namespace {

constexpr Ogre::Real kMargin = 12, kLineHeight = 20, kHeight = 4 * kLineHeight, kWidth = 480; // pixels
constexpr const char* kGroup = "overlay";

/// The font that comes with OGRE, from an archive of which nothing else is wanted.
Ogre::FontPtr loadFont()
{
    auto& resources = Ogre::ResourceGroupManager::getSingleton();
    resources.createResourceGroup(kGroup);
    resources.addResourceLocation(LODSMITH_OGRE_MEDIA_DIR "/packs/SdkTrays.zip", "Zip", kGroup);
    Ogre::FontPtr font = Ogre::FontManager::getSingleton().create("overlay", kGroup);
    font->setType(Ogre::FT_TRUETYPE);
    font->setSource("cuckoo.ttf");
    font->setTrueTypeSize(kLineHeight);
    font->setTrueTypeResolution(72);
    font->load();
    return font;
}

Ogre::MaterialPtr makeShade()
{
    Ogre::MaterialPtr shade = Ogre::MaterialManager::getSingleton().create("shade", Ogre::RGN_DEFAULT);
    Ogre::Pass* pass = shade->getTechnique(0)->getPass(0);
    pass->setSceneBlending(Ogre::SBT_TRANSPARENT_ALPHA);
    pass->setLightingEnabled(false);
    pass->setDepthCheckEnabled(false);
    pass->createTextureUnitState()->setColourOperationEx(Ogre::LBX_SOURCE1, Ogre::LBS_MANUAL, Ogre::LBS_CURRENT,
                                                         Ogre::ColourValue::Black);
    pass->getTextureUnitState(0)->setAlphaOperation(Ogre::LBX_SOURCE1, Ogre::LBS_MANUAL, Ogre::LBS_CURRENT, 0.45f);
    return shade;
}

} // namespace

Overlay::Overlay(const Ogre::Viewport& viewport)
{
    auto& overlays = Ogre::OverlayManager::getSingleton();
    auto* panel = static_cast<Ogre::OverlayContainer*>(overlays.createOverlayElement("Panel", "panel"));
    panel->setMetricsMode(Ogre::GMM_PIXELS);
    panel->setPosition(kMargin, static_cast<Ogre::Real>(viewport.getActualHeight()) - kMargin - kHeight);
    panel->setDimensions(kWidth, kHeight);
    panel->setMaterial(makeShade());
    auto* text = static_cast<Ogre::TextAreaOverlayElement*>(overlays.createOverlayElement("TextArea", "text"));
    text->setMetricsMode(Ogre::GMM_PIXELS);
    text->setPosition(kMargin, kLineHeight / 2);
    text->setCharHeight(kLineHeight);
    text->setFontName(loadFont()->getName(), kGroup);
    panel->addChild(text);
    Ogre::Overlay* overlay = overlays.create("figures");
    overlay->add2D(panel);
    overlay->show();
    mText = text;
}

void Overlay::show(const std::string& text)
{
    mText->setCaption(text);
}

} // namespace lodsmith::samples
