#pragma once

#include <OgreMaterial.h>
#include <OgreTexture.h>

#include <map>
#include <utility>

namespace lodsmith {

/// What parts with alpha-tested materials are painted with instead, so that the holes stay: the first pass of their own
/// material with its first texture as a stencil.
class CutOutMaterials {
public:
    /// @param group of resources that they belong to; lives longer than this object
    explicit CutOutMaterials(const Ogre::String& group) : mGroup(group) {}

    static bool hasHoles(const Ogre::Technique& technique);

    /// Made once for each technique.
    /// @param pattern the texture to paint with; null for grey
    Ogre::Technique* techniqueFor(Ogre::Technique& own, const Ogre::TexturePtr& pattern);

private:
    Ogre::String mGroup;
    std::map<std::pair<Ogre::Technique*, bool>, Ogre::MaterialPtr> mMaterials;
};

} // namespace lodsmith
