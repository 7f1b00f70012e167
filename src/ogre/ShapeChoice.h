#pragma once

#include "PoseReader.h"

#include <lodsmith/core/MeshView.h>

#include <cstddef>
#include <vector>

namespace lodsmith {

/// Picks poses and morph frames that take vertices farthest from rest and from one another, root mean square. Greedy: each
/// time the one that is farthest from the nearest of those before, and from rest.
///
/// @param most fewer when the next is within a thousandth of the mesh's radius
std::vector<PoseMoment> chooseShapes(const MeshView& mesh, const OffsetMoments& offsets, std::size_t most);

} // namespace lodsmith
