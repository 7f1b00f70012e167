#include "TopologyDifference.h"

#include "EdgePaths.h"
#include "EdgeUses.h"

#include <algorithm>

namespace lodsmith::analysis {

namespace {

using Triangles = std::vector<WeldedTriangle>;

std::vector<bool> findCollapsed(const Triangles& triangles)
{
    std::vector<bool> collapsed(triangles.size());
    for (std::size_t i = 0; i < triangles.size(); ++i)
        collapsed[i] = triangles[i].collapsed();
    return collapsed;
}

/// Triangles that add nothing to the surface, so that they must not make an edge look manifold.
std::vector<bool> findIdle(const Triangles& triangles)
{
    std::vector<bool> idle = findRepeated(triangles, Repetition::SameWindingAndSubMesh);
    for (std::size_t i = 0; i < triangles.size(); ++i)
        idle[i] = idle[i] || triangles[i].collapsed();
    return idle;
}

std::vector<bool> findKept(const Triangles& simplified, std::uint32_t positionCount)
{
    std::vector<bool> kept(positionCount, false);
    for (const WeldedTriangle& triangle : simplified)
        if (!triangle.collapsed())
            for (const std::uint32_t position : triangle.position)
                kept[position] = true;
    return kept;
}

std::uint32_t countSet(const std::vector<bool>& flags)
{
    return static_cast<std::uint32_t>(std::count(flags.begin(), flags.end(), true));
}

EdgePaths borderPaths(const std::vector<EdgeUse>& original, const std::vector<bool>& kept)
{
    EdgePaths paths(kept);
    forEachEdge(original, [&](const EdgeUse* uses, std::size_t count) {
        if (count == 1)
            paths.add(uses->low, uses->high, 1);
    });
    paths.seal();
    return paths;
}

/// Paths over vertices at non-manifold edges, ranked by triangles. The edges along them need not be non-manifold: at
/// the outline of a two-sided wall, where they are not, a collapse takes the end of a non-manifold edge along.
EdgePaths nonManifoldPaths(const std::vector<EdgeUse>& original, const std::vector<bool>& kept)
{
    std::vector<bool> passable(kept.size(), false);
    forEachEdge(original, [&](const EdgeUse* uses, std::size_t count) {
        if (count > 2)
            passable[uses->low] = passable[uses->high] = true;
    });
    EdgePaths paths(kept);
    forEachEdge(original, [&](const EdgeUse* uses, std::size_t count) {
        if ((kept[uses->low] || passable[uses->low]) && (kept[uses->high] || passable[uses->high]))
            paths.add(uses->low, uses->high, static_cast<std::uint32_t>(count));
    });
    paths.seal();
    return paths;
}

} // namespace

TopologyDifference compareTopology(const Triangles& original, const Triangles& simplified, std::uint32_t positionCount)
{
    TopologyDifference difference;
    difference.repeatedTriangles = countSet(findRepeated(simplified, Repetition::SameWindingAndSubMesh));
    difference.degenerateTriangles = countSet(findCollapsed(simplified));

    const std::vector<bool> kept = findKept(simplified, positionCount);
    const std::vector<EdgeUse> originalUses = sortedEdgeUses(original, findIdle(original));
    const EdgePaths borders = borderPaths(originalUses, kept);
    const EdgePaths nonManifold = nonManifoldPaths(originalUses, kept);

    forEachEdge(sortedEdgeUses(simplified, findIdle(simplified)), [&](const EdgeUse* uses, std::size_t count) {
        if (count == 1 && !borders.join(uses->low, uses->high, 1))
            ++difference.newBorderEdges;
        if (count > 2 && !nonManifold.join(uses->low, uses->high, static_cast<std::uint32_t>(count)))
            ++difference.newNonManifoldEdges;
    });
    return difference;
}

} // namespace lodsmith::analysis
