#pragma once

#include "GenerationSteps.h"

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace lodsmith {

/// Counts up with every request, so that no two are ever taken for one another.
using RequestNumber = std::uint64_t;

/// Whose turn it is: greater priority first, and among equals the earlier request.
struct RequestOrder {
    float priority = 0.0f;
    RequestNumber number = 0;

    bool operator<(const RequestOrder& other) const
    {
        return priority != other.priority ? priority > other.priority : number < other.number;
    }
};

/// What is computed on a worker's thread; computeLods() but for tests.
using ComputeFunction = std::function<Result<ComputedLods>(PreparedLods&, Progress*)>;

/// A request as the threads know it: plain arrays and a number.
struct WorkerJob {
    RequestNumber number = 0;
    PreparedLods prepared;
    std::shared_ptr<Progress> progress;           ///< shared with the main thread
    std::size_t bytes = 0;                        ///< what the main thread counts for it
    std::optional<Result<ComputedLods>> computed; ///< set when the job is finished
};

/// Threads that compute levels. They never see an object of OGRE's, nor a pointer to one.
///
/// Whatever the computation throws becomes the job's error. Between two threads a job moves as the node of a list, so that
/// handing one over allocates nothing and cannot fail. The members are for one thread, the main thread. (std::thread and not
/// a pool of a library: those that are at hand, as boost::asio::thread_pool, take work in the order it came and give none
/// back.)
class PMWorker {
public:
    /// Starts `threads` threads (at least 1), or as many as the system has room for.
    PMWorker(unsigned threads, ComputeFunction compute);
    ~PMWorker();
    PMWorker(const PMWorker&) = delete;
    PMWorker& operator=(const PMWorker&) = delete;

    void submit(WorkerJob job, float priority);
    /// Moves a job within the queue; false when it does not wait any more.
    bool reorder(RequestOrder from, RequestOrder to);
    /// Takes a job out of the queue; false when it does not wait any more. A running one is cancelled by its Progress.
    bool withdraw(RequestOrder order);
    /// The jobs that have finished since the last call, in the order in which they did. A cancelled one holds no arrays.
    std::list<WorkerJob> takeFinished();
    /// Sleeps until there is a job that has finished and was not taken yet. False when there is none to wait for.
    bool waitForFinished();
    /// Whether a thread would take a job at once.
    bool hasIdleThread();
    /// Drops what waits and what has finished, cancels what runs, and returns when all threads have ended. For good.
    void stop();

private:
    void run();

    const ComputeFunction mCompute;
    std::mutex mMutex; ///< guards what follows, but for the content of running jobs, and mThreads
    std::condition_variable mWorkCame;
    std::condition_variable mWorkDone;
    std::list<WorkerJob> mWaiting;
    std::map<RequestOrder, std::list<WorkerJob>::iterator> mQueue; ///< of mWaiting
    std::list<WorkerJob> mRunning;
    std::list<WorkerJob> mFinished;
    bool mStopping = false;
    std::vector<std::thread> mThreads;
};

} // namespace lodsmith
