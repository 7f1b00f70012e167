#include "GenerationQueue.h"

#include "LodPlan.h"
#include "MemoryNeed.h"
#include "OgreGuard.h"

#include <algorithm>
#include <limits>
#include <thread>
#include <utility>
#include <vector>

namespace lodsmith {

namespace {

unsigned threadsFor(const QueueOptions& options)
{
    if (options.workers > 0)
        return options.workers;
    // 0 when the system does not tell.
    const unsigned processors = std::thread::hardware_concurrency();
    return processors > 1 ? processors - 1 : 1;
}

} // namespace

GenerationQueue::GenerationQueue(const QueueOptions& options, QueueParts parts)
    : mMemoryLimit(options.memoryLimit), mCache(options.cache), mParts(std::move(parts)),
      mWorker(threadsFor(options), mParts.compute)
{
}

Result<Done> GenerationQueue::add(const LodConfig& config, float priority)
{
    const Result<LodPlan> plan = guarded(config.mesh->getName(), [&] { return planLods(config); });
    if (!plan)
        return plan.error();
    if (mShutDown)
        return Done{};
    cancel(config.mesh);
    const RequestNumber number = ++mLastNumber;
    Request request{config.mesh, MeshState(*config.mesh), config, RequestOrder{priority, number}};
    request.config.mesh.reset();
    mToCopy.insert(request.order);
    mByMesh.emplace(config.mesh, number);
    mRequests.emplace(number, std::move(request));
    collect();
    if (mWorker.hasIdleThread())
        copyNext();
    return Done{};
}

void GenerationQueue::setPriority(const Ogre::MeshPtr& mesh, float priority)
{
    const auto found = mByMesh.find(mesh);
    if (found == mByMesh.end())
        return;
    Request& request = mRequests.at(found->second);
    const RequestOrder before = std::exchange(request.order, RequestOrder{priority, found->second});
    if (mToCopy.erase(before) > 0)
        mToCopy.insert(request.order);
    else if (mReady.erase(before) > 0)
        mReady.insert(request.order);
    else if (request.stage == Stage::Computing)
        mWorker.reorder(before, request.order);
}

void GenerationQueue::cancel(const Ogre::MeshPtr& mesh)
{
    const auto found = mByMesh.find(mesh);
    if (found != mByMesh.end())
        remove(found->second);
}

void GenerationQueue::cancelAll()
{
    while (!mRequests.empty())
        remove(mRequests.begin()->first);
}

void GenerationQueue::work(PMInjector::Milliseconds budget)
{
    const Clock::time_point start = mParts.now();
    collect();
    dropOutdated();
    while (step() && !mShutDown && mParts.now() - start < budget) {
    }
    reportProgress();
}

void GenerationQueue::injectNow()
{
    collect();
    dropOutdated();
    std::vector<RequestNumber> numbers;
    for (const RequestOrder& order : mReady)
        numbers.push_back(order.number);
    for (const RequestNumber number : numbers)
        if (mRequests.count(number) > 0)
            inject(number);
}

void GenerationQueue::finishAll()
{
    constexpr PMInjector::Milliseconds forever(std::numeric_limits<double>::infinity());
    do {
        work(forever);
    } while (!mReady.empty() || mWorker.waitForFinished());
}

void GenerationQueue::shutDown()
{
    mShutDown = true;
    mSignals.injected.clear();
    mSignals.failed.clear();
    mSignals.progress.clear();
    mWorker.stop();
    mRequests.clear();
    mByMesh.clear();
    mToCopy.clear();
    mComputing.clear();
    mReady.clear();
    mHeldBytes = 0;
}

Ogre::MeshPtr GenerationQueue::meshOf(const Request& request)
{
    const std::shared_ptr<Ogre::Mesh> mesh = request.mesh.lock();
    return mesh && MeshState(*mesh) == request.state ? Ogre::MeshPtr(mesh) : Ogre::MeshPtr();
}

LodConfig GenerationQueue::configFor(const Request& request, const Ogre::MeshPtr& mesh)
{
    LodConfig config = request.config;
    config.mesh = mesh;
    return config;
}

void GenerationQueue::remove(RequestNumber number)
{
    const auto found = mRequests.find(number);
    Request& request = found->second;
    mToCopy.erase(request.order);
    mReady.erase(request.order);
    // What a thread is working on holds its memory until the thread has let go of it: see collect().
    if (mComputing.erase(number) > 0 && !mWorker.withdraw(request.order))
        request.progress->cancel();
    else
        mHeldBytes -= request.bytes;
    mByMesh.erase(request.mesh);
    mRequests.erase(found);
}

void GenerationQueue::collect()
{
    for (WorkerJob& job : mWorker.takeFinished()) {
        const auto found = mRequests.find(job.number);
        if (found == mRequests.end()) {
            mHeldBytes -= job.bytes;
            continue;
        }
        mComputing.erase(job.number);
        makeReady(found->second, std::move(job));
    }
}

void GenerationQueue::dropOutdated()
{
    std::vector<RequestNumber> outdated;
    const auto look = [&](RequestNumber number) {
        if (!meshOf(mRequests.at(number)))
            outdated.push_back(number);
    };
    std::for_each(mComputing.begin(), mComputing.end(), look);
    std::for_each(mReady.begin(), mReady.end(), [&](const RequestOrder& order) { look(order.number); });
    for (const RequestNumber number : outdated)
        remove(number);
}

bool GenerationQueue::fits(std::size_t bytes) const
{
    return mHeldBytes == 0 || (mHeldBytes <= mMemoryLimit && bytes <= mMemoryLimit - mHeldBytes);
}

bool GenerationQueue::step()
{
    if (mReady.empty())
        return copyNext();
    inject(mReady.begin()->number);
    return true;
}

void GenerationQueue::inject(RequestNumber number)
{
    Request& request = mRequests.at(number);
    const Ogre::MeshPtr mesh = meshOf(request);
    const LodConfig config = configFor(request, mesh);
    const WorkerJob job = std::move(request.finished);
    remove(number);
    if (!mesh)
        return;
    const Result<LodReport> report = guarded(mesh->getName(), [&]() -> Result<LodReport> {
        if (!*job.computed)
            return job.computed->error();
        return finishLods(config, job.prepared, job.computed->value());
    });
    if (mShutDown)
        return;
    if (report)
        mSignals.injected.emit(mesh, report.value());
    else
        mSignals.failed.emit(mesh, report.error());
}

bool GenerationQueue::copyNext()
{
    if (mToCopy.empty())
        return false;
    const RequestNumber number = mToCopy.begin()->number;
    Request& request = mRequests.at(number);
    const Ogre::MeshPtr mesh = meshOf(request);
    if (!mesh) {
        remove(number);
        return true;
    }
    const LodConfig config = configFor(request, mesh);
    const std::size_t bytes = memoryNeed(config);
    if (!fits(bytes))
        return false;
    mToCopy.erase(mToCopy.begin());
    request.stage = Stage::Copying;
    request.bytes = bytes;
    mHeldBytes += bytes;
    copy(number, config);
    return true;
}

void GenerationQueue::copy(RequestNumber number, const LodConfig& config)
{
    Result<PreparedLods> prepared = guarded(config.mesh->getName(), [&] { return prepareLods(config, mCache); });
    const auto found = mRequests.find(number);
    if (found == mRequests.end())
        return;
    if (prepared)
        compute(found->second, std::move(prepared).value());
    else
        copyFailed(found->second, prepared.error());
}

/// Nothing is emitted from here: this may be within add(), whose caller does not know yet that there is a request.
void GenerationQueue::copyFailed(Request& request, Error error)
{
    mHeldBytes -= std::exchange(request.bytes, 0);
    WorkerJob failed;
    failed.computed = Result<ComputedLods>(std::move(error));
    makeReady(request, std::move(failed));
}

void GenerationQueue::compute(Request& request, PreparedLods prepared)
{
    request.stage = Stage::Computing;
    request.progress = std::make_shared<Progress>();
    mComputing.insert(request.order.number);
    mWorker.submit(WorkerJob{request.order.number, std::move(prepared), request.progress, request.bytes, {}},
                   request.order.priority);
}

void GenerationQueue::makeReady(Request& request, WorkerJob finished)
{
    request.stage = Stage::Ready;
    request.finished = std::move(finished);
    mReady.insert(request.order);
}

void GenerationQueue::reportProgress()
{
    const std::vector<RequestNumber> numbers(mComputing.begin(), mComputing.end());
    for (const RequestNumber number : numbers) {
        const auto found = mRequests.find(number);
        if (found == mRequests.end())
            continue;
        Request& request = found->second;
        const float fraction = request.progress->fraction();
        const Ogre::MeshPtr mesh = meshOf(request);
        if (mesh && fraction > request.toldFraction) {
            request.toldFraction = fraction;
            mSignals.progress.emit(mesh, fraction);
        }
    }
}

} // namespace lodsmith
