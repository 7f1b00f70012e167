#pragma once

#include <OgreLodListener.h>
#include <OgreRenderTarget.h>

#include <array>
#include <cstddef>
#include <ctime>
#include <string>
#include <vector>

namespace lodsmith::samples {

/// What frames cost and which levels they show.
class FrameFigures : public Ogre::LodListener {
public:
    bool prequeueEntityMeshLodChanged(Ogre::EntityMeshLodChangedEvent& event) override;

    void beginFrame() { mObjects.fill(0); }
    void endFrame(const Ogre::RenderTarget::FrameStats& statistics, double milliseconds);
    /// Forgets the frames that have been.
    void restart();

    /// About the frames since the last call, in some lines.
    std::string news();
    /// About all frames, in one line.
    std::string summary() const;

private:
    std::array<unsigned, 8> mObjects{}; ///< by level, of the last frame
    std::size_t mChanges = 0;           ///< of level
    std::size_t mChangesBefore = 0;
    std::size_t mFramesBefore = 0;
    std::clock_t mProcessorTime = std::clock(); ///< when it began
    std::vector<double> mMilliseconds;
    std::vector<std::size_t> mTriangles;
    std::vector<std::size_t> mBatches;
};

} // namespace lodsmith::samples
