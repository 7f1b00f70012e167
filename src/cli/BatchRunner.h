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
    std::uint64_t inputBytes = 0;                         ///< the memory limit grows with it
    std::vector<std::filesystem::path> outputDirectories; ///< swept when the child dies while writing
    ChildWork work;
};

struct BatchOptions {
    unsigned workers = 1;        ///< children at a time, >= 1
    double secondsAFile = 600.0; ///< wall time a child may take; 0 for no limit
};

/// Gets the outcome of job number `job`; called in the order of the jobs, as early as that order allows.
using BatchSink = std::function<void(std::size_t job, const Result<Json>& outcome)>;

/// Works on files in child processes, several at a time, so that none of them can harm the others.
///
/// A child may use 4 GiB of address space and 64 times its input on top. An interrupt or a request to terminate ends
/// all children, clears up after them and then ends this process the same way.
class BatchRunner {
public:
    explicit BatchRunner(const BatchOptions& options, ProgressBar& progress) : mOptions(options), mProgress(progress) {}

    void run(const std::vector<BatchJob>& jobs, const BatchSink& sink);

private:
    struct Running {
        std::size_t job;
        std::unique_ptr<ChildProcess> child;
    };

    void startMore(const std::vector<BatchJob>& jobs);
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
