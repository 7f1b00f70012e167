#pragma once

#include <OgreEntity.h>
#include <OgreHardwareVertexBuffer.h>
#include <OgrePrerequisites.h>

/// What OGRE 13 and 14 call otherwise than OGRE 1.12; everything else is the same for all three. 1.12 is built and tested, the
/// others are written from their headers.
namespace lodsmith {

/// The type that entities are listed under in a scene manager. From 14 on the factories are private.
inline const Ogre::String& entityType()
{
#if OGRE_VERSION >= 0x0E0000
    return Ogre::MOT_ENTITY;
#else
    return Ogre::EntityFactory::FACTORY_TYPE_NAME;
#endif
}

/// A colour in 32 bits, and what it is packed as. From 13 on all of them are another name for four normalised bytes, red first.
enum class PackedColour { None, Argb, Abgr };

inline PackedColour packedColour(Ogre::VertexElementType type)
{
#if OGRE_VERSION >= 0x0D0000
    return type == Ogre::VET_UBYTE4_NORM ? PackedColour::Abgr : PackedColour::None;
#else
    if (type == Ogre::VET_COLOUR)
        type = Ogre::VertexElement::getBestColourVertexElementType();
    if (type == Ogre::VET_COLOUR_ARGB)
        return PackedColour::Argb;
    return type == Ogre::VET_COLOUR_ABGR ? PackedColour::Abgr : PackedColour::None;
#endif
}

} // namespace lodsmith
