#pragma once

#include "LayerPictures.h"
#include "Leaves.h"

#include <lodsmith/core/Progress.h>

#include <array>
#include <cstdint>
#include <vector>

namespace lodsmith::generators {

/// By how much leaves may be enlarged.
constexpr std::array<double, 4> kLeafScales = {1.0, 1.25, 1.6, 2.0};

/// A leaf that stays, and how.
struct ChosenLeaf {
    std::uint32_t leaf = 0;
    std::uint32_t form = 0;
    std::uint32_t scale = 0; ///< of kLeafScales
};

/// What a level is made from.
struct ChoiceTask {
    const analysis::SilhouetteFrame& frame;
    const Opacity& opacity;
    const std::vector<Leaf>& leaves;
    const std::vector<std::uint32_t>& candidates; ///< numbers of leaves
    const LayerPictures& original;                ///< the whole mesh
    const LayerPictures& wood;                    ///< what the level has beside leaves
    std::uint32_t triangles = 0;                  ///< most that the leaves may have
    double excessWeight = 1.0; ///< how much worse it is to cover a pixel beyond the original than to miss one
};

struct LeafChoice {
    std::vector<ChosenLeaf> leaves; ///< sorted by leaf
    double kept = 0.0;              ///< share of the original's pixels that are covered at all, 0..1
    double value = 0.0;             ///< how near the picture comes to the original's, less the excess; 1 for the same
};

/// Chooses leaves so that they cover what the original covers and little else. Being cancelled ends it early.
LeafChoice chooseLeaves(const ChoiceTask& task, const Progress* progress);

} // namespace lodsmith::generators
