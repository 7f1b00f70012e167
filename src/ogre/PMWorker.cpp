#include "PMWorker.h"

#include "BackgroundThread.h"

#include <exception>
#include <new>
#include <system_error>
#include <utility>

namespace lodsmith {

namespace {

Result<ComputedLods> computeOrExplain(const ComputeFunction& compute, WorkerJob& job)
{
    try {
        return compute(job.prepared, job.progress.get());
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& exception) {
        return Error{ErrorCode::Unsupported, std::string("the computation failed: ") + exception.what()};
    } catch (...) {
        return Error{ErrorCode::Unsupported, "the computation failed"};
    }
}

/// Nothing may leave a thread, not even for want of the memory to say what it was. The one message here is short enough for
/// a string to hold without allocating.
void compute(const ComputeFunction& function, WorkerJob& job)
{
    try {
        job.computed = computeOrExplain(function, job);
    } catch (...) {
        job.computed = Error{ErrorCode::OutOfMemory, "out of memory"};
    }
    // Nobody waits for it, and large arrays are better freed here than on the main thread.
    if (job.progress->cancelled())
        job.prepared = PreparedLods{};
}

} // namespace

PMWorker::PMWorker(unsigned threads, ComputeFunction compute) : mCompute(std::move(compute))
{
    mThreads.reserve(threads);
    try {
        while (mThreads.size() < threads)
            mThreads.emplace_back([this] { run(); });
    } catch (const std::system_error&) {
        if (mThreads.empty())
            throw;
    }
}

PMWorker::~PMWorker()
{
    stop();
}

void PMWorker::submit(WorkerJob job, float priority)
{
    std::list<WorkerJob> node;
    node.push_back(std::move(job));
    {
        const std::lock_guard<std::mutex> lock(mMutex);
        mQueue.emplace(RequestOrder{priority, node.front().number}, node.begin());
        mWaiting.splice(mWaiting.end(), node);
    }
    mWorkCame.notify_one();
}

bool PMWorker::reorder(RequestOrder from, RequestOrder to)
{
    const std::lock_guard<std::mutex> lock(mMutex);
    auto node = mQueue.extract(from);
    if (node.empty())
        return false;
    node.key() = to;
    mQueue.insert(std::move(node));
    return true;
}

bool PMWorker::withdraw(RequestOrder order)
{
    std::list<WorkerJob> withdrawn;
    const std::lock_guard<std::mutex> lock(mMutex);
    const auto found = mQueue.find(order);
    if (found == mQueue.end())
        return false;
    withdrawn.splice(withdrawn.end(), mWaiting, found->second);
    mQueue.erase(found);
    return true;
}

std::list<WorkerJob> PMWorker::takeFinished()
{
    std::list<WorkerJob> finished;
    const std::lock_guard<std::mutex> lock(mMutex);
    finished.swap(mFinished);
    return finished;
}

bool PMWorker::waitForFinished()
{
    std::unique_lock<std::mutex> lock(mMutex);
    mWorkDone.wait(lock, [this] { return !mFinished.empty() || (mWaiting.empty() && mRunning.empty()); });
    return !mFinished.empty();
}

bool PMWorker::hasIdleThread()
{
    const std::lock_guard<std::mutex> lock(mMutex);
    return mWaiting.size() + mRunning.size() < mThreads.size();
}

void PMWorker::stop()
{
    std::list<WorkerJob> dropped;
    {
        const std::lock_guard<std::mutex> lock(mMutex);
        mStopping = true;
        mQueue.clear();
        dropped.splice(dropped.end(), mWaiting);
        for (const WorkerJob& job : mRunning)
            job.progress->cancel();
    }
    mWorkCame.notify_all();
    for (std::thread& thread : mThreads)
        thread.join();
    mThreads.clear();
    mFinished.clear();
}

void PMWorker::run()
{
    becomeBackgroundThread();
    std::unique_lock<std::mutex> lock(mMutex);
    for (;;) {
        mWorkCame.wait(lock, [this] { return mStopping || !mQueue.empty(); });
        if (mStopping)
            return;
        const auto job = mQueue.begin()->second;
        mQueue.erase(mQueue.begin());
        mRunning.splice(mRunning.end(), mWaiting, job);
        lock.unlock();
        compute(mCompute, *job);
        lock.lock();
        mFinished.splice(mFinished.end(), mRunning, job);
        mWorkDone.notify_all();
    }
}

} // namespace lodsmith
