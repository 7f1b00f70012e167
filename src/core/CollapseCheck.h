#pragma once

#include "OneRing.h"

namespace lodsmith {

/// Tells whether a collapse keeps the surface sound: no face turned over, at rest or in a pose, nothing pinched, no face doubled, no edge with
/// more faces than before, no piece gone.
///
/// The link condition (Dey, Edelsbrunner, Guha and Nekhayev 1999), with a border counting as one more vertex, read so that
/// surfaces which are non-manifold already may still collapse as long as they get no worse.
class CollapseCheck {
public:
    explicit CollapseCheck(CollapseMesh& mesh) : mMesh(mesh) {}

    /// Whether at rest everything stays sound. Aims the ring at this neighbour on the way.
    bool allows(OneRing& ring, std::uint32_t neighbour) const;

    /// Whether no pose has a face turned over, either. Takes longer.
    bool allowsInPoses(const OneRing& ring, std::uint32_t neighbour) const;

private:
    static bool leavesLine(const OneRing& ring, std::uint32_t neighbour);
    bool turnsFaceOver(const OneRing& ring, std::uint32_t destination) const;
    bool isOrdinary(const OneRing& ring, std::uint32_t neighbour) const;
    bool keepsLink(const OneRing& ring, std::uint32_t neighbour) const;
    bool keepsLinkAtHub(const OneRing& ring, std::uint32_t neighbour) const;
    bool keepsEdgesManifold(const OneRing& ring, std::uint32_t neighbour) const;

    std::uint32_t facesBetween(std::uint32_t a, std::uint32_t b) const;

    CollapseMesh& mMesh;
};

} // namespace lodsmith
