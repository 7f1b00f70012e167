#pragma once

#include "Peer.h"

namespace lodsmith::benchmarks {

/// meshoptimizer 0.18 as its users run it: each submesh by itself, each level from the one before, positions only,
/// no limit on the error. Its targets are triangle counts, so a share of the vertices becomes that share of each
/// submesh's triangles. Works on plain arrays: reading the mesh and writing it back are not timed.
class MeshoptPeer : public Peer {
public:
    using Peer::Peer;

    bool knows(LevelTarget::Kind kind) const override
    {
        return kind == LevelTarget::Kind::Proportional || kind == LevelTarget::Kind::Triangles;
    }
    double generate(Subject& subject, const Plan& plan) override;
    std::vector<PeerLevel> levels(const Subject& subject) const override;
    void reset(Subject& subject) override;

private:
    /// Positions as meshoptimizer wants them, and 32-bit indices.
    struct Input {
        std::vector<float> positions;
        std::vector<std::uint32_t> indices;
    };
    static std::vector<Input> makeInputs(const MeshView& view);
    static std::vector<std::uint32_t> simplify(const Input& input, const std::vector<std::uint32_t>& from,
                                               std::size_t targetIndices);

    std::vector<LevelIndices> mLevels;
};

} // namespace lodsmith::benchmarks
