#pragma once

#include "SubjectResult.h"

#include <iosfwd>
#include <vector>

namespace lodsmith::benchmarks {

/// Markdown tables, each with a heading, one row a mesh, geometric means last.
void printTables(std::ostream& out, const std::vector<SubjectResult>& results);

} // namespace lodsmith::benchmarks
