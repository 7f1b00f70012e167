#pragma once

#include "SkeletonMoments.h"

#include <lodsmith/core/MeshView.h>

#include <cstddef>
#include <vector>

namespace lodsmith {

/// Picks moments of a skeleton's animations that show a mesh most unlike rest and unlike one another.
///
/// What counts is how bones that share vertices move against each other: by how much one bone would take those vertices
/// elsewhere than the other does, seen from the first, root mean square over the vertices. So walking away or turning round is
/// no difference, and neither are parts that each follow a bone of their own. A bone that stretches its vertices counts too.
/// Greedy: each time the moment that adds most, over all pairs of bones, to what the ones before show of each pair.
///
/// @param most moments at most; fewer when the next would show nothing that is new by a thousandth of the mesh's radius
std::vector<PoseMoment> choosePoses(const MeshView& mesh, SkeletonMoments& skeleton, std::size_t most);

} // namespace lodsmith
