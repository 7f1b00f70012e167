#pragma once

#include <lodsmith/core/Export.h>

#include <OgreFrameListener.h>

#include <chrono>
#include <memory>

namespace lodsmith {

class GenerationQueue;

/// The main thread's share of background generation: it copies meshes out for the workers, puts finished levels onto their
/// meshes, and emits the signals. A QueuedProgressiveMeshGenerator has one.
///
/// It listens to OGRE's frames and works at the start of each. Without a render loop, call a member now and then.
/// Main thread only, as MeshReader.
class LODSMITH_API PMInjector : public Ogre::FrameListener {
public:
    using Milliseconds = std::chrono::duration<double, std::milli>;

    ~PMInjector() override;
    PMInjector(const PMInjector&) = delete;
    PMInjector& operator=(const PMInjector&) = delete;

    /// One frame's work: drops results whose meshes have gone, injects finished levels, greatest priority first, then copies
    /// meshes out, then reports progress. Begins nothing more once the budget is used up, but does one injection (or, with
    /// none to do, copies one mesh) however small that is. Signal handlers count as part of an injection.
    void update();

    /// Injects everything that has finished by now, whatever the budget. Copies nothing.
    void injectNow();

    /// Works, whatever the budget, until the queue is empty and the workers have nothing to do; sleeps while there is nothing
    /// but to wait for them. For loading screens and programs without frames.
    void finishAll();

    Milliseconds budget() const { return mBudget; }
    /// Milliseconds a frame, >= 0.
    void setBudget(Milliseconds budget);

    bool frameStarted(const Ogre::FrameEvent& event) override;

private:
    friend class QueuedProgressiveMeshGenerator;
    PMInjector(std::shared_ptr<GenerationQueue> queue, Milliseconds budget);

    std::shared_ptr<GenerationQueue> mQueue;
    Milliseconds mBudget;
};

} // namespace lodsmith
