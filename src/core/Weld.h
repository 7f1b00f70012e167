#pragma once

#include "CollapseMesh.h"

#include <lodsmith/core/MeshView.h>
#include <lodsmith/core/Result.h>

namespace lodsmith {

/// Builds the collapse mesh of a view: equal positions become one vertex, equal attributes there, in one submesh, one wedge.
///
/// Wedges whose pose offsets or bone weights differ (closed lips) share their vertex, so that they stay together at
/// rest, but have different motion numbers, so that they are never joined. Triangles with two corners at one
/// position are left out. Attributes are not filled in; see buildAttributes().
/// Errors: IndexOutOfRange; InvalidGeometry for a referenced position or attribute that is not finite, a position beyond
/// +-1e18, or an importance outside 0..1.
Result<CollapseMesh> weld(const MeshView& mesh);

} // namespace lodsmith
