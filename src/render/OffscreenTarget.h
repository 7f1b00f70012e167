#pragma once

#include <OgreTexture.h>

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace lodsmith {

/// Draws what a camera sees into memory. Keeps a texture for each size it has needed, in steps, since to make one takes
/// time.
class OffscreenTarget {
public:
    static constexpr unsigned kMaxSize = 4096;

    /// @param name of the textures, which nothing else in OGRE has, and of their resource group
    OffscreenTarget(const Ogre::String& name, const Ogre::String& group) : mName(name), mGroup(group) {}
    ~OffscreenTarget();
    OffscreenTarget(const OffscreenTarget&) = delete;
    OffscreenTarget& operator=(const OffscreenTarget&) = delete;

    /// Red, green and blue of each pixel, rows from the top. Exceptions are OGRE's.
    /// @param width pixels, 1..kMaxSize
    std::vector<std::uint8_t> draw(Ogre::Camera& camera, unsigned width, unsigned height,
                                   const Ogre::ColourValue& background);

private:
    Ogre::TexturePtr textureFor(unsigned width, unsigned height);

    Ogre::String mName;
    Ogre::String mGroup;
    std::map<std::pair<unsigned, unsigned>, Ogre::TexturePtr> mTextures;
};

} // namespace lodsmith
