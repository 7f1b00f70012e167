#pragma once

#include <lodsmith/analysis/Deviation.h>
#include <lodsmith/analysis/DeviationCurve.h>
#include <lodsmith/core/Export.h>
#include <lodsmith/core/Result.h>
#include <lodsmith/core/Simplify.h>

#include <OgreFrameListener.h>
#include <OgreMesh.h>

#include <functional>
#include <memory>
#include <vector>

namespace lodsmith {

class AnalysisQueue;
class AnalysisTask;

/// A request to a LevelAnalyser, in the hand of whoever made it. Destroying it cancels. It may outlive the analyser. Main
/// thread only.
class LODSMITH_API AnalysisJob {
public:
    ~AnalysisJob();
    AnalysisJob(const AnalysisJob&) = delete;
    AnalysisJob& operator=(const AnalysisJob&) = delete;

    /// Share of the computation that is done, 0..1; 0 while the job waits.
    float fraction() const;
    /// Whether its callback is still to come. Not any more when that is called.
    bool isRunning() const;
    /// The callback is never called, and is destroyed here. Cancelling a job that has ended changes nothing.
    void cancel();

private:
    friend class LevelAnalyser;
    explicit AnalysisJob(std::shared_ptr<AnalysisTask> task);

    std::shared_ptr<AnalysisTask> mTask;
};

/// Figures about a mesh's levels, made in the background for a program that goes on drawing: one job at a time, in the order in
/// which they came. All functions return at once.
///
///     lodsmith::LevelAnalyser analyser;
///     auto job = analyser.measure(mesh, 2, [](const lodsmith::Result<lodsmith::Deviation>& deviation) { ... });
///     if (!job) log(describe(job.error()));
///     // ... keep the job; some frames later the callback is called.
///
/// A job's turn comes in update(), when the job before it has ended. Only then is its mesh read, the level as it is by then,
/// so that a mesh that gets new levels meanwhile is measured with these. Jobs of one mesh that follow one another share what
/// was read of level 0. Jobs keep no mesh alive or loaded, but load the mesh of a hand-made level. A mesh that by then was
/// destroyed, unloaded, loaded again or marked as changed (Ogre::Resource::getStateCount()) since the request is an error
/// (NotFound). Once read, a job works on its copy: whatever becomes of the mesh, the figures are delivered, and are about the
/// mesh as it was read.
///
/// Callbacks are called in update() and finishAll() and nowhere else, with nothing locked. They may ask for more, cancel any
/// job, and destroy the analyser. Each is called once at most, with the figures or the error: those of the function that
/// computes, of LevelReader::read(), and OutOfMemory also when the system has no room for a thread. Callbacks, and what they
/// hold, are destroyed on the main thread.
///
/// Made after Ogre::Root. It listens to OGRE's frames and works at the start of each; without a render loop, call update() now
/// and then. Destroying it, at any moment, cancels all jobs and waits for the computation to notice. The thread stands behind
/// those that draw, as the queue's workers do. Main thread only, as MeshReader.
class LODSMITH_API LevelAnalyser : public Ogre::FrameListener {
public:
    using JobPtr = std::shared_ptr<AnalysisJob>;
    template <class Figures>
    using Callback = std::function<void(const Result<Figures>&)>;

    LevelAnalyser();
    ~LevelAnalyser() override;
    LevelAnalyser(const LevelAnalyser&) = delete;
    LevelAnalyser& operator=(const LevelAnalyser&) = delete;

    // Errors of all three: InvalidSetting (no such level now), Unsupported (a mesh without submeshes, as one is before it is
    // loaded); then there is no job, and `done` is never called. `mesh` must not be null, nor `done` empty.

    /// measureDeviation() of a level against level 0, generated or hand-made.
    Result<JobPtr> measure(const Ogre::MeshPtr& mesh, unsigned level, Callback<Deviation> done,
                           const DeviationOptions& options = {});

    /// surfaceDistances() from level 0's vertices to a level: for each vertex buffer, in the order of MeshReader's
    /// view().vertexBuffers, one distance a vertex.
    Result<JobPtr> distances(const Ogre::MeshPtr& mesh, unsigned level, Callback<std::vector<std::vector<float>>> done);

    /// deviationCurve() of level 0.
    Result<JobPtr> curve(const Ogre::MeshPtr& mesh, const SimplifyOptions& options, unsigned points,
                         Callback<std::vector<LevelPoint>> done);

    /// One frame's work: calls the callback of the job that has ended, and reads the mesh of the next.
    void update();

    /// Works until no job is left; sleeps while there is nothing but to wait. For programs without frames.
    void finishAll();

    /// Whether no job waits, runs, or has its callback to come. A cancelled job that has not stopped yet runs.
    bool isIdle() const;

    bool frameStarted(const Ogre::FrameEvent& event) override;

private:
    template <class Figures, class Read>
    Result<JobPtr> request(const Ogre::MeshPtr& mesh, unsigned level, Callback<Figures> done, Read read);

    std::shared_ptr<AnalysisQueue> mQueue;
};

} // namespace lodsmith
