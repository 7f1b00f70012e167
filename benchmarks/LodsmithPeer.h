#pragma once

#include "Peer.h"

#include <lodsmith/ogre/ProgressiveMeshGenerator.h>

namespace lodsmith::benchmarks {

/// One level a target, at distances of 100, 200 and so on.
LodConfig levelsAtDistances(const Ogre::MeshPtr& mesh, const std::vector<LevelTarget>& targets);

/// ProgressiveMeshGenerator on the loaded mesh, without the time it spends on vertex-cache order.
class LodsmithPeer : public Peer {
public:
    LodsmithPeer(std::string name, SimplifyOptions options) : Peer(std::move(name)), mOptions(options) {}

    const SimplifyOptions* options() const override { return &mOptions; }
    bool knows(LevelTarget::Kind) const override { return true; }
    bool chooses() const override { return true; }
    double generate(Subject& subject, const Plan& plan) override;
    std::vector<PeerLevel> levels(const Subject& subject) const override;
    void reset(Subject& subject) override { subject.removeLevels(); }

private:
    SimplifyOptions mOptions;
    LodReport mReport;
};

} // namespace lodsmith::benchmarks
