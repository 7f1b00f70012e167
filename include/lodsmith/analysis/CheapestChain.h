#pragma once

#include <lodsmith/analysis/StreamingCost.h>
#include <lodsmith/core/Export.h>
#include <lodsmith/core/Result.h>

#include <cstddef>
#include <vector>

namespace lodsmith {

/// A level that could be stored.
struct CandidateLevel {
    double bytes = 0.0;     ///< that it would take, > 0
    double deviation = 0.0; ///< metres: bound on the distance from the original's surface, >= 0
};

/// What may be seen of the switches.
struct ErrorBudget {
    double pixels = 1.0;                     ///< deviation on screen when a level appears, > 0
    double viewportHeight = 1080.0;          ///< pixels, > 0
    double fieldOfView = 0.7853981633974483; ///< radians, vertical, between 0 and pi
    std::size_t mostLevels = 8;              ///< level 0 included, >= 1
};

/// A chain of some of the candidates.
struct CheapestChain {
    std::vector<std::size_t> candidates; ///< by number, level 0 (which is candidate 0) first
    std::vector<double> distances;       ///< metres: where levels 1, 2... appear
    StreamingCost cost;
};

/// The distance in metres from which on a deviation, seen at a right angle in the middle of the screen, covers no more
/// pixels than the budget allows. Settings out of range are misuse.
LODSMITH_API double sightDistance(double deviation, const ErrorBudget& budget);

/// The chain of least streaming cost among all that can be picked from candidates, when each level appears at the
/// sightDistance() of its deviation: no sooner, since that would be seen, and no later, since that would cost more.
/// Every level but 0 is drawn over no less than the settings' smallestArea: none is there for what a level counts that
/// nobody sees. Exact: no choice of at most mostLevels candidates is cheaper by more than a billionth; of those that
/// cost the same, one with the fewest levels.
///
/// A share depends on the sum of all areas, so that costs do not simply add up: a ratio is minimised by
/// Dinkelbach's method (On nonlinear fractional programming, 1967), each step of which is a shortest path over the
/// candidates, found by dynamic programming. Time grows with the square of the candidates and that of mostLevels.
///
/// Errors: InvalidSetting (anything out of range or not finite, no candidates, candidate 0 with a deviation).
/// Deterministic; thread-safe; throws nothing but std::bad_alloc.
///
/// @param candidates 0 is the original and always chosen; the others in any order
LODSMITH_API Result<CheapestChain> cheapestChain(const std::vector<CandidateLevel>& candidates,
                                                 const ErrorBudget& budget, const StreamingCostSettings& settings);

} // namespace lodsmith
