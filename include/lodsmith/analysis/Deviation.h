#pragma once

#include <lodsmith/core/Export.h>
#include <lodsmith/core/MeshView.h>
#include <lodsmith/core/Progress.h>
#include <lodsmith/core/Result.h>

#include <cstdint>

namespace lodsmith {

/// Mean, root mean square and maximum of something over a surface, area-weighted.
struct DeviationFigures {
    double mean = 0.0;
    double rms = 0.0;
    double maximum = 0.0;
};

/// How a simplified mesh differs from its original, as measured on samples of both surfaces.
///
/// The figures are two-sided: samples of each surface look for the closest point of the other; mean and rms give both
/// sides the same weight, the maximum is the larger one. Mean and rms come from the area samples, the maximum from them
/// and all vertices. Every distance is that of two points really there, so a maximum is never too high.
///
/// Where both meshes have equally many poses, `surface` counts each of them like rest: mean and rms are over rest and all poses
/// alike, the maximum is the largest. Neither triangles with two corners at one position at rest are counted, nor poses in which
/// either mesh has no triangle left. All else is at rest.
///
/// Where several triangles meet at the closest point (an edge, a corner, the two sides of a wall), attributes are
/// compared with those facing the same way as the sample, and among them with the nearest normal and the nearest UV: a
/// seam is no deviation from itself. Where the closest point is beyond a UV seam by a hair, because the surface it lies
/// on bends, the sample's own side of the seam is taken if it lies within twice the distance. When both meshes have
/// equally many submeshes, attributes are compared within the same submesh, at its own closest point; where it is empty
/// on the other side, normals are compared with what is there and UVs are left out.
///
/// The counts of edges work on positions: equal ones (exactly equal; -0 is 0) are one, in both meshes together,
/// whatever their attributes, poses or bones: what counts as a crack is what gapes at rest. Degenerate and repeated
/// triangles of either mesh make no edges. An edge of the simplified mesh stands for edges of the original when the
/// original has a path of such edges between its two ends that meets no other vertex of the simplified mesh on the way;
/// that is what collapses along a chain of edges leave of it. So the vertices must be a subset of the original's: a
/// mesh remodelled by other means has all its borders counted as new.
struct Deviation {
    DeviationFigures surface; ///< world units; distance to the closest point of the other surface
    /// Radians between shading normals at closest points, 0..pi; the face's normal where a mesh has none.
    DeviationFigures normal;
    DeviationFigures uv; ///< UV units in set 0 at closest points; zero unless both meshes have it
    /// Triangles that face against the original at their corners, where the two surfaces are the same, rather than
    /// against what is nearest, which may be the other side of a thin sheet. Against means that the cosine between the
    /// normals, averaged over the three corners, is below -0.02 (a degree beyond standing across): both with all
    /// original triangles that have a vertex there, weighted by their angles, and with those that leave the corner in
    /// the direction of the triangle's centre (to 0.05 radians; the one that agrees best). One corner where it agrees
    /// with the latter to 45 degrees clears a triangle: it reaches round an edge. A corner that is no vertex of the
    /// original is compared with the triangles at its closest point. So a triangle of the original itself is never
    /// flipped. With corners on sharp edges only, or far larger than the bumps at its corners, a triangle is hard to
    /// judge: some flipped ones are missed there, and some others counted. Triangles thinner than 1e-6 of their length
    /// are not counted.
    std::uint32_t flippedTriangles = 0;
    /// Edges with one triangle that do not stand for such edges: cracks and holes.
    std::uint32_t newBorderEdges = 0;
    /// Edges with more than two triangles that do not stand for edges which had at least as many. Here the path may
    /// run over any edges, as long as a non-manifold edge meets each vertex on the way: such an edge may move along.
    std::uint32_t newNonManifoldEdges = 0;
    /// Same three positions as an earlier triangle of the same submesh and winding.
    std::uint32_t repeatedTriangles = 0;
    std::uint32_t degenerateTriangles = 0; ///< two corners at one position
    std::uint32_t poses = 0;               ///< that `surface` counts besides rest
};

struct DeviationOptions {
    std::uint32_t samples = 100000; ///< points on each surface, at rest and in each pose, besides all vertices; >= 1
    std::uint32_t seed = 1;         ///< of the sampling; the same seed gives the same figures
};

/// Measures `simplified` against `original` (Cignoni, Rocchini and Scopigno 1998, "Metro"), closest points by Embree.
///
/// Errors: those of meshStatistics(); InvalidGeometry also for a normal or a coordinate of UV set 0 that is not finite;
/// InvalidSetting for no samples; Unsupported when one of the two has no triangle with three different positions while
/// the other has, or on a processor without Embree; Cancelled.
/// Thread-safe; uses the calling thread only; throws nothing.
///
/// @param progress may be null
LODSMITH_API Result<Deviation> measureDeviation(const MeshView& original, const MeshView& simplified,
                                                const DeviationOptions& options = {}, Progress* progress = nullptr);

} // namespace lodsmith
