#pragma once

#include <iosfwd>

namespace lodsmith::benchmarks {

/// How long all meshes take that have at most 100 000 triangles: at once, with one and with two workers, and from the cache.
/// A Markdown table of medians. Needs an OgreSession.
void printThroughput(std::ostream& out, int rounds);

} // namespace lodsmith::benchmarks
