#include <lodsmith/ogre/QueuedProgressiveMeshGenerator.h>

#include "GenerationQueue.h"
#include "MainThread.h"
#include "QueueParts.h"

#include <lodsmith/core/Assert.h>

#include <OgreRoot.h>

#include <cmath>
#include <utility>

namespace lodsmith {

QueuedProgressiveMeshGenerator::QueuedProgressiveMeshGenerator(const QueueOptions& options)
    : QueuedProgressiveMeshGenerator(options, QueueParts{})
{
}

QueuedProgressiveMeshGenerator::QueuedProgressiveMeshGenerator(const QueueOptions& options, QueueParts parts)
{
    assertMainThread();
    LODSMITH_ASSERT(Ogre::Root::getSingletonPtr(), "the queue has to be made after Ogre::Root");
    mQueue = std::make_shared<GenerationQueue>(options, std::move(parts));
    mInjector.reset(new PMInjector(mQueue, options.frameBudget));
}

QueuedProgressiveMeshGenerator::~QueuedProgressiveMeshGenerator()
{
    assertMainThread();
    mQueue->shutDown();
}

Result<Done> QueuedProgressiveMeshGenerator::generateLodLevels(const LodConfig& config, float priority)
{
    assertMainThread();
    LODSMITH_ASSERT(config.mesh, "generateLodLevels() needs a mesh");
    LODSMITH_ASSERT(!std::isnan(priority), "a priority has to be a number");
    // Checking the settings may load manual levels, and whoever listens to that may destroy this object.
    const std::shared_ptr<GenerationQueue> queue = mQueue;
    return queue->add(config, priority);
}

Result<Done> QueuedProgressiveMeshGenerator::generateAutoconfiguredLodLevels(const Ogre::MeshPtr& mesh, float priority,
                                                                             const AutomaticLods& automatic)
{
    assertMainThread();
    LODSMITH_ASSERT(mesh, "generateAutoconfiguredLodLevels() needs a mesh");
    const Result<LodConfig> config = checkedAutomaticConfig(mesh, automatic);
    if (!config)
        return config.error();
    return generateLodLevels(config.value(), priority);
}

void QueuedProgressiveMeshGenerator::setPriority(const Ogre::MeshPtr& mesh, float priority)
{
    assertMainThread();
    LODSMITH_ASSERT(!std::isnan(priority), "a priority has to be a number");
    mQueue->setPriority(mesh, priority);
}

void QueuedProgressiveMeshGenerator::cancel(const Ogre::MeshPtr& mesh)
{
    assertMainThread();
    mQueue->cancel(mesh);
}

void QueuedProgressiveMeshGenerator::cancelAll()
{
    assertMainThread();
    mQueue->cancelAll();
}

bool QueuedProgressiveMeshGenerator::isQueued(const Ogre::MeshPtr& mesh) const
{
    assertMainThread();
    return mQueue->contains(mesh);
}

std::size_t QueuedProgressiveMeshGenerator::queued() const
{
    assertMainThread();
    return mQueue->size();
}

std::size_t QueuedProgressiveMeshGenerator::heldBytes() const
{
    assertMainThread();
    return mQueue->heldBytes();
}

const std::shared_ptr<LodCache>& QueuedProgressiveMeshGenerator::cache() const
{
    assertMainThread();
    return mQueue->cache();
}

PMInjectorSignaler& QueuedProgressiveMeshGenerator::signals()
{
    assertMainThread();
    return mQueue->signals();
}

} // namespace lodsmith
