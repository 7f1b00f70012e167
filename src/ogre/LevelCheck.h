#pragma once

#include <lodsmith/core/Result.h>

#include <OgreMesh.h>

#include <string>

namespace lodsmith {

/// Nothing, or InvalidSetting when the mesh does not have the level.
inline Result<Done> checkLevel(const Ogre::Mesh& mesh, unsigned level)
{
    const unsigned levels = mesh.getNumLodLevels();
    if (level < levels)
        return Done{};
    return Error{ErrorCode::InvalidSetting,
                 "there is no level " + std::to_string(level) + ", the mesh has " + std::to_string(levels)
                     + " with level 0",
                 mesh.getName()};
}

} // namespace lodsmith
