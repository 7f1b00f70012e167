#pragma once

#include "Peer.h"

#include <lodsmith/core/LodChain.h>

namespace lodsmith::benchmarks {

/// simplify() alone, from plain arrays to plain arrays: what compares with meshoptimizer like with like.
class CorePeer : public Peer {
public:
    CorePeer(std::string name, SimplifyOptions options) : Peer(std::move(name)), mOptions(options) {}

    const SimplifyOptions* options() const override { return &mOptions; }
    bool knows(LevelTarget::Kind) const override { return true; }
    double generate(Subject& subject, const Plan& plan) override;
    std::vector<PeerLevel> levels(const Subject& subject) const override;
    void reset(Subject&) override { mChain = {}; }

private:
    SimplifyOptions mOptions;
    LodChain mChain;
};

} // namespace lodsmith::benchmarks
