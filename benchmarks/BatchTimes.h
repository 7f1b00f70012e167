#pragma once

#include <iosfwd>

namespace lodsmith::benchmarks {

/// `lodsmith generate` on a thousand copies of all mesh files of at most 100 000 triangles, with automatic levels: with one
/// process at a time and with as many as there are processors, in turn, and once more when everything is up to date. A
/// Markdown table of medians.
void printBatch(std::ostream& out, int rounds);

} // namespace lodsmith::benchmarks
