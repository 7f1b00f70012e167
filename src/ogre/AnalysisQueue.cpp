#include "AnalysisQueue.h"

#include "BackgroundThread.h"
#include "OgreGuard.h"

#include <lodsmith/ogre/LevelReader.h>

#include <algorithm>
#include <chrono>
#include <system_error>
#include <utility>

namespace lodsmith {

void AnalysisQueue::add(std::shared_ptr<AnalysisTask> task)
{
    mWaiting.push_back(std::move(task));
}

bool AnalysisQueue::work()
{
    bool worked = deliverComputed();
    if (!mShutDown && !mCurrent)
        worked = beginNext() || worked;
    if (isIdle())
        mLastRead.reset();
    return worked || mComputation.valid();
}

void AnalysisQueue::finishAll()
{
    while (!mShutDown && work())
        if (mComputation.valid())
            mComputation.wait();
}

bool AnalysisQueue::isIdle() const
{
    return !mCurrent
           && std::none_of(mWaiting.begin(), mWaiting.end(), [](const auto& task) { return task->isRunning(); });
}

void AnalysisQueue::shutDown()
{
    mShutDown = true;
    std::deque<std::shared_ptr<AnalysisTask>> tasks = std::exchange(mWaiting, {});
    if (mCurrent)
        tasks.push_front(mCurrent);
    for (const std::shared_ptr<AnalysisTask>& task : tasks)
        task->end();
    if (mComputation.valid())
        mComputation.get();
    mCurrent.reset();
    mLastRead.reset();
}

bool AnalysisQueue::deliverComputed()
{
    if (!mComputation.valid() || mComputation.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
        return false;
    mComputation.get();
    const std::shared_ptr<AnalysisTask> task = std::exchange(mCurrent, nullptr);
    task->deliver();
    return true;
}

bool AnalysisQueue::beginNext()
{
    while (!mWaiting.empty() && !mWaiting.front()->isRunning())
        mWaiting.pop_front();
    if (mWaiting.empty())
        return false;
    const std::shared_ptr<AnalysisTask> task = mWaiting.front();
    mWaiting.pop_front();
    mCurrent = task;
    Result<Done> begun = read(*task);
    if (mShutDown)
        return true;
    if (begun && task->isRunning())
        begun = compute(*task);
    if (mComputation.valid())
        return true;
    mCurrent.reset();
    if (!begun) {
        task->fail(begun.error());
        task->deliver();
    }
    return true;
}

Result<Done> AnalysisQueue::read(AnalysisTask& task)
{
    const Ogre::MeshPtr mesh = task.mesh();
    if (!mesh)
        return Error{ErrorCode::NotFound, "the mesh has gone or has changed since it was asked about"};
    return guarded(mesh->getName(), [&]() -> Result<Done> {
        const Result<std::shared_ptr<const MeshData>> levelZero = levelZeroOf(mesh);
        return levelZero ? task.read(*mesh, levelZero.value()) : Result<Done>(levelZero.error());
    });
}

Result<std::shared_ptr<const MeshData>> AnalysisQueue::levelZeroOf(const Ogre::MeshPtr& mesh)
{
    const MeshState state(*mesh);
    if (mLastRead && mLastRead->mesh.lock() == mesh && mLastRead->state == state)
        return mLastRead->data;
    mLastRead.reset();
    Result<std::shared_ptr<const MeshData>> data = LevelReader::readLevelZero(*mesh);
    if (data)
        mLastRead = LevelZero{mesh, state, data.value()};
    return data;
}

Result<Done> AnalysisQueue::compute(AnalysisTask& task)
{
    try {
        mComputation = std::async(std::launch::async, [&task] {
            becomeBackgroundThread();
            task.compute();
        });
    } catch (const std::system_error&) {
        return Error{ErrorCode::OutOfMemory, "the system has no room for another thread"};
    }
    return Done{};
}

} // namespace lodsmith
