#pragma once

#include "SubjectResult.h"

#include <iosfwd>
#include <string>
#include <vector>

namespace lodsmith::benchmarks {

/// Errors of all peers at OGRE's triangle counts, those of lodsmith at meshoptimizer's, and everybody's faults.
void printQuality(std::ostream& out, const std::vector<SubjectResult>& results, const std::vector<std::string>& peers);

/// Which vertex targets lodsmith misses by more than 1%, and the reason it gives.
void printTargets(std::ostream& out, const std::vector<SubjectResult>& results);

} // namespace lodsmith::benchmarks
