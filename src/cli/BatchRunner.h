#pragma once

#include "ChildProcess.h"
#include "ProgressBar.h"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace lodsmith::cli {

/// One file of a batch.
struct BatchJob {
    std::string file;                                     ///< as people know it; errors without a file get this one
    std::uint64_t inputBytes = 0;                         ///< the need of memory, and its limit, grow with it
    std::vector<std::filesystem::path> outputDirectories; ///< swept when the child dies while writing
    ChildWork work;
    std::function<std::optional<Json>()>
        known{}; ///< an outcome that needs no work; asked here, when the job's turn comes
};

struct BatchOptions {
    unsigned workers = 1;          ///< children at a time, >= 1
    double secondsAFile = 600.0;   ///< wall time a child may take; 0 for no limit
    std::uint64_t memoryBytes = 0; ///< for the children that run at a time, by estimate; 0 for no bound
};

/// Gets the outcome of job number `job`; called in the order of the jobs, as early as that order allows.
using BatchSink = std::function<void(std::size_t job, const Result<Json>& outcome)>;

/// Works on files in child processes, several at a time, so that none of them can harm the others.
///
/// A child may use 4 GiB of address space and 64 times its input on top. How much it will need is estimated from its input
/// (see memoryNeed()); jobs start in their order, and one that does not fit beside those that run waits for them, and the
/// others wait behind it. One that fits nowhere runs alone.
///
/// An interrupt or a request to terminate ends all children, clears up after them and then ends this process the same way.
class BatchRunner {
public:
    /// Bytes of memory that work on an input of so many bytes takes, at most and about.
    static std::uint64_t memoryNeed(std::uint64_t inputBytes);

    explicit BatchRunner(const BatchOptions& options, ProgressBar& progress) : mOptions(options), mProgress(progress) {}

    void run(const std::vector<BatchJob>& jobs, const BatchSink& sink);

private:
    struct Running {
        std::size_t job;
        std::uint64_t memoryNeed;
        std::unique_ptr<ChildProcess> child;
    };

    bool hasRoom(std::uint64_t memoryNeed) const;
    void startMore(const std::vector<BatchJob>& jobs);
    void start(std::size_t number, const BatchJob& job);
    void waitForNews() const;
    void collectFinished(const std::vector<BatchJob>& jobs);
    void deliver(const BatchSink& sink);
    void showProgress(const std::vector<BatchJob>& jobs);
    void abandon(const std::vector<BatchJob>& jobs);

    BatchOptions mOptions;
    ProgressBar& mProgress;
    std::vector<Running> mRunning;
    std::vector<std::optional<Result<Json>>> mOutcomes;
    std::size_t mNextToStart = 0;
    std::size_t mNextToDeliver = 0;
};

} // namespace lodsmith::cli
