#pragma once

#include "CollapseMesh.h"

#include <lodsmith/core/MeshView.h>
#include <lodsmith/core/Simplify.h>

namespace lodsmith {

/// Fills the wedges' attribute vectors: every attribute scaled by its weight to a length in the mesh's scaled frame, so
/// that squared differences add to squared distances (Hoppe 1999). Channels that are the same all over are left out.
///
/// Normals are made unit. Texture coordinates are divided by the set's mean texel density. Bone weights enter as a
/// projection of the (sparse) weight vector to four dimensions, pose offsets as their own length, projected to four
/// dimensions when there are more (Johnson and Lindenstrauss 1984; random signs as in Achlioptas 2003).
void buildAttributes(CollapseMesh& mesh, const MeshView& view, const AttributeWeights& weights);

} // namespace lodsmith
