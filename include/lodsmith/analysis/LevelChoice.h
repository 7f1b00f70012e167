#pragma once

#include <lodsmith/core/Export.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lodsmith {

/// A level that may be shown as soon as the mesh is small enough on screen for it.
struct LevelCandidate {
    double size = 0.0; ///< length on screen from which on it may be shown, in any unit; above 0
    std::uint32_t triangles = 0;
};

/// What a level has to save so that it is worth its index buffer: a tenth of the mesh's triangles, while the distance doubles
/// once.
constexpr double kWorthOfLevel = 0.1;

/// Of candidate levels those that leave the fewest triangles to draw while the mesh recedes, each doubling of the distance
/// counting the same, from the first candidate's size to half of the last one's; where a level that is chosen counts as
/// kWorthOfLevel of the mesh's triangles over one doubling. Each level is shown from its own size on until the next one takes over.
///
/// The best choice there is, by dynamic programming over the candidates. Of two that are equally good it is the one with
/// fewer levels, then the one whose levels begin farther away.
///
/// Returns the chosen candidates' indices, rising; none for a mesh without triangles. Thread-safe.
///
/// @param triangles  of the mesh itself
/// @param candidates sizes strictly falling, else misuse; triangles need not fall
/// @param most       the most levels to choose
LODSMITH_API std::vector<std::size_t> chooseLevels(std::uint32_t triangles,
                                                   const std::vector<LevelCandidate>& candidates, std::size_t most);

} // namespace lodsmith
