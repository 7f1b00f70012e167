#pragma once

#include "Lanes.h"
#include "OneRing.h"

namespace lodsmith {

/// A ring as it stands in four poses.
class PosedRing {
public:
    /// @param ring has to be posed
    PosedRing(const OneRing& ring, std::size_t group) : mRing(ring), mGroup(group), mHere(ring.here[group]) {}

    /// From the vertex to a neighbour.
    Lanes3 edge(std::uint32_t neighbour) const { return mRing.there[neighbour][mGroup].position - mHere.position; }

    /// Mean normal that the input has at a neighbour, in steps.
    Lanes3 meanNormal(std::uint32_t neighbour) const { return mRing.there[neighbour][mGroup].meanNormal(); }

    /// Normal of a face, of twice the area's length.
    Lanes3 area(const OneRing::RingFace& face) const { return cross(edge(face.second), edge(face.third)); }

    /// ... of all faces together.
    Lanes3 wholeArea() const
    {
        Lanes3 sum{};
        for (std::uint32_t i = 0; i < mRing.faceCount; ++i)
            sum = sum + area(mRing.faces[i]);
        return sum;
    }

private:
    const OneRing& mRing;
    std::size_t mGroup;
    const Poses::Group& mHere;
};

} // namespace lodsmith
