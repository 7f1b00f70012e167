#pragma once

#include "MeshState.h"
#include "PMWorker.h"
#include "QueueParts.h"

#include <lodsmith/ogre/LodConfig.h>
#include <lodsmith/ogre/PMInjectorSignaler.h>
#include <lodsmith/ogre/QueuedProgressiveMeshGenerator.h>

#include <chrono>
#include <cstddef>
#include <map>
#include <memory>
#include <set>

namespace lodsmith {

/// The main thread's side of background generation: the table of requests, and the steps that each of them goes through:
///
///     ToCopy -> (Copying) -> Computing -> Ready -> written, and out of the table
///
/// The table knows meshes by weak pointers alone. A request is tied to the state that its mesh was in when it came; the state
/// is looked at again before each step, and in every update while a request holds memory or a worker. That is polling on
/// purpose: a Resource::Listener would have to be taken off each mesh before the queue goes, is called in the middle of
/// OGRE's unloading, and says nothing of a mesh that was never loaded. The look costs two numbers a request.
///
/// Any step may run code of others, in handlers of the signals or in listeners to the loading of manual levels. After such a
/// call nothing that was known of the table holds: requests are looked up again by number.
class GenerationQueue {
public:
    using Clock = std::chrono::steady_clock;

    GenerationQueue(const QueueOptions& options, QueueParts parts);

    Result<Done> add(const LodConfig& config, float priority);
    void setPriority(const Ogre::MeshPtr& mesh, float priority);
    void cancel(const Ogre::MeshPtr& mesh);
    void cancelAll();
    bool contains(const Ogre::MeshPtr& mesh) const { return mByMesh.count(mesh) > 0; }
    std::size_t size() const { return mRequests.size(); }
    std::size_t heldBytes() const { return mHeldBytes; }
    PMInjectorSignaler& signals() { return mSignals; }
    const std::shared_ptr<LodCache>& cache() const { return mCache; }

    /// One frame's work; at least one step however small the budget.
    void work(PMInjector::Milliseconds budget);
    /// Writes what has finished.
    void injectNow();
    /// Works until there is no request left and every thread has let go of its memory.
    void finishAll();
    /// Drops everything, for good: all calls that are under way on the stack return without doing more.
    void shutDown();

private:
    enum class Stage { ToCopy, Copying, Computing, Ready };

    struct Request {
        std::weak_ptr<Ogre::Mesh> mesh;
        MeshState state;
        LodConfig config; ///< without its mesh
        RequestOrder order;
        Stage stage = Stage::ToCopy;
        std::size_t bytes = 0; ///< what it holds
        std::shared_ptr<Progress> progress{};
        float toldFraction = 0.0f;
        WorkerJob finished{}; ///< of a Ready request
    };

    using Requests = std::map<RequestNumber, Request>;

    /// The request's mesh; null when it is not any more what it was.
    static Ogre::MeshPtr meshOf(const Request& request);
    static LodConfig configFor(const Request& request, const Ogre::MeshPtr& mesh);

    void remove(RequestNumber number);
    /// Takes over what the workers have finished; drops what nobody asks for any more.
    void collect();
    void dropOutdated();
    bool fits(std::size_t bytes) const;
    /// Does the next thing there is to do; false when there is none.
    bool step();
    void inject(RequestNumber number);
    /// False when there is nothing to copy, or no room to copy it to.
    bool copyNext();
    void copy(RequestNumber number, const LodConfig& config);
    void copyFailed(Request& request, Error error);
    void compute(Request& request, PreparedLods prepared);
    void makeReady(Request& request, WorkerJob finished);
    void reportProgress();

    const std::size_t mMemoryLimit;
    const std::shared_ptr<LodCache> mCache;
    const QueueParts mParts;
    PMInjectorSignaler mSignals;
    Requests mRequests;
    std::map<std::weak_ptr<Ogre::Mesh>, RequestNumber, std::owner_less<>> mByMesh;
    std::set<RequestOrder> mToCopy;
    std::set<RequestNumber> mComputing;
    std::set<RequestOrder> mReady;
    RequestNumber mLastNumber = 0;
    std::size_t mHeldBytes = 0;
    bool mShutDown = false;
    PMWorker mWorker;
};

} // namespace lodsmith
