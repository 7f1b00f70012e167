#pragma once

#include "StoredRuns.h"

#include <string>
#include <vector>

namespace lodsmith::benchmarks {

enum class Verdict { Same, Better, Worse };

/// One generator under one configuration, over all meshes: how its time has changed.
struct TimeChange {
    std::string configuration;
    std::string generator;
    std::size_t meshes = 0;
    double ratio = 1.0;  ///< new over old, geometric mean
    double chance = 1.0; ///< that there is no change, after as many questions as there are changes
    Verdict verdict = Verdict::Same;
};

/// One mesh whose figure has changed.
struct MeshChange {
    RunKey key;
    std::string figure;
    double before = 0.0; ///< ms or kB
    double after = 0.0;
    double ratio = 1.0;  ///< of times: each in shares of the reference
    double chance = 0.0; ///< as above; 0 for a figure that is no matter of chance
    Verdict verdict = Verdict::Same;
};

/// One generator under one configuration: how a figure of its levels has changed.
struct FigureChange {
    std::string configuration;
    std::string generator;
    std::string figure;
    std::size_t levels = 0; ///< compared
    std::size_t better = 0;
    std::size_t worse = 0;
    double ratio = 1.0;     ///< new over old, geometric mean; NaN for counts of faults
    double worst = 1.0;     ///< the ratio of the level that lost most; for faults how many it has more
    std::string worstLevel; ///< mesh and level; empty when none lost
    Verdict verdict = Verdict::Same;
};

struct Comparison {
    std::size_t compared = 0; ///< runs that both have, Lodsmith's own
    double shift = 0.0;       ///< logarithm: how far the other generators' times have moved, as a median
    double spread = 0.0;      ///< logarithm: how much that varies between meshes; what single times may vary by
    std::vector<TimeChange> times;
    std::vector<MeshChange> meshes;    ///< those that are better or worse
    std::vector<FigureChange> figures; ///< those that have changed at all
    std::vector<std::string> notes;

    bool hasRegression() const;
};

/// What has become better or worse with Lodsmith's own generators between two builds.
///
/// Times are processor times, so that other programs hardly count, and are taken as shares of the reference that ran just before, which no build changes. What the other generators' times have
/// moved by is the machine's doing. A generator under a configuration is faster or slower when the geometric mean over the
/// meshes has moved by more than 5% beyond that, and chance explains that (signTest()) in less than one comparison of a
/// hundred; a single mesh when it has moved by more than 10%, more than four times what the other generators' meshes vary by,
/// and the rounds (rankTest()) say so as clearly. The chance is for all questions of a kind together, so that many meshes make
/// no false alarms.
///
/// Everything else is the same from run to run: figures are better or worse where a level differs by more than 1%, or the mean
/// over all levels by more than 0.1%, faults where there is one more or less, memory by more than 10% and a megabyte.
///
/// @param sameMachine  false leaves times and memory out
Comparison compare(const StoredRuns& before, const StoredRuns& after, bool sameMachine);

} // namespace lodsmith::benchmarks
