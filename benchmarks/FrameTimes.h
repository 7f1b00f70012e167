#pragma once

#include <iosfwd>

namespace lodsmith::benchmarks {

/// Frame times of a program that draws while 500 meshes get their levels in the background, and while none do; and how much of
/// each frame the queue took. A Markdown table. Opens a window on a display of its own; no OgreSession may be alive.
void printFrameTimes(std::ostream& out);

} // namespace lodsmith::benchmarks
