#pragma once

#include <OgreRenderOperation.h>

#include <cstddef>

namespace lodsmith {

/// Triangles that so many indices make: as a list, strip or fan; 0 for lines and points.
inline std::size_t trianglesIn(Ogre::RenderOperation::OperationType type, std::size_t indexCount)
{
    if (type == Ogre::RenderOperation::OT_TRIANGLE_LIST)
        return indexCount / 3;
    return type >= Ogre::RenderOperation::OT_TRIANGLE_STRIP && indexCount > 2 ? indexCount - 2 : 0;
}

} // namespace lodsmith
