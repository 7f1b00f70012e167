#pragma once

#include "HeatMap.h"
#include "PreviewTarget.h"

#include <lodsmith/render/SurfaceMaterials.h>

#include <OgreRenderQueue.h>
#include <OgreRenderQueueListener.h>
#include <OgreRenderTargetListener.h>

#include <array>
#include <cstddef>
#include <optional>

namespace Ogre {
class Entity;
} // namespace Ogre

namespace lodsmith {

/// What one viewport shows.
struct PreviewPart {
    std::optional<unsigned> level; ///< none: OGRE chooses
    HeatMap* map = nullptr;        ///< in the place of the entity
};

/// A picture of the preview, before it is drawn.
struct PreviewPicture {
    Ogre::Entity* entity = nullptr; ///< null for an empty picture
    ViewMode mode = ViewMode::Shaded;
    CompareMode compare = CompareMode::Off;
    unsigned edge = 0; ///< where the right side of CompareMode::Wipe begins, pixels
    std::array<PreviewPart, 2> parts;
};

/// Draws pictures into the target: sets level, paint and scissors for each viewport while OGRE draws, and counts.
///
/// An entity has one level at a time, and OGRE decides about it for each viewport: so two levels are one entity, drawn twice. The
/// sides of a wipe are the same view drawn twice, each cut off at the edge, so that they fit together to the pixel.
class PreviewDrawing : private Ogre::RenderTargetListener,
                       private Ogre::RenderQueueListener,
                       private Ogre::RenderQueue::RenderableListener {
public:
    /// All live longer than it does.
    PreviewDrawing(Ogre::SceneManager& scene, const SurfaceMaterials& materials);
    ~PreviewDrawing() override;
    PreviewDrawing(const PreviewDrawing&) = delete;
    PreviewDrawing& operator=(const PreviewDrawing&) = delete;

    /// Exceptions are OGRE's.
    void draw(PreviewTarget& target, const PreviewPicture& picture);

    /// In the last picture.
    unsigned shownLevel() const { return mShownLevel; }
    std::size_t triangles() const { return mTriangles; }

private:
    void preViewportUpdate(const Ogre::RenderTargetViewportEvent& event) override;
    void postViewportUpdate(const Ogre::RenderTargetViewportEvent& event) override;
    void preRenderQueues() override;
    void postRenderQueues() override;
    bool renderableQueued(Ogre::Renderable* part, Ogre::uint8 group, Ogre::ushort priority, Ogre::Technique** technique,
                          Ogre::RenderQueue* queue) override;

    Ogre::SceneManager& mScene;
    const SurfaceMaterials& mMaterials;
    PreviewTarget* mTarget = nullptr; ///< while it is drawn
    PreviewPicture mPicture;
    unsigned mPart = 0; ///< that is drawn now
    unsigned mShownLevel = 0;
    std::size_t mTriangles = 0;
};

} // namespace lodsmith
