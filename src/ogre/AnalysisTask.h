#pragma once

#include "MeshState.h"

#include <lodsmith/core/Progress.h>
#include <lodsmith/core/Result.h>
#include <lodsmith/ogre/MeshReader.h>

#include <functional>
#include <memory>
#include <new>
#include <optional>
#include <utility>

namespace lodsmith {

/// A request for figures: read and delivered on the main thread, computed on another in between. What it is about is plain
/// arrays from reading on. All members are for the main thread but compute(), and while that runs only end() and progress()
/// are for others.
class AnalysisTask {
public:
    explicit AnalysisTask(const Ogre::MeshPtr& mesh) : mMesh(mesh), mState(*mesh) {}
    virtual ~AnalysisTask() = default;
    AnalysisTask(const AnalysisTask&) = delete;
    AnalysisTask& operator=(const AnalysisTask&) = delete;

    /// The mesh; null when it is not any more what it was.
    Ogre::MeshPtr mesh() const
    {
        const std::shared_ptr<Ogre::Mesh> mesh = mMesh.lock();
        return mesh && MeshState(*mesh) == mState ? Ogre::MeshPtr(mesh) : Ogre::MeshPtr();
    }

    const Progress& progress() const { return mProgress; }
    bool isRunning() const { return mRunning; }

    /// Cancels, without a word to anybody.
    void end()
    {
        mRunning = false;
        mProgress.cancel();
        dropCallback();
    }

    /// Copies out what computing needs. Errors: those of LevelReader::read().
    virtual Result<Done> read(const Ogre::Mesh& mesh, const std::shared_ptr<const MeshData>& levelZero) = 0;
    /// Computes and lets go of the arrays. Throws nothing.
    virtual void compute() = 0;
    /// Makes the error the result.
    virtual void fail(Error error) = 0;
    /// Calls the callback with the result, unless the task has ended; ends it.
    virtual void deliver() = 0;

protected:
    virtual void dropCallback() = 0;

    Progress mProgress;
    bool mRunning = true;

private:
    std::weak_ptr<Ogre::Mesh> mMesh;
    MeshState mState;
};

template <class Figures>
class FiguresTask : public AnalysisTask {
public:
    using Compute = std::function<Result<Figures>(Progress*)>;
    using Read = std::function<Result<Compute>(const Ogre::Mesh&, const std::shared_ptr<const MeshData>&)>;
    using Callback = std::function<void(const Result<Figures>&)>;

    FiguresTask(const Ogre::MeshPtr& mesh, Read read, Callback done)
        : AnalysisTask(mesh), mRead(std::move(read)), mDone(std::move(done))
    {
    }

    Result<Done> read(const Ogre::Mesh& mesh, const std::shared_ptr<const MeshData>& levelZero) override
    {
        Result<Compute> compute = mRead(mesh, levelZero);
        if (!compute)
            return compute.error();
        mCompute = std::move(compute).value();
        return Done{};
    }

    void compute() override
    {
        try {
            mResult = mCompute(&mProgress);
        } catch (const std::bad_alloc&) { // short enough for a string to hold without allocating
            mResult = Error{ErrorCode::OutOfMemory, "out of memory"};
        }
        mCompute = nullptr;
    }

    void fail(Error error) override { mResult = std::move(error); }

    void deliver() override
    {
        mRunning = false;
        // The callback may end this task, or let go of it.
        const std::optional<Result<Figures>> result = std::exchange(mResult, std::nullopt);
        if (const Callback done = std::exchange(mDone, nullptr))
            done(*result);
    }

private:
    void dropCallback() override
    {
        // What it holds may be the last handle of this task, whose destructor comes back here.
        const Callback dropped = std::exchange(mDone, nullptr);
    }

    Read mRead;
    Compute mCompute;
    Callback mDone;
    std::optional<Result<Figures>> mResult;
};

} // namespace lodsmith
