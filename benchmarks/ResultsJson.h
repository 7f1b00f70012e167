#pragma once

#include "SubjectResult.h"

#include <iosfwd>
#include <vector>

namespace lodsmith::benchmarks {

/// All figures as one JSON array, an object a mesh, for other programs.
void writeJson(std::ostream& out, const std::vector<SubjectResult>& results);

} // namespace lodsmith::benchmarks
