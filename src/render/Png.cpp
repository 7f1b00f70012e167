#include <lodsmith/render/Png.h>

#include "../ogre/OgreGuard.h"

#include <OgreDataStream.h>
#include <OgreImage.h>

namespace lodsmith {

namespace {

std::vector<std::uint8_t> divideByAlpha(std::vector<std::uint8_t> rgba)
{
    for (std::size_t i = 0; i < rgba.size(); i += 4)
        for (std::size_t channel = 0; channel < 3 && rgba[i + 3] > 0; ++channel)
            rgba[i + channel] = static_cast<std::uint8_t>((255u * rgba[i + channel] + rgba[i + 3] / 2u) / rgba[i + 3]);
    return rgba;
}

} // namespace

Result<std::string> pngBytes(const Image& image)
{
    return guarded("a picture", [&]() -> Result<std::string> {
        std::vector<std::uint8_t> rgba = divideByAlpha(image.rgba);
        Ogre::Image picture;
        picture.loadDynamicImage(rgba.data(), image.width, image.height, Ogre::PF_BYTE_RGBA);
        return picture.encode("png")->getAsString();
    });
}

} // namespace lodsmith
