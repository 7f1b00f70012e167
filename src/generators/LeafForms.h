#pragma once

#include "Leaves.h"

#include <lodsmith/core/Simplify.h>

namespace lodsmith::generators {

/// Adds forms of a half, a quarter and so on of the triangles to a leaf, down to one, by simplify(). A leaf of several
/// submeshes stays as it is. Errors: those of simplify(), without a place.
Result<Done> addForms(const MeshView& mesh, const SimplifyOptions& options, Leaf& leaf);

} // namespace lodsmith::generators
