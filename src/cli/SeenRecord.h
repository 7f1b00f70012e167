#pragma once

#include "JsonRecord.h"

#include <lodsmith/render/SeenLevels.h>

#include <OgreMesh.h>

namespace lodsmith::cli {

/// What was seen of each level of a mesh; docs/cli.md has the members.
Json seenRecords(const Ogre::Mesh& mesh, const std::vector<SeenLevel>& levels);

} // namespace lodsmith::cli
