#pragma once

#include <lodsmith/core/Export.h>
#include <lodsmith/core/Result.h>
#include <lodsmith/ogre/AutomaticLods.h>
#include <lodsmith/ogre/LodConfig.h>
#include <lodsmith/ogre/PMInjector.h>
#include <lodsmith/ogre/PMInjectorSignaler.h>

#include <cstddef>
#include <memory>

namespace lodsmith {

class LodCache;
struct QueueParts;

struct QueueOptions {
    /// Threads that compute; 0: one fewer than the processor has, at least one.
    unsigned workers = 0;
    /// Bytes that copied meshes and finished levels may hold while they wait. Beyond it a request waits with its configuration
    /// alone. One request is always allowed, however large. The memory in which a worker simplifies comes on top.
    std::size_t memoryLimit = std::size_t(256) << 20;
    /// What the injector may spend a frame (PMInjector::setBudget()).
    PMInjector::Milliseconds frameBudget{2.0};
    /// Where generated levels are looked for and kept from one start to the next, docs/cache.md; null for nowhere. The workers
    /// read and write it, and may share it with other queues and generators.
    std::shared_ptr<LodCache> cache = nullptr;
};

/// Makes LOD levels in the background and attaches them to the mesh: ProgressiveMeshGenerator for a running program, with the
/// same levels to the byte. Every call returns at once.
///
///     lodsmith::QueuedProgressiveMeshGenerator queue;
///     queue.signals().failed.connect([](const Ogre::MeshPtr&, const lodsmith::Error& error) { log(describe(error)); });
///     auto queued = queue.generateAutoconfiguredLodLevels(mesh);
///     if (!queued) log(describe(queued.error()));
///     // ... and some frames later the mesh has its levels.
///
/// A mesh has one request at most: a newer one replaces the older, whether that waits, runs or has finished. Requests are
/// served by priority, greater first, and among equals in the order they came; a new request waits behind its equals.
///
/// The queue keeps no mesh alive or loaded. The result for a mesh that was destroyed, unloaded, loaded again or marked as
/// changed (Ogre::Resource::getStateCount()) after the request is dropped. Whoever changes a mesh's buffers by hand queues
/// it again, or calls Ogre::Resource::_dirtyState().
///
/// Made after Ogre::Root. Destroying it, at any moment, cancels everything and waits for the workers to notice; the requests
/// are dropped and nothing is emitted any more. Main thread only, as MeshReader.
class LODSMITH_API QueuedProgressiveMeshGenerator {
public:
    explicit QueuedProgressiveMeshGenerator(const QueueOptions& options = {});
    ~QueuedProgressiveMeshGenerator();
    QueuedProgressiveMeshGenerator(const QueuedProgressiveMeshGenerator&) = delete;
    QueuedProgressiveMeshGenerator& operator=(const QueuedProgressiveMeshGenerator&) = delete;

    /// Queues a request. Copies at most one mesh, and that only for a worker that has nothing to do; the rest is left to the
    /// injector. Emits nothing. Errors: those of the settings, as MeshWriter::write() has them (InvalidSetting, NotFound,
    /// Unsupported); then nothing is queued and an older request stays. All others come through the signal `failed`.
    /// @param priority any number, for instance the mesh's size on screen; not NaN
    Result<Done> generateLodLevels(const LodConfig& config, float priority = 0.0f);

    /// generateLodLevels() with automaticLodConfig(mesh, automatic). Errors: the same, InvalidSetting for settings out of
    /// range, and InvalidGeometry without a bounding radius.
    Result<Done> generateAutoconfiguredLodLevels(const Ogre::MeshPtr& mesh, float priority = 0.0f,
                                                 const AutomaticLods& automatic = {});

    /// Moves the mesh's request, if there is one. A computation that runs goes on; its injection is moved.
    void setPriority(const Ogre::MeshPtr& mesh, float priority);

    /// Takes the mesh's request back, if there is one: the mesh stays as it is.
    void cancel(const Ogre::MeshPtr& mesh);
    void cancelAll();

    /// Whether the mesh has a request that has not ended.
    bool isQueued(const Ogre::MeshPtr& mesh) const;
    /// Requests that have not ended.
    std::size_t queued() const;
    /// What counts against QueueOptions::memoryLimit now. Of a cancelled computation until it has stopped.
    std::size_t heldBytes() const;

    /// QueueOptions::cache.
    const std::shared_ptr<LodCache>& cache() const;

    PMInjector& injector() { return *mInjector; }
    PMInjectorSignaler& signals();

private:
    friend struct QueueParts;
    QueuedProgressiveMeshGenerator(const QueueOptions& options, QueueParts parts);

    std::shared_ptr<GenerationQueue> mQueue;
    std::unique_ptr<PMInjector> mInjector;
};

} // namespace lodsmith
