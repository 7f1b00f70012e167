#pragma once

#include "CollapseCost.h"
#include "WedgeMap.h"

namespace lodsmith {

/// Metric::Curvature: the edge's length times how much the surface bends along it, after the system of 2012. Extra costs
/// keep borders and seams; attributes do not count. See docs/simplifier.md for the formula.
class CurvatureCost final : public CollapseCost {
public:
    float guess(const CollapseMesh&, std::uint32_t) const override { return 0.0f; }
    void begin(const CollapseMesh& mesh, const OneRing& ring) override;
    Candidate cheapest() override;
    void reject(int neighbour) override { mCosts[neighbour] = kImpossible; }
    double lengthOf(float cost, const CollapseMesh&, const OneRing&) const override { return cost; }
    float costOf(double length, double) const override { return finite(length); }

private:
    double bend(std::uint32_t neighbour) const;
    double borderBend(std::uint32_t neighbour) const;
    double interiorBend(std::uint32_t neighbour) const;
    double seamPenalty(std::uint32_t neighbour) const;

    const CollapseMesh* mMesh = nullptr;
    const OneRing* mRing = nullptr;
    bool mIsBorder = false;
    double mCosts[OneRing::kMaxNeighbours];
    WedgeMap mWedges;
};

} // namespace lodsmith
