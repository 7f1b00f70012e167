#include "QueueFixture.h"

#include <OgreRoot.h>
#include <OgreSubMesh.h>

#include <chrono>
#include <utility>

namespace lodsmith::test {

namespace {

// Far beyond what anything here takes: a test that has gone wrong ends too.
constexpr std::chrono::seconds kPatience(60);

} // namespace

ComputeFunction Gate::compute(std::function<void(const PreparedLods&, Progress*)> before)
{
    return [this, before = std::move(before)](PreparedLods& prepared, Progress* progress) {
        struct End {
            ~End()
            {
                const std::lock_guard<std::mutex> lock(gate.mMutex);
                ++gate.mEnds;
                gate.mChanged.notify_all();
            }
            Gate& gate;
        };
        const End end{*this};
        pass(prepared, *progress);
        if (before)
            before(prepared, progress);
        return computeLods(prepared, progress);
    };
}

void Gate::pass(const PreparedLods& prepared, const Progress& progress)
{
    std::unique_lock<std::mutex> lock(mMutex);
    mArrivals.push_back(verticesOf(prepared));
    mChanged.notify_all();
    // Progress wakes nobody up.
    while (!mOpen && mPermits == 0 && !progress.cancelled())
        mChanged.wait_for(lock, std::chrono::milliseconds(1));
    if (!mOpen && mPermits > 0)
        --mPermits;
}

void Gate::open()
{
    const std::lock_guard<std::mutex> lock(mMutex);
    mOpen = true;
    mChanged.notify_all();
}

void Gate::let(int computations)
{
    const std::lock_guard<std::mutex> lock(mMutex);
    mPermits += computations;
    mChanged.notify_all();
}

void Gate::waitForArrivals(std::size_t count)
{
    std::unique_lock<std::mutex> lock(mMutex);
    ASSERT_TRUE(mChanged.wait_for(lock, kPatience, [&] { return mArrivals.size() >= count; }));
}

void Gate::waitForEnds(std::size_t count)
{
    std::unique_lock<std::mutex> lock(mMutex);
    ASSERT_TRUE(mChanged.wait_for(lock, kPatience, [&] { return mEnds >= count; }));
}

std::vector<std::uint32_t> Gate::arrivals()
{
    const std::lock_guard<std::mutex> lock(mMutex);
    return mArrivals;
}

std::uint32_t verticesOf(const PreparedLods& prepared)
{
    return prepared.data.view().vertexBuffers.at(0).vertexCount;
}

void QueueTest::makeQueue(const QueueOptions& options)
{
    QueueParts parts;
    parts.compute = mGate.compute();
    makeQueue(options, std::move(parts));
}

void QueueTest::makeQueue(const QueueOptions& options, QueueParts parts)
{
    mQueue = QueueParts::makeQueue(options, std::move(parts));
    mQueue->signals().injected.connect(
        [this](const Ogre::MeshPtr& mesh, const LodReport&) { mEvents.push_back("injected " + mesh->getName()); });
    mQueue->signals().failed.connect([this](const Ogre::MeshPtr& mesh, const Error& error) {
        mEvents.push_back("failed " + mesh->getName() + ": " + toString(error.code));
    });
}

QueueOptions QueueTest::workers(unsigned count, std::size_t memoryLimit)
{
    QueueOptions options;
    options.workers = count;
    options.memoryLimit = memoryLimit;
    options.frameBudget = std::chrono::hours(1);
    return options;
}

Ogre::MeshPtr QueueTest::grid(const std::string& name, std::uint32_t cells)
{
    return makeOgreMesh(name, makeGrid(cells, cells));
}

LodConfig QueueTest::config(const Ogre::MeshPtr& mesh, const std::vector<double>& removed)
{
    return proportional(mesh, removed);
}

void QueueTest::enqueue(const Ogre::MeshPtr& mesh, float priority)
{
    const auto queued = mQueue->generateLodLevels(config(mesh), priority);
    ASSERT_TRUE(queued) << describe(queued.error());
}

void QueueTest::frame()
{
    Ogre::FrameEvent event{};
    Ogre::Root::getSingleton()._fireFrameStarted(event);
}

std::vector<std::vector<std::uint32_t>> levelsOf(const Ogre::Mesh& mesh)
{
    std::vector<std::vector<std::uint32_t>> lists;
    for (unsigned short i = 0; i < mesh.getNumSubMeshes(); ++i)
        for (const Ogre::IndexData* level : mesh.getSubMesh(i)->mLodFaceList)
            lists.push_back(indicesOf(*level));
    return lists;
}

} // namespace lodsmith::test
