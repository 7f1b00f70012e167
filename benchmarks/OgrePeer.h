#pragma once

#include "Peer.h"

namespace lodsmith::benchmarks {

/// OGRE's own MeshLodGenerator with its default settings, on the main thread.
class OgrePeer : public Peer {
public:
    enum class Cost { Curvature, Quadric };

    OgrePeer(std::string name, Cost cost) : Peer(std::move(name)), mCost(cost) {}

    /// Costs of the quadric metric are areas, not lengths.
    bool knows(LevelTarget::Kind kind) const override
    {
        return kind == LevelTarget::Kind::Proportional
               || (kind == LevelTarget::Kind::CollapseCost && mCost == Cost::Curvature);
    }
    double generate(Subject& subject, const Plan& plan) override;
    std::vector<PeerLevel> levels(const Subject& subject) const override;
    void reset(Subject& subject) override { subject.removeLevels(); }

private:
    Cost mCost;
    std::vector<bool> mSkipped;
};

} // namespace lodsmith::benchmarks
