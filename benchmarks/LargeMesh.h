#pragma once

#include <iosfwd>
#include <string>

namespace lodsmith::benchmarks {

/// What this program is started with, followed by an origin, to print the peak of one chain (tryInOwnProcess()).
inline constexpr const char* kPeakCommand = "--peak-of";

/// A chain of four levels on a million triangles with one thread and with as many as there are processors, in turn. Throws when the
/// levels are not the same. A Markdown table of medians. Needs an OgreSession.
void printThreads(std::ostream& out, int rounds);

/// The same chain, with one thread, on one and on ten million triangles: time and memory.
void printTenMillion(std::ostream& out, int rounds);

/// Prints how far memory rises while a chain is made, kB.
void printPeak(std::ostream& out, const std::string& origin);

} // namespace lodsmith::benchmarks
