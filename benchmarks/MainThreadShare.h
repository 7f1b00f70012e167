#pragma once

#include <iosfwd>

namespace lodsmith::benchmarks {

/// What a mesh costs the main thread when its levels are made there, and when they are made in the background: copying out
/// and putting the levels onto the mesh. A Markdown table over all meshes. Needs an OgreSession.
void printMainThreadShare(std::ostream& out, int rounds);

} // namespace lodsmith::benchmarks
