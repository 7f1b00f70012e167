#pragma once

#include "../Peer.h"

#include <functional>
#include <string>
#include <vector>

namespace lodsmith::benchmarks {

/// A rule that says which levels a mesh gets.
struct Configuration {
    std::string name;
    /// The rule in words, kept with the results: another rule under the same name is another configuration.
    std::string rule;
    /// Whether a generator can be asked for such levels.
    std::function<bool(const Peer& generator)> suits;
    /// What is asked of a generator that it suits. The time this takes is part of the generator's.
    std::function<Plan(Subject& subject, const Peer& generator)> plan;
    /// False where shapes alone matter, at triangle counts that another generator had to find: one round, no times.
    bool timed = true;
};

/// Every configuration, in the order of the tables. A further one needs nothing but its entry here.
std::vector<Configuration> makeConfigurations();

/// Asks a generator that the configuration suits for its levels, and it makes them; where the plan has none nothing is made.
struct Making {
    Plan plan;
    double planning = 0.0; ///< seconds
    double seconds = 0.0;  ///< planning included
};
Making make(Subject& subject, const Configuration& configuration, Peer& generator);

/// Names of the configurations that views and tables know.
inline constexpr const char* kHalvings = "halvings";
inline constexpr const char* kClassic = "classic";
inline constexpr const char* kAutomatic = "automatic";
inline constexpr const char* kCandidates = "candidates";

} // namespace lodsmith::benchmarks
