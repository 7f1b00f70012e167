#pragma once

#include "Peer.h"

#include <lodsmith/analysis/Deviation.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace lodsmith::benchmarks {

/// A level, counted and measured against the original.
struct MeasuredLevel {
    std::uint32_t target = 0; ///< triangles it should have, or welded vertices (see the maker)
    std::uint32_t triangles = 0;
    std::uint32_t vertices = 0; ///< welded
    std::string stop;
    std::optional<Deviation> deviation; ///< none for a level without triangles
};

using MeasuredChains = std::map<std::string, std::vector<MeasuredLevel>>; ///< by peer

/// The chain at the vertex targets of halvings(), counted but not measured.
std::vector<MeasuredLevel> countChain(Peer& peer, Subject& subject);

/// Chains at one and the same number of triangles for each level: those at which OGRE's curvature metric arrives.
/// Peers without triangle targets appear with the counts at which they arrive; `meshoptimizer`'s counts are worked
/// out once more by `lodsmith`, under the name kLodsmithAtMeshoptimizer, so that the two compare exactly.
MeasuredChains measureAtOgreCounts(const std::vector<Peer*>& peers, Subject& subject, const DeviationOptions& options);

inline constexpr const char* kLodsmithAtMeshoptimizer = "lodsmith-at-meshoptimizer";

/// True when a level came within 2% (or two triangles) of its target: only such levels are compared.
bool reached(const MeasuredLevel& level);

std::vector<MeasuredLevel> measureLevels(const Subject& subject, const std::vector<PeerLevel>& levels,
                                         const std::vector<std::uint32_t>& targets, const DeviationOptions& options);

} // namespace lodsmith::benchmarks
