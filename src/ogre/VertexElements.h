#pragma once

#include <OgreHardwareVertexBuffer.h>

#include <cstddef>

namespace lodsmith {

/// One element of consecutive vertices in a locked buffer.
struct ElementSource {
    const unsigned char* data = nullptr; ///< the first vertex's element; needs no alignment
    std::size_t stride = 0;              ///< bytes from one vertex to the next
    Ogre::VertexElementType type = Ogre::VET_FLOAT3;
};

/// How many numbers an element of this type holds, 1..4; 0 for a type that is not known here.
int componentCount(Ogre::VertexElementType type);

/// Copies `components` numbers of each of `count` vertices to `out`, tightly packed. Normalised types become -1..1 or 0..1,
/// other whole numbers keep their value, packed colours become r, g, b, a. What the element lacks is 0, a fourth number 1.
/// The type must be known.
void copyElement(const ElementSource& source, std::size_t count, int components, float* out);

/// copyElement() of four components for a colour: plain bytes count as shares of 255, as OGRE draws them.
void copyColour(const ElementSource& source, std::size_t count, float* out);

} // namespace lodsmith
