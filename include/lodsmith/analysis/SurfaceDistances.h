#pragma once

#include <lodsmith/core/Export.h>
#include <lodsmith/core/MeshView.h>
#include <lodsmith/core/Progress.h>
#include <lodsmith/core/Result.h>

#include <vector>

namespace lodsmith {

/// How far each vertex of a mesh is from another mesh's surface, as a heat map shows it: for each vertex buffer of `from`, in
/// the order of MeshView::vertexBuffers, one distance a vertex in world units, to the closest point of all triangles of `to`
/// (by Embree). Where both meshes have equally many poses, it is the largest over rest and all poses (but for those in which `to`
/// has no triangle left). Vertices that no triangle of `from` uses have 0. But for rounding to float, none is greater than
/// the maximum of measureDeviation().
///
/// Errors: IndexOutOfRange, InvalidGeometry (a referenced position is not finite), with submesh and index or vertex;
/// Unsupported when `to` has no triangle with three different positions while `from` has any triangle, or on a processor
/// without Embree; Cancelled; OutOfMemory.
/// Thread-safe; uses the calling thread only; throws nothing.
///
/// @param progress may be null
LODSMITH_API Result<std::vector<std::vector<float>>> surfaceDistances(const MeshView& from, const MeshView& to,
                                                                      Progress* progress = nullptr);

} // namespace lodsmith
