// Mohr, Gleicher: Deformation Sensitive Decimation. University of Wisconsin, 2003.

#include "PosedPlanes.h"

#include <limits>

namespace lodsmith {

namespace {

constexpr float kLeastFloat = std::numeric_limits<float>::min();

} // namespace

void PosedPlanes::measure(const OneRing& ring, std::size_t groups, float bonus, const HeldEdge* held,
                          std::uint32_t heldCount)
{
    std::fill(mSum, mSum + ring.neighbourCount, 0.0f);
    for (std::size_t group = 0; group < groups; ++group) {
        const PosedRing posed(ring, group);
        mCount = 0;
        addFaces(posed, ring, bonus);
        for (std::uint32_t i = 0; i < heldCount; ++i)
            addHeld(posed, ring, held[i]);
        for (std::uint32_t i = 0; i < ring.neighbourCount; ++i) {
            const Lanes3 edge = posed.edge(i);
            Lanes sum = Lanes::all(0.0f);
            for (std::uint32_t p = 0; p < mCount; ++p) {
                const Lanes distance = dot(mPlanes[p].normal, edge);
                sum = sum + mPlanes[p].weight * (distance * distance);
            }
            mSum[i] += sum.sum();
        }
    }
}

/// A face without area, as all are in lanes that stand for no pose, has no normal and so costs nothing.
void PosedPlanes::addFaces(const PosedRing& posed, const OneRing& ring, float bonus)
{
    for (std::uint32_t i = 0; i < ring.faceCount; ++i) {
        const Lanes3 area = posed.area(ring.faces[i]);
        const Lanes doubled = sqrt(dot(area, area));
        const Lanes inverse = Lanes::of([&](std::size_t k) { return 1.0f / std::max(doubled[k], kLeastFloat); });
        mPlanes[mCount++] = {area * inverse, doubled * 0.5f + Lanes::all(bonus)};
    }
}

void PosedPlanes::addHeld(const PosedRing& posed, const OneRing& ring, const HeldEdge& held)
{
    const OneRing::Neighbour& end = ring.neighbours[held.neighbour];
    Lanes3 upright = mPlanes[end.firstFace].normal;
    if (end.firstFace != end.lastFace)
        upright = upright + mPlanes[end.lastFace].normal;
    mPlanes[mCount++] = {cross(upright, posed.edge(held.neighbour)), Lanes::all(held.weight)};
}

} // namespace lodsmith
