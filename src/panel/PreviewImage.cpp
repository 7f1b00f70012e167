#include "PreviewImage.h"

#include <lodsmith/panel/MeshPreview.h>

#include <CEGUI/BasicImage.h>
#include <CEGUI/ImageManager.h>
#include <CEGUI/RendererModules/Ogre/Renderer.h>
#include <CEGUI/RendererModules/Ogre/Texture.h>
#include <CEGUI/System.h>

namespace lodsmith {

namespace {

CEGUI::OgreRenderer& renderer()
{
    return *static_cast<CEGUI::OgreRenderer*>(CEGUI::System::getSingleton().getRenderer());
}

CEGUI::OgreTexture* makeTexture(const std::string& name, Ogre::TexturePtr texture)
{
    return static_cast<CEGUI::OgreTexture*>(&renderer().createTexture(name, texture));
}

} // namespace

PreviewImage::PreviewImage(const MeshPreview& preview)
    : mPreview(preview), mName(preview.texture()->getName()), mTexture(makeTexture(mName, preview.texture())),
      mImage(static_cast<CEGUI::BasicImage*>(&CEGUI::ImageManager::getSingleton().create("BasicImage", mName)))
{
    mImage->setTexture(mTexture);
    mImage->setAutoScaled(CEGUI::ASM_Disabled);
    follow();
}

PreviewImage::~PreviewImage()
{
    CEGUI::ImageManager::getSingleton().destroy(*mImage);
    renderer().destroyTexture(*mTexture);
}

void PreviewImage::follow()
{
    if (mTexture->getOgreTexture() != mPreview.texture())
        mTexture->setOgreTexture(mPreview.texture());
    mImage->setArea(CEGUI::Rectf(0, 0, static_cast<float>(mPreview.width()), static_cast<float>(mPreview.height())));
}

} // namespace lodsmith
