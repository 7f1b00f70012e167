#include <lodsmith/ogre/LevelAnalyser.h>

#include "AnalysisQueue.h"
#include "LevelCheck.h"
#include "MainThread.h"

#include <lodsmith/analysis/SurfaceDistances.h>
#include <lodsmith/core/Assert.h>
#include <lodsmith/ogre/LevelReader.h>

#include <OgreRoot.h>

#include <utility>

namespace lodsmith {

namespace {

using LevelZero = std::shared_ptr<const MeshData>;

/// A computation that compares level 0 with a level, which is read here.
/// @param compare (const MeshView& levelZero, const MeshView& level, Progress*), on any thread
template <class Figures, class Compare>
auto readToCompare(unsigned level, Compare compare)
{
    using Compute = typename FiguresTask<Figures>::Compute;
    return [=](const Ogre::Mesh& mesh, const LevelZero& levelZero) -> Result<Compute> {
        Result<LevelData> read = LevelReader::read(mesh, levelZero, level);
        if (!read)
            return read.error();
        const auto data = std::make_shared<const LevelData>(std::move(read).value());
        return Compute([=](Progress* progress) { return compare(levelZero->view(), data->view(), progress); });
    };
}

} // namespace

AnalysisJob::AnalysisJob(std::shared_ptr<AnalysisTask> task) : mTask(std::move(task)) {}

AnalysisJob::~AnalysisJob()
{
    cancel();
}

float AnalysisJob::fraction() const
{
    return mTask->progress().fraction();
}

bool AnalysisJob::isRunning() const
{
    assertMainThread();
    return mTask->isRunning();
}

void AnalysisJob::cancel()
{
    assertMainThread();
    mTask->end();
}

LevelAnalyser::LevelAnalyser() : mQueue(std::make_shared<AnalysisQueue>())
{
    assertMainThread();
    LODSMITH_ASSERT(Ogre::Root::getSingletonPtr(), "the analyser has to be made after Ogre::Root");
    Ogre::Root::getSingleton().addFrameListener(this);
}

LevelAnalyser::~LevelAnalyser()
{
    assertMainThread();
    mQueue->shutDown();
    // OGRE may have been taken down first.
    if (Ogre::Root* root = Ogre::Root::getSingletonPtr())
        root->removeFrameListener(this);
}

template <class Figures, class Read>
Result<LevelAnalyser::JobPtr> LevelAnalyser::request(const Ogre::MeshPtr& mesh, unsigned level, Callback<Figures> done,
                                                     Read read)
{
    assertMainThread();
    LODSMITH_ASSERT(mesh, "the analyser needs a mesh");
    LODSMITH_ASSERT(done, "the analyser needs somebody to tell");
    if (mesh->getNumSubMeshes() == 0)
        return Error{ErrorCode::Unsupported, "the mesh has no submeshes (is it loaded?)", mesh->getName()};
    const Result<Done> checked = checkLevel(*mesh, level);
    if (!checked)
        return checked.error();
    auto task = std::make_shared<FiguresTask<Figures>>(mesh, std::move(read), std::move(done));
    JobPtr job(new AnalysisJob(task));
    mQueue->add(std::move(task));
    return job;
}

Result<LevelAnalyser::JobPtr> LevelAnalyser::measure(const Ogre::MeshPtr& mesh, unsigned level,
                                                     Callback<Deviation> done, const DeviationOptions& options)
{
    return request<Deviation>(mesh, level, std::move(done),
                              readToCompare<Deviation>(level, [options](const MeshView& levelZero,
                                                                        const MeshView& reduced, Progress* progress) {
                                  return measureDeviation(levelZero, reduced, options, progress);
                              }));
}

Result<LevelAnalyser::JobPtr> LevelAnalyser::distances(const Ogre::MeshPtr& mesh, unsigned level,
                                                       Callback<std::vector<std::vector<float>>> done)
{
    using Distances = std::vector<std::vector<float>>;
    return request<Distances>(mesh, level, std::move(done), readToCompare<Distances>(level, surfaceDistances));
}

Result<LevelAnalyser::JobPtr> LevelAnalyser::curve(const Ogre::MeshPtr& mesh, const SimplifyOptions& options,
                                                   unsigned points, Callback<std::vector<LevelPoint>> done)
{
    using Points = std::vector<LevelPoint>;
    using Compute = FiguresTask<Points>::Compute;
    return request<Points>(mesh, 0, std::move(done),
                           [=](const Ogre::Mesh&, const LevelZero& levelZero) -> Result<Compute> {
                               return Compute([=](Progress* progress) {
                                   return deviationCurve(levelZero->view(), options, points, progress);
                               });
                           });
}

// A callback may destroy this object; the queue lives on until it has returned.

void LevelAnalyser::update()
{
    assertMainThread();
    const std::shared_ptr<AnalysisQueue> queue = mQueue;
    queue->work();
}

void LevelAnalyser::finishAll()
{
    assertMainThread();
    const std::shared_ptr<AnalysisQueue> queue = mQueue;
    queue->finishAll();
}

bool LevelAnalyser::isIdle() const
{
    assertMainThread();
    return mQueue->isIdle();
}

bool LevelAnalyser::frameStarted(const Ogre::FrameEvent&)
{
    update();
    return true;
}

} // namespace lodsmith
