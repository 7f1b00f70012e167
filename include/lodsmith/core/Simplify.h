#pragma once

#include <lodsmith/core/Export.h>
#include <lodsmith/core/LodChain.h>
#include <lodsmith/core/MeshView.h>
#include <lodsmith/core/Progress.h>
#include <lodsmith/core/Result.h>

#include <functional>
#include <vector>

namespace lodsmith {

/// How far one level goes. Every target is stated against the original mesh, not against the level before.
struct LevelTarget {
    enum class Kind {
        Proportional, ///< share of the vertices removed, 0..1
        Constant,     ///< number of vertices removed, >= 0; more than there are means all
        Triangles,    ///< triangles kept, >= 0
        Deviation,    ///< bound on the deviation, world units, >= 0; with Metric::Quadric no collapse costs more
        CollapseCost, ///< dearest collapse allowed, a length in world units, >= 0 (see Metric)
    };
    Kind kind = Kind::Proportional;
    double amount = 0.5;
};

/// What a collapse costs.
enum class Metric {
    /// Squared distance to the planes around the removed vertex, weighted by area and without memory of earlier levels
    /// (Garland and Heckbert 1997; Lindstrom and Turk 1998), with wedge attributes in the same sum (Hoppe 1999).
    /// Of a mesh with poses, the mean over rest and all poses. As a length: sqrt(cost / weight), the weight being the areas and a
    /// share of the mean triangle's.
    Quadric,
    /// The metric of 2012: edge length times how much the surface bends along it. A length in itself; see docs/simplifier.md.
    Curvature,
};

/// How much a difference in an attribute counts beside geometric deviation; 0 ignores it. Only Metric::Quadric uses them.
/// The measure of each is a length, so that results do not depend on a mesh's size: see docs/simplifier.md.
struct AttributeWeights {
    float normal = 0.001f; ///< per unit of normal difference, in shares of the bounding radius
    float uv = 0.1f;       ///< per world unit that the texture slides, at the mesh's mean texel density
    float colour = 0.01f;  ///< per unit of colour difference, in shares of the bounding radius
    float bone = 0.01f;    ///< per unit of bone weight difference, in shares of the bounding radius
};

struct SimplifyOptions {
    Metric metric = Metric::Quadric;
    AttributeWeights weights;
    bool lockBorders = false; ///< vertices on a border stay, so that neighbouring chunks go on matching
    bool lockSeams = false;   ///< vertices with more than one wedge stay
    /// Threads that a large mesh may be worked on by, the caller's included; 0 counts as 1. Changes no result.
    unsigned threads = 1;
};

/// Simplifies a mesh by half-edge collapse and returns one level for each target, from a single pass.
///
/// The vertex buffers stay as they are: a level is a set of index lists into them. All wedges of a position move
/// together, so the levels have no cracks; no level has a degenerate or doubled triangle, a hole or a non-manifold edge
/// that the input did not have, and no triangle turns by more than 78 degrees in one collapse, or against the surface
/// that the input has at its corners; nor by that much at once in a pose that has not folded it before. Small pieces that hang
/// together with nothing else vanish whole, all but the last; a
/// target of a count is passed by one of them only where nothing else is left. A target that cannot be reached is no
/// error: the level holds what could be done and says why it stopped.
///
/// Errors: InvalidSetting (a target or weight out of range or not a number), InvalidGeometry (a referenced position or
/// attribute is not finite, a position is beyond +-1e18, a pose is more than 100 million times as large as rest, an importance outside 0..1), IndexOutOfRange, Cancelled,
/// OutOfMemory; with submesh and index where there is one.
/// Deterministic: the same input gives the same bytes on every run, compiler and optimisation level.
/// Thread-safe for different meshes, and for one mesh that nobody changes; throws nothing.
///
/// @param targets  one per level, any kinds mixed; a level that removes nothing beyond the one before is `skipped`
/// @param progress may be null
/// @param inputRead called once, on the calling thread, as soon as nothing that `mesh` points to is needed any more: a caller
///                  that has no other use for the streams can free them then, which lowers the peak by a fifth. Must not
///                  throw. Not called when an error comes first.
LODSMITH_API Result<LodChain> simplify(const MeshView& mesh, const std::vector<LevelTarget>& targets,
                                       const SimplifyOptions& options = {}, Progress* progress = nullptr,
                                       const std::function<void()>& inputRead = {});

} // namespace lodsmith
