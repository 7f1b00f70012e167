#include "ProgressBar.h"

#include "Numbers.h"
#include "Table.h"

#include <algorithm>
#include <cmath>

#include <sys/ioctl.h>
#include <unistd.h>

namespace lodsmith::cli {

namespace {

constexpr std::size_t kBarColumns = 20;
constexpr std::size_t kUsualWidth = 80;
constexpr double kSecondsBetweenDrawings = 0.1;

double secondsBetween(std::chrono::steady_clock::time_point from, std::chrono::steady_clock::time_point to)
{
    return std::chrono::duration<double>(to - from).count();
}

std::size_t terminalWidth(std::FILE* stream)
{
    winsize size = {};
    return ::ioctl(::fileno(stream), TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : kUsualWidth;
}

std::string timeLeft(double seconds)
{
    const auto whole = static_cast<long long>(std::ceil(seconds));
    if (whole < 60)
        return std::to_string(whole) + " s left";
    if (whole < 3600)
        return std::to_string(whole / 60) + " min " + std::to_string(whole % 60) + " s left";
    return std::to_string(whole / 3600) + " h " + std::to_string(whole / 60 % 60) + " min left";
}

} // namespace

std::string progressLine(const ProgressState& state, std::size_t width)
{
    const double work = std::min(static_cast<double>(state.done) + state.partly, static_cast<double>(state.total));
    const double share = state.total > 0 ? work / static_cast<double>(state.total) : 1.0;
    const auto filled = static_cast<std::size_t>(share * kBarColumns);
    std::string line = "[" + std::string(filled, '#') + std::string(kBarColumns - filled, '.') + "] "
                       + std::to_string(state.done) + " of " + std::to_string(state.total);
    if (work > 0.0 && state.seconds > 0.0) {
        const double rate = work / state.seconds;
        line +=
            ", " + formatNumber(rate, 2) + " files/s, " + timeLeft((static_cast<double>(state.total) - work) / rate);
    }
    return (line + ", " + printable(state.file)).substr(0, width);
}

ProgressBar::ProgressBar(std::FILE* stream, std::size_t files)
    : mStream(stream), mIsTerminal(::isatty(::fileno(stream)) != 0), mStart(std::chrono::steady_clock::now())
{
    mState.total = files;
}

void ProgressBar::show(const std::string& file, double partly)
{
    const auto now = std::chrono::steady_clock::now();
    if (!mIsTerminal || secondsBetween(mLastShown, now) < kSecondsBetweenDrawings)
        return;
    mLastShown = now;
    mState.file = file;
    mState.partly = partly;
    mState.seconds = secondsBetween(mStart, now);
    std::fprintf(mStream, "\r%s\033[K", progressLine(mState, terminalWidth(mStream) - 1).c_str());
    std::fflush(mStream);
    mIsShown = true;
}

void ProgressBar::finished(const std::string& file, double seconds, bool ok)
{
    ++mState.done;
    if (mIsTerminal || mState.total < 2)
        return;
    std::fprintf(mStream, "%zu of %zu: %s, %s s%s\n", mState.done, mState.total, printable(file).c_str(),
                 formatNumber(seconds, 3).c_str(), ok ? "" : ", failed");
    std::fflush(mStream);
}

void ProgressBar::clear()
{
    if (!mIsShown)
        return;
    std::fprintf(mStream, "\r\033[K");
    std::fflush(mStream);
    mIsShown = false;
}

} // namespace lodsmith::cli
