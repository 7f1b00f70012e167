#pragma once

#include "OneRing.h"

namespace lodsmith {

/// Which wedge of the destination each wedge of a collapsing vertex becomes.
///
/// A wedge that shares a face with the destination goes where that face says, so that both sides of a seam that runs
/// along the edge stay on their side. Any other takes the nearest wedge of its own submesh at the destination.
/// Across a split of motion (closed lips) nothing collapses.
class WedgeMap {
public:
    /// False when some wedge has nowhere to go.
    bool build(const CollapseMesh& mesh, const OneRing& ring, std::uint32_t neighbour);

    std::uint32_t count() const { return mCount; }
    std::uint32_t from(std::uint32_t i) const { return mFrom[i]; }
    std::uint32_t to(std::uint32_t i) const { return mTo[i]; }

    std::uint32_t operator()(std::uint32_t wedge) const
    {
        for (std::uint32_t i = 0; i < mCount; ++i)
            if (mFrom[i] == wedge)
                return mTo[i];
        return mTo[0];
    }

private:
    static std::uint32_t matched(const CollapseMesh& mesh, const OneRing& ring, std::uint32_t neighbour,
                                 std::uint32_t wedge);
    static std::uint32_t nearest(const CollapseMesh& mesh, std::uint32_t vertex, std::uint32_t wedge,
                                 std::uint32_t motion);
    static std::uint32_t motionThere(const CollapseMesh& mesh, const OneRing& ring, std::uint32_t neighbour,
                                     std::uint32_t wedge);
    static bool isSplit(const CollapseMesh& mesh, const OneRing& ring, std::uint32_t neighbour);
    static bool motionAllows(const CollapseMesh& mesh, const OneRing& ring, std::uint32_t neighbour);

    std::uint32_t mCount = 0;
    std::uint32_t mFrom[OneRing::kMaxFaces];
    std::uint32_t mTo[OneRing::kMaxFaces];
};

} // namespace lodsmith
