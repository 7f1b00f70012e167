#include <lodsmith/panel/MeshPreview.h>

#include "../ogre/OgreGuard.h"
#include "DeviationView.h"
#include "OrbitCamera.h"
#include "PreviewAnimation.h"
#include "PreviewDrawing.h"
#include "PreviewTarget.h"
#include "ShownMesh.h"

#include <lodsmith/render/Stage.h>
#include <lodsmith/render/SurfaceMaterials.h>

#include <OgreCamera.h>
#include <OgreEntity.h>
#include <OgreLodStrategy.h>
#include <OgreLodStrategyManager.h>
#include <OgreRoot.h>
#include <OgreSceneManager.h>
#include <OgreSceneNode.h>
#include <OgreViewport.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace lodsmith {

namespace {

/// A name of its own for all that a preview makes.
std::string nextName()
{
    static unsigned count = 0;
    return "Lodsmith preview " + std::to_string(++count);
}

} // namespace

struct MeshPreview::Parts {
    Parts(const std::string& name, LevelAnalyser& analyser)
        : materials(name), stage(name), target(name, name, stage.camera), orbit(stage.camera, stage.cameraNode),
          shown(stage.subject), drawing(stage.scene, materials),
          deviation(analyser, stage.subject, materials.vertexColours())
    {
    }

    /// Scripts set what is set already, once a frame: that is no reason to draw. Returns whether it was another value.
    template <class T>
    bool set(T& setting, const T& value)
    {
        const bool isOther = setting != value;
        isDirty = isDirty || isOther;
        setting = value;
        return isOther;
    }

    bool isComparing() const { return compare != CompareMode::Off; }
    unsigned lastLevel() const { return shown.mesh()->getNumLodLevels() - 1u; }
    unsigned chosenLevel() const;
    std::vector<unsigned> levelsInPicture() const;
    PreviewPicture picture();
    void followDeviation();
    bool hasChanged(float seconds);

    SurfaceMaterials materials;
    Stage stage;
    PreviewTarget target;
    OrbitCamera orbit;
    ShownMesh shown;
    PreviewDrawing drawing;
    DeviationView deviation;
    PreviewAnimation animation;
    ViewMode mode = ViewMode::Shaded;
    CompareMode compare = CompareMode::Off;
    std::array<unsigned, 2> compared = {0, 0};
    float share = 0.5f;
    std::optional<unsigned> level;
    bool isDirty = true;
};

/// The level without comparison: the forced one, or what OGRE will choose.
unsigned MeshPreview::Parts::chosenLevel() const
{
    if (level)
        return std::min(*level, lastLevel());
    const Ogre::Mesh& mesh = *shown.mesh();
    return mesh.getLodIndex(mesh.getLodStrategy()->getValue(shown.entity(), &stage.camera));
}

std::vector<unsigned> MeshPreview::Parts::levelsInPicture() const
{
    std::vector<unsigned> levels;
    if (isComparing())
        for (const unsigned number : compared)
            levels.push_back(std::min(number, lastLevel()));
    else
        levels.push_back(chosenLevel());
    return levels;
}

PreviewPicture MeshPreview::Parts::picture()
{
    PreviewPicture picture;
    picture.entity = shown.entity();
    picture.mode = mode;
    picture.compare = compare;
    picture.edge = static_cast<unsigned>(std::lround(share * static_cast<float>(target.width())));
    if (!picture.entity)
        return picture;
    const bool isFree = !isComparing() && !level && mode != ViewMode::Deviation;
    const std::vector<unsigned> levels = levelsInPicture();
    for (std::size_t i = 0; i < std::min(levels.size(), picture.parts.size()); ++i) {
        if (!isFree)
            picture.parts[i].level = levels[i];
        if (mode == ViewMode::Deviation)
            picture.parts[i].map = deviation.mapOf(levels[i]);
    }
    return picture;
}

void MeshPreview::Parts::followDeviation()
{
    if (mode == ViewMode::Deviation && shown.entity())
        deviation.want(shown.mesh(), levelsInPicture());
    else
        deviation.hide();
}

bool MeshPreview::Parts::hasChanged(float seconds)
{
    const ShownMesh::Change change = shown.follow();
    if (change == ShownMesh::Change::Mesh)
        deviation.forget();
    else if (change == ShownMesh::Change::Levels)
        deviation.forgetLevels();
    const bool isMoving = shown.entity() && animation.advance(*shown.entity(), seconds);
    followDeviation();
    const bool hasNewMaps = deviation.takeChange();
    return std::exchange(isDirty, false) || change != ShownMesh::Change::None || isMoving || hasNewMaps;
}

Result<Done> MeshPreview::isPossible()
{
    Ogre::Root* root = Ogre::Root::getSingletonPtr();
    const Ogre::RenderSystem* system = root ? root->getRenderSystem() : nullptr;
    if (!system || !system->getCapabilities())
        return Error{ErrorCode::Unsupported, "OGRE has no render system with a window"};
    if (!system->getCapabilities()->hasCapability(Ogre::RSC_FIXED_FUNCTION))
        return Error{ErrorCode::Unsupported, "the preview needs a render system with fixed functions, which \""
                                                 + system->getName() + "\" has not"};
    return Done{};
}

MeshPreview::MeshPreview(LevelAnalyser& analyser) : mParts(std::make_unique<Parts>(nextName(), analyser)) {}

MeshPreview::~MeshPreview() = default;

Result<Done> MeshPreview::show(const Ogre::MeshPtr& mesh)
{
    if (!mesh)
        return Error{ErrorCode::NotFound, "there is no mesh to show"};
    if (mesh == mParts->shown.mesh() && mParts->shown.entity())
        return Done{};
    return guarded(mesh->getName(), [&]() -> Result<Done> {
        mesh->load();
        if (!mesh->isLoaded())
            return Error{ErrorCode::NotFound, "the mesh cannot be loaded"};
        const bool isOther = mesh != mParts->shown.mesh();
        mParts->shown.show(mesh);
        mParts->deviation.forget();
        if (isOther) {
            mParts->animation.play("");
            resetCamera();
        }
        redraw();
        return Done{};
    });
}

void MeshPreview::clear()
{
    mParts->shown.clear();
    mParts->deviation.forget();
    redraw();
}

const Ogre::MeshPtr& MeshPreview::mesh() const
{
    return mParts->shown.mesh();
}

void MeshPreview::setLevel(std::optional<unsigned> level)
{
    mParts->set(mParts->level, level);
}

std::optional<unsigned> MeshPreview::level() const
{
    return mParts->level;
}

void MeshPreview::compare(CompareMode mode, unsigned first, unsigned second, float share)
{
    if (mParts->set(mParts->compare, mode))
        mParts->target.setCompare(mode);
    mParts->set(mParts->compared, std::array{first, second});
    mParts->set(mParts->share, std::isfinite(share) ? std::clamp(share, 0.0f, 1.0f) : 0.5f);
}

CompareMode MeshPreview::compareMode() const
{
    return mParts->compare;
}

void MeshPreview::setMode(ViewMode mode)
{
    mParts->set(mParts->mode, mode);
}

ViewMode MeshPreview::mode() const
{
    return mParts->mode;
}

std::string MeshPreview::note() const
{
    if (mParts->mode == ViewMode::Checker && mParts->shown.entity() && !hasTextureCoordinates(*mesh()))
        return "The mesh, or a part of it, has no texture coordinates: it is shown without a checker.";
    return "";
}

unsigned MeshPreview::shownLevel() const
{
    return mParts->drawing.shownLevel();
}

std::size_t MeshPreview::triangles() const
{
    return mParts->drawing.triangles();
}

std::optional<double> MeshPreview::deviationScale() const
{
    return mParts->deviation.scale();
}

std::string MeshPreview::deviationError() const
{
    return mParts->mode == ViewMode::Deviation ? mParts->deviation.error() : "";
}

void MeshPreview::orbit(float dx, float dy)
{
    mParts->orbit.orbit(dx, dy);
    redraw();
}

void MeshPreview::pan(float dx, float dy)
{
    mParts->orbit.pan(dx, dy, static_cast<float>(height()));
    redraw();
}

void MeshPreview::zoom(float steps)
{
    mParts->orbit.zoom(steps);
    redraw();
}

void MeshPreview::resetCamera()
{
    if (mesh())
        mParts->orbit.frame(mesh()->getBounds(), mesh()->getBoundingSphereRadius());
    else
        mParts->orbit.frame(Ogre::AxisAlignedBox::BOX_NULL, 0);
    redraw();
}

float MeshPreview::distance() const
{
    return mParts->orbit.distance();
}

Result<Done> MeshPreview::viewAt(const std::string& strategyName, double value)
{
    const Ogre::Entity* entity = mParts->shown.entity();
    if (!entity)
        return Error{ErrorCode::NotFound, "there is no mesh to look at"};
    const Ogre::LodStrategy* strategy = Ogre::LodStrategyManager::getSingleton().getStrategy(strategyName);
    if (!strategy)
        return Error{ErrorCode::NotFound, "OGRE knows no strategy \"" + strategyName + "\""};
    if (!(value > 0) || !std::isfinite(value))
        return Error{ErrorCode::InvalidSetting, "a value to look at is a number above 0"};
    entity->getWorldBoundingBox(true); // which OGRE otherwise knows after the first picture only
    OrbitCamera& orbit = mParts->orbit;
    const Ogre::Real wanted = strategy->transformUserValue(static_cast<Ogre::Real>(value));
    const bool isFalling = strategy->getBaseValue() > 0; // pixels do, with the distance
    const auto isReached = [&](float distance) {
        orbit.setDistance(distance);
        const Ogre::Real there = strategy->getValue(entity, &mParts->stage.camera);
        return isFalling ? there <= wanted : there >= wanted;
    };
    const float before = orbit.distance();
    float near = orbit.minDistance(), far = orbit.maxDistance();
    const bool isBetween = !isReached(near) && isReached(far);
    for (float middle = near + (far - near) / 2; isBetween && near < middle && middle < far;
         middle = near + (far - near) / 2)
        (isReached(middle) ? far : near) = middle;
    orbit.setDistance(isBetween ? far : before);
    redraw();
    if (!isBetween)
        return Error{ErrorCode::InvalidSetting, "the mesh has this value nowhere in sight"};
    return Done{};
}

void MeshPreview::resize(unsigned width, unsigned height)
{
    if (mParts->target.resize(width, height))
        redraw();
}

unsigned MeshPreview::width() const
{
    return mParts->target.width();
}

unsigned MeshPreview::height() const
{
    return mParts->target.height();
}

const Ogre::TexturePtr& MeshPreview::texture() const
{
    return mParts->target.texture();
}

std::vector<std::string> MeshPreview::animations() const
{
    return PreviewAnimation::namesOf(mParts->shown.entity());
}

Result<Done> MeshPreview::play(const std::string& animation)
{
    const std::vector<std::string> names = animations();
    if (!animation.empty() && std::find(names.begin(), names.end(), animation) == names.end())
        return Error{ErrorCode::NotFound, "the mesh has no animation \"" + animation + "\""};
    mParts->animation.play(animation);
    redraw();
    return Done{};
}

const std::string& MeshPreview::animation() const
{
    return mParts->animation.name();
}

void MeshPreview::setSpeed(float speed)
{
    mParts->animation.setSpeed(speed);
}

bool MeshPreview::isMoving() const
{
    return mParts->shown.entity() && mParts->animation.isMoving();
}

void MeshPreview::redraw()
{
    mParts->isDirty = true;
}

Result<bool> MeshPreview::update(float seconds)
{
    return guarded(mesh() ? mesh()->getName() : "", [&]() -> Result<bool> {
        if (!mParts->hasChanged(seconds))
            return false;
        mParts->drawing.draw(mParts->target, mParts->picture());
        return true;
    });
}

} // namespace lodsmith
