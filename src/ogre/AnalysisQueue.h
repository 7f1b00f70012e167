#pragma once

#include "AnalysisTask.h"

#include <deque>
#include <future>
#include <memory>
#include <optional>

namespace lodsmith {

/// The jobs of a LevelAnalyser: at most one at a time is on the background thread, the others wait unread. Main thread.
///
/// Callbacks run code of others, and so does reading, in listeners to the loading of hand-made levels. After either nothing
/// that was known of this object holds.
class AnalysisQueue {
public:
    void add(std::shared_ptr<AnalysisTask> task);
    /// Delivers what has been computed and begins with the next. False when there was nothing to do, nor is anything computed.
    bool work();
    void finishAll();
    bool isIdle() const;
    /// Ends everything, for good: all calls that are under way on the stack return without doing more.
    void shutDown();

private:
    struct LevelZero {
        std::weak_ptr<Ogre::Mesh> mesh;
        MeshState state;
        std::shared_ptr<const MeshData> data;
    };

    bool deliverComputed();
    bool beginNext();
    Result<Done> read(AnalysisTask& task);
    Result<std::shared_ptr<const MeshData>> levelZeroOf(const Ogre::MeshPtr& mesh);
    /// Error: OutOfMemory.
    Result<Done> compute(AnalysisTask& task);

    std::deque<std::shared_ptr<AnalysisTask>> mWaiting;
    std::shared_ptr<AnalysisTask> mCurrent; ///< being read or computed
    std::future<void> mComputation;         ///< valid while mCurrent is computed
    std::optional<LevelZero> mLastRead;     ///< for the tasks that wait
    bool mShutDown = false;
};

} // namespace lodsmith
