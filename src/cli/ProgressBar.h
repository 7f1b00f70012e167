#pragma once

#include <chrono>
#include <cstddef>
#include <cstdio>
#include <string>

namespace lodsmith::cli {

/// How far a batch is, as shown to people.
struct ProgressState {
    std::size_t done = 0;  ///< files
    std::size_t total = 0; ///< files
    double partly = 0.0;   ///< files' worth of work done on the unfinished ones
    double seconds = 0.0;  ///< since the start
    std::string file;      ///< worked on at present
};

/// The line of a progress bar, at most `width` columns: bar, files done, rate, time left, current file.
std::string progressLine(const ProgressState& state, std::size_t width);

/// Shows on a stream how far a batch is: a bar that is drawn again in place on a terminal, and otherwise one line a
/// finished file, when there is more than one.
class ProgressBar {
public:
    ProgressBar(std::FILE* stream, std::size_t files);

    /// Draws the bar, not more often than people can see.
    void show(const std::string& file, double partly);
    void finished(const std::string& file, double seconds, bool ok);
    /// A file that took no work.
    void passed() { ++mState.done; }
    /// Takes the bar off the terminal, before something else is written.
    void clear();

private:
    std::FILE* mStream;
    bool mIsTerminal;
    bool mIsShown = false;
    ProgressState mState;
    std::chrono::steady_clock::time_point mStart;
    std::chrono::steady_clock::time_point mLastShown;
};

} // namespace lodsmith::cli
