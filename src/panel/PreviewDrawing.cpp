#include "PreviewDrawing.h"

#include "../ogre/TrianglesIn.h"

#include <lodsmith/loddef/LodDefinition.h>

#include <OgreEntity.h>
#include <OgreRenderTarget.h>
#include <OgreRenderable.h>
#include <OgreRoot.h>
#include <OgreSceneManager.h>
#include <OgreViewport.h>

namespace lodsmith {

namespace {

std::size_t trianglesOf(Ogre::Renderable& part)
{
    Ogre::RenderOperation operation;
    part.getRenderOperation(operation);
    const std::size_t count =
        operation.useIndexes ? operation.indexData->indexCount : operation.vertexData->vertexCount;
    return trianglesIn(operation.operationType, count);
}

Paint paintOf(ViewMode mode)
{
    switch (mode) {
    case ViewMode::Shaded: return Paint::Own;
    case ViewMode::Flat: return Paint::Faceted;
    case ViewMode::Wireframe: return Paint::Lines;
    case ViewMode::Checker: return Paint::Checker;
    case ViewMode::Deviation: break;
    }
    return Paint::Grey; // of the level, while its colours are not there
}

} // namespace

PreviewDrawing::PreviewDrawing(Ogre::SceneManager& scene, const SurfaceMaterials& materials)
    : mScene(scene), mMaterials(materials)
{
    mScene.addRenderQueueListener(this);
    mScene.getRenderQueue()->setRenderableListener(this);
}

PreviewDrawing::~PreviewDrawing()
{
    mScene.getRenderQueue()->setRenderableListener(nullptr);
    mScene.removeRenderQueueListener(this);
}

void PreviewDrawing::draw(PreviewTarget& target, const PreviewPicture& picture)
{
    mTarget = &target;
    mPicture = picture;
    mTriangles = 0;
    mShownLevel = 0;
    target.target().addListener(this);
    try {
        target.target().update();
    } catch (...) {
        target.target().removeListener(this);
        throw;
    }
    target.target().removeListener(this);
}

void PreviewDrawing::preViewportUpdate(const Ogre::RenderTargetViewportEvent& event)
{
    mPart = static_cast<unsigned>(event.source->getZOrder());
    if (!mPicture.entity)
        return;
    const PreviewPart& part = mPicture.parts[mPart];
    const auto level = static_cast<Ogre::ushort>(part.level.value_or(0));
    mPicture.entity->setMeshLodBias(1, level, part.level ? level : Ogre::ushort(kMaxLoddefLevels));
    mPicture.entity->setVisible(!part.map);
    for (const PreviewPart& other : mPicture.parts)
        if (other.map)
            other.map->setVisible(other.map == part.map);
}

void PreviewDrawing::postViewportUpdate(const Ogre::RenderTargetViewportEvent&)
{
    if (mPicture.entity && mPart == 0) {
        const std::optional<unsigned> level = mPicture.parts[0].level;
        mShownLevel = level ? *level : mPicture.entity->getCurrentLodIndex();
    }
}

void PreviewDrawing::preRenderQueues()
{
    if (mPicture.compare != CompareMode::Wipe)
        return;
    const long edge = mPicture.edge, width = mTarget->width(), height = mTarget->height();
    Ogre::Root::getSingleton().getRenderSystem()->setScissorTest(true, mPart == 0 ? Ogre::Rect(0, 0, edge, height)
                                                                                  : Ogre::Rect(edge, 0, width, height));
}

void PreviewDrawing::postRenderQueues()
{
    if (mPicture.compare == CompareMode::Wipe)
        Ogre::Root::getSingleton().getRenderSystem()->setScissorTest(false);
}

bool PreviewDrawing::renderableQueued(Ogre::Renderable* part, Ogre::uint8, Ogre::ushort, Ogre::Technique** technique,
                                      Ogre::RenderQueue*)
{
    mTriangles += trianglesOf(*part);
    *technique = mMaterials.techniqueFor(paintOf(mPicture.mode), *part, *technique);
    return true;
}

} // namespace lodsmith
