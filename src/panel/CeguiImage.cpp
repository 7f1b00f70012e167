#include "CeguiImage.h"

#include <CEGUI/BasicImage.h>
#include <CEGUI/ImageManager.h>
#include <CEGUI/Renderer.h>
#include <CEGUI/System.h>
#include <CEGUI/Texture.h>

namespace lodsmith {

bool CeguiImage::isFree(const std::string& name)
{
    return CEGUI::System::getSingletonPtr() && !CEGUI::ImageManager::getSingleton().isDefined(name)
           && !CEGUI::System::getSingleton().getRenderer()->isTextureDefined(name);
}

CeguiImage::CeguiImage(const std::string& name)
    : mName(name), mTexture(&CEGUI::System::getSingleton().getRenderer()->createTexture(name)),
      mImage(static_cast<CEGUI::BasicImage*>(&CEGUI::ImageManager::getSingleton().create("BasicImage", name)))
{
    mImage->setAutoScaled(CEGUI::ASM_Disabled);
}

CeguiImage::~CeguiImage()
{
    if (!isAlive())
        return;
    CEGUI::ImageManager::getSingleton().destroy(*mImage);
    CEGUI::System::getSingleton().getRenderer()->destroyTexture(*mTexture);
}

bool CeguiImage::isAlive() const
{
    return CEGUI::System::getSingletonPtr() && CEGUI::ImageManager::getSingleton().isDefined(mName)
           && &CEGUI::ImageManager::getSingleton().get(mName) == mImage;
}

void CeguiImage::show(const Canvas& canvas)
{
    const CEGUI::Sizef size(static_cast<float>(canvas.width()), static_cast<float>(canvas.height()));
    const CEGUI::Rectf all(CEGUI::Vector2f(0, 0), size);
    if (mTexture->getOriginalDataSize() == size) {
        mTexture->blitFromMemory(canvas.data(), all);
        return;
    }
    mTexture->loadFromMemory(canvas.data(), size, CEGUI::Texture::PF_RGBA);
    mImage->setTexture(mTexture);
    mImage->setArea(all);
}

} // namespace lodsmith
