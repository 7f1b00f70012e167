#include "BatchRunner.h"

#include "../files/AtomicFile.h"

#include <algorithm>
#include <array>
#include <csignal>

#include <poll.h>

namespace lodsmith::cli {

namespace {

constexpr std::uint64_t kMemoryFloor = std::uint64_t(4) << 30;
constexpr std::uint64_t kMemoryPerInputByte = 64;
constexpr std::uint64_t kNeedFloor = std::uint64_t(64) << 20;
constexpr std::uint64_t kNeedPerInputByte = 16;
constexpr int kPollMilliseconds = 100;

volatile std::sig_atomic_t caughtSignal = 0;

// What ends a program from outside, a closed pipe behind it included.
constexpr std::array<int, 5> kEndings = {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE};

/// Notes such signals while it lives, so that children and their half-written files can be cleared away.
class SignalWatch {
public:
    SignalWatch()
    {
        caughtSignal = 0;
        for (std::size_t i = 0; i < kEndings.size(); ++i)
            watch(kEndings[i], mBefore[i]);
    }
    ~SignalWatch()
    {
        for (std::size_t i = 0; i < kEndings.size(); ++i)
            ::sigaction(kEndings[i], &mBefore[i], nullptr);
        if (caughtSignal != 0)
            ::raise(caughtSignal);
    }
    SignalWatch(const SignalWatch&) = delete;
    SignalWatch& operator=(const SignalWatch&) = delete;

private:
    /// A signal that was ignored before (a job in the background, nohup) stays ignored.
    static void watch(int signal, struct sigaction& before)
    {
        ::sigaction(signal, nullptr, &before);
        struct sigaction action = {};
        action.sa_handler = [](int caught) { caughtSignal = caught; };
        if (before.sa_handler != SIG_IGN)
            ::sigaction(signal, &action, nullptr);
    }

    std::array<struct sigaction, kEndings.size()> mBefore = {};
};

ChildLimits limitsFor(const BatchJob& job, const BatchOptions& options)
{
    return {kMemoryFloor + kMemoryPerInputByte * job.inputBytes, options.secondsAFile};
}

void sweep(const BatchJob& job, pid_t writer)
{
    for (const auto& directory : job.outputDirectories)
        AtomicFile::removeLeftovers(directory, writer);
}

Result<Json> withFile(Result<Json> outcome, const std::string& file)
{
    if (outcome || !outcome.error().file.empty())
        return outcome;
    Error error = outcome.error();
    error.file = file;
    return error;
}

} // namespace

void BatchRunner::run(const std::vector<BatchJob>& jobs, const BatchSink& sink)
{
    const SignalWatch watch;
    mOutcomes.assign(jobs.size(), std::nullopt);
    mNextToStart = mNextToDeliver = 0;
    while (mNextToDeliver < jobs.size()) {
        startMore(jobs);
        waitForNews();
        if (caughtSignal != 0)
            return abandon(jobs);
        collectFinished(jobs);
        deliver(sink);
        showProgress(jobs);
    }
    mProgress.clear();
}

std::uint64_t BatchRunner::memoryNeed(std::uint64_t inputBytes)
{
    return kNeedFloor + kNeedPerInputByte * inputBytes;
}

bool BatchRunner::hasRoom(std::uint64_t memoryNeed) const
{
    if (mRunning.empty() || mOptions.memoryBytes == 0)
        return true;
    for (const Running& running : mRunning)
        memoryNeed += running.memoryNeed;
    return memoryNeed <= mOptions.memoryBytes;
}

void BatchRunner::startMore(const std::vector<BatchJob>& jobs)
{
    for (; mNextToStart < jobs.size() && mRunning.size() < mOptions.workers; ++mNextToStart) {
        const BatchJob& job = jobs[mNextToStart];
        if (!hasRoom(memoryNeed(job.inputBytes)) || caughtSignal != 0)
            return;
        std::optional<Json> known = job.known ? job.known() : std::nullopt;
        if (!known) {
            start(mNextToStart, job);
            continue;
        }
        mProgress.passed();
        mOutcomes[mNextToStart].emplace(std::move(*known));
        // To know takes a while, too: those that run are heard in between.
        for (const Running& running : mRunning)
            running.child->pump();
    }
}

void BatchRunner::start(std::size_t number, const BatchJob& job)
{
    auto child = ChildProcess::start(job.work, limitsFor(job, mOptions));
    if (child)
        mRunning.push_back({number, memoryNeed(job.inputBytes), std::move(child).value()});
    else
        mOutcomes[number].emplace(withFile(child.error(), job.file));
}

void BatchRunner::waitForNews() const
{
    std::vector<pollfd> descriptors;
    for (const Running& running : mRunning)
        for (const int descriptor : {running.child->resultDescriptor(), running.child->messageDescriptor()})
            if (descriptor >= 0)
                descriptors.push_back({descriptor, POLLIN, 0});
    if (!descriptors.empty())
        ::poll(descriptors.data(), descriptors.size(), kPollMilliseconds);
}

void BatchRunner::collectFinished(const std::vector<BatchJob>& jobs)
{
    const auto ended = [&](Running& running) {
        if (running.child->pump())
            return false;
        const pid_t id = running.child->id();
        const double seconds = running.child->seconds();
        const BatchJob& job = jobs[running.job];
        const Result<Json> outcome = withFile(running.child->finish(), job.file);
        if (!outcome)
            sweep(job, id);
        mProgress.finished(job.file, seconds, outcome.ok());
        mOutcomes[running.job].emplace(outcome);
        return true;
    };
    mRunning.erase(std::remove_if(mRunning.begin(), mRunning.end(), ended), mRunning.end());
}

void BatchRunner::deliver(const BatchSink& sink)
{
    for (; mNextToDeliver < mOutcomes.size() && mOutcomes[mNextToDeliver]; ++mNextToDeliver) {
        mProgress.clear();
        sink(mNextToDeliver, *mOutcomes[mNextToDeliver]);
        mOutcomes[mNextToDeliver].emplace(Json());
    }
}

void BatchRunner::showProgress(const std::vector<BatchJob>& jobs)
{
    if (mRunning.empty())
        return;
    double fractions = 0.0;
    for (const Running& running : mRunning)
        fractions += static_cast<double>(running.child->fraction());
    mProgress.show(jobs[mRunning.front().job].file, fractions);
}

void BatchRunner::abandon(const std::vector<BatchJob>& jobs)
{
    for (Running& running : mRunning) {
        const pid_t id = running.child->id();
        running.child.reset();
        sweep(jobs[running.job], id);
    }
    mRunning.clear();
    mProgress.clear();
}

} // namespace lodsmith::cli
