#include <lodsmith/render/LevelRenderer.h>

#include "../ogre/OgreGuard.h"
#include "CutOutMaterials.h"
#include "OffscreenTarget.h"
#include "ScreenPart.h"

#include <lodsmith/core/Assert.h>
#include <lodsmith/ogre/LevelReader.h>
#include <lodsmith/render/Stage.h>

#include <OgreCamera.h>
#include <OgreEntity.h>
#include <OgreMaterial.h>
#include <OgreRenderQueue.h>
#include <OgreRenderable.h>
#include <OgreSceneManager.h>
#include <OgreSceneNode.h>
#include <OgreSubEntity.h>
#include <OgreTechnique.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace lodsmith {

namespace {

constexpr unsigned kSamples = 2; // along a pixel's side
/// What no mesh is expected to be coloured like: a sample that is would count as empty.
constexpr std::array<std::uint8_t, 3> kKey = {1, 254, 3};

/// A name of its own for all that a renderer makes.
std::string nextName()
{
    static unsigned count = 0;
    return "Lodsmith pictures " + std::to_string(++count);
}

bool hasNormals(Ogre::Renderable& part)
{
    Ogre::RenderOperation operation;
    part.getRenderOperation(operation);
    return operation.vertexData->vertexDeclaration->findElementBySemantic(Ogre::VES_NORMAL) != nullptr;
}

std::size_t trianglesOf(const MeshView& view)
{
    std::size_t indices = 0;
    for (const SubMeshView& part : view.subMeshes)
        indices += part.indexCount;
    return indices / 3;
}

/// The positions that a mesh draws.
void addPoints(const MeshView& view, std::vector<Ogre::Vector3>& points)
{
    for (std::size_t number = 0; number < view.vertexBuffers.size(); ++number) {
        const VertexBufferView& buffer = view.vertexBuffers[number];
        std::vector<bool> isDrawn(buffer.vertexCount);
        for (const SubMeshView& part : view.subMeshes)
            for (std::size_t i = 0; part.vertexBuffer == number && i < part.indexCount; ++i)
                isDrawn[part.index(i)] = true;
        for (std::size_t i = 0; i < isDrawn.size(); ++i) {
            float position[3];
            if (isDrawn[i]) {
                buffer.positions.read(i, 3, position);
                points.emplace_back(position[0], position[1], position[2]);
            }
        }
    }
}

/// What a picture shows, sample by sample: alpha, and the colour multiplied by it.
using Samples = std::vector<std::array<std::uint8_t, 4>>;

/// From a picture before a colour that nothing has.
Samples samplesBefore(const std::vector<std::uint8_t>& rgb, const std::array<std::uint8_t, 3>& key)
{
    Samples samples(rgb.size() / 3, {0, 0, 0, 0});
    for (std::size_t i = 0; i < samples.size(); ++i)
        if (rgb[3 * i] != key[0] || rgb[3 * i + 1] != key[1] || rgb[3 * i + 2] != key[2])
            samples[i] = {rgb[3 * i], rgb[3 * i + 1], rgb[3 * i + 2], 255};
    return samples;
}

/// What a picture before white has more than the same before black is what shines through.
Samples samplesBetween(const std::vector<std::uint8_t>& onBlack, const std::vector<std::uint8_t>& onWhite)
{
    Samples samples(onBlack.size() / 3);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        int shining = 0;
        for (std::size_t channel = 0; channel < 3; ++channel) {
            samples[i][channel] = onBlack[3 * i + channel];
            shining += std::max(0, onWhite[3 * i + channel] - onBlack[3 * i + channel]);
        }
        samples[i][3] = static_cast<std::uint8_t>(255 - (shining + 1) / 3);
    }
    return samples;
}

Image averaged(const Samples& samples, unsigned width, unsigned height)
{
    constexpr unsigned kCount = kSamples * kSamples;
    Image image = Image::empty(width, height);
    for (std::size_t y = 0; y < height; ++y)
        for (std::size_t x = 0; x < width; ++x) {
            std::array<unsigned, 4> sum = {kCount / 2, kCount / 2, kCount / 2, kCount / 2}; // for rounding
            for (unsigned i = 0; i < kCount; ++i)
                for (std::size_t channel = 0; channel < sum.size(); ++channel)
                    sum[channel] += samples[(kSamples * y + i / kSamples) * kSamples * width + kSamples * x
                                            + i % kSamples][channel];
            for (std::size_t channel = 0; channel < sum.size(); ++channel)
                image.pixel(x, y)[channel] = static_cast<std::uint8_t>(std::min(sum[channel], sum[3]) / kCount);
        }
    return image;
}

/// What cannot be drawn as it should be of a material.
void addMaterialNotes(const Ogre::MaterialPtr& material, std::size_t subMesh, std::set<std::string>& notes)
{
    if (isStandIn(*material))
        notes.insert("submesh " + std::to_string(subMesh) + " has no material that is there: drawn grey");
    material->load();
    for (const Ogre::Technique* technique : material->getSupportedTechniques())
        for (const Ogre::TextureUnitState* unit : texturesMissing(*technique))
            notes.insert("texture '" + unit->getTextureName() + "' of material '" + material->getName()
                         + "' cannot be read: drawn grey");
}

} // namespace

class LevelRenderer::Parts : private Ogre::RenderQueue::RenderableListener {
public:
    explicit Parts(const Ogre::MeshPtr& mesh)
        : mMesh(mesh), mName(nextName()), mMaterials(mName), mCutOuts(mName), mStage(mName), mTarget(mName, mName)
    {
        mStage.scene.getRenderQueue()->setRenderableListener(this);
    }
    ~Parts() override { mStage.scene.getRenderQueue()->setRenderableListener(nullptr); }

    Result<Done> readLevels();
    void enterStage();
    Image draw(unsigned level, Paint paint, const Viewpoint& viewpoint);

    const Ogre::MeshPtr& mesh() const { return mMesh; }
    const std::vector<Ogre::Vector3>& points() const { return mPoints; }
    const std::vector<std::size_t>& triangles() const { return mTriangles; }
    const std::vector<std::string>& notes() const { return mNotes; }

private:
    bool renderableQueued(Ogre::Renderable* part, Ogre::uint8, Ogre::ushort, Ogre::Technique** technique,
                          Ogre::RenderQueue*) override;
    void aim(const Viewpoint& viewpoint, const ScreenPart& part);
    Samples samples(unsigned width, unsigned height);

    Ogre::MeshPtr mMesh;
    std::string mName;
    SurfaceMaterials mMaterials;
    CutOutMaterials mCutOuts;
    Stage mStage;
    OffscreenTarget mTarget;
    Ogre::Entity* mEntity = nullptr;
    Paint mPaint = Paint::Own;
    bool mIsBlended = false;            ///< something in the last picture
    std::vector<Ogre::Vector3> mPoints; ///< all that any level draws
    std::vector<std::size_t> mTriangles;
    std::vector<std::string> mNotes;
};

Result<Done> LevelRenderer::Parts::readLevels()
{
    const Result<std::shared_ptr<const MeshData>> levelZero = LevelReader::readLevelZero(*mMesh);
    if (!levelZero)
        return levelZero.error();
    for (unsigned level = 0; level < mMesh->getNumLodLevels(); ++level) {
        const Result<LevelData> data = LevelReader::read(*mMesh, levelZero.value(), level);
        if (!data)
            return data.error();
        mTriangles.push_back(trianglesOf(data.value().view()));
        // Generated levels draw what level 0 has.
        if (level == 0 || !mMesh->getLodLevel(static_cast<Ogre::ushort>(level)).manualName.empty())
            addPoints(data.value().view(), mPoints);
    }
    if (mTriangles.front() == 0)
        return Error{ErrorCode::InvalidGeometry, "has no triangles to take a picture of"};
    return Done{};
}

/// After readLevels(): OGRE makes an entity of hand-made levels that are not there, and ends with it.
void LevelRenderer::Parts::enterStage()
{
    mEntity = mStage.scene.createEntity(mMesh);
    mStage.subject.attachObject(mEntity);
    std::set<std::string> notes;
    for (std::size_t i = 0; i < mEntity->getNumSubEntities(); ++i)
        addMaterialNotes(mEntity->getSubEntity(i)->getMaterial(), i, notes);
    mNotes.assign(notes.begin(), notes.end());
}

bool LevelRenderer::Parts::renderableQueued(Ogre::Renderable* part, Ogre::uint8, Ogre::ushort,
                                            Ogre::Technique** technique, Ogre::RenderQueue*)
{
    Ogre::Technique* const own = *technique;
    *technique = mMaterials.techniqueFor(mPaint, *part, own);
    if (*technique != own && !hasNormals(*part))
        *technique = mMaterials.techniqueFor(Paint::Plain, *part, own);
    else if ((mPaint == Paint::Grey || mPaint == Paint::Checker) && *technique != own
             && CutOutMaterials::hasHoles(*own))
        *technique = mCutOuts.techniqueFor(*own, mPaint == Paint::Checker ? mMaterials.checker() : nullptr);
    mIsBlended = mIsBlended || (*technique)->isTransparent();
    return true;
}

void LevelRenderer::Parts::aim(const Viewpoint& viewpoint, const ScreenPart& part)
{
    mStage.cameraNode.setOrientation(orientationOf(viewpoint.direction));
    mStage.cameraNode.setPosition(viewpoint.target + viewpoint.direction * static_cast<Ogre::Real>(viewpoint.distance));
    const double perPixel = part.near / pixelsOf(1.0, 1.0, viewpoint.screen);
    const auto extent = [&](int pixels) { return static_cast<Ogre::Real>(pixels * perPixel); };
    Ogre::Camera& camera = mStage.camera;
    camera.setNearClipDistance(static_cast<Ogre::Real>(part.near));
    camera.setFarClipDistance(static_cast<Ogre::Real>(part.far));
    camera.setFrustumExtents(extent(part.left), extent(part.right), extent(part.top), extent(part.bottom));
}

Image LevelRenderer::Parts::draw(unsigned level, Paint paint, const Viewpoint& viewpoint)
{
    const ScreenPart part = screenPartOf(mPoints, viewpoint);
    aim(viewpoint, part);
    const auto index = static_cast<Ogre::ushort>(level);
    mEntity->setMeshLodBias(1, index, index);
    mPaint = paint;
    return averaged(samples(kSamples * part.width(), kSamples * part.height()), part.width(), part.height());
}

Samples LevelRenderer::Parts::samples(unsigned width, unsigned height)
{
    const auto before = [&](const std::array<std::uint8_t, 3>& colour) {
        return mTarget.draw(mStage.camera, width, height,
                            Ogre::ColourValue(static_cast<float>(colour[0]) / 255, static_cast<float>(colour[1]) / 255,
                                              static_cast<float>(colour[2]) / 255));
    };
    mIsBlended = false;
    const std::vector<std::uint8_t> onKey = before(kKey);
    return mIsBlended ? samplesBetween(before({0, 0, 0}), before({255, 255, 255})) : samplesBefore(onKey, kKey);
}

LevelRenderer::LevelRenderer(std::unique_ptr<Parts> parts) : mParts(std::move(parts)) {}

LevelRenderer::~LevelRenderer() = default;

Result<std::unique_ptr<LevelRenderer>> LevelRenderer::create(const Ogre::MeshPtr& mesh)
{
    return guarded(mesh->getName(), [&]() -> Result<std::unique_ptr<LevelRenderer>> {
        auto parts = std::make_unique<Parts>(mesh);
        if (const Result<Done> read = parts->readLevels(); !read)
            return read.error();
        parts->enterStage();
        return std::unique_ptr<LevelRenderer>(new LevelRenderer(std::move(parts)));
    });
}

const Ogre::MeshPtr& LevelRenderer::mesh() const
{
    return mParts->mesh();
}

const std::vector<std::string>& LevelRenderer::notes() const
{
    return mParts->notes();
}

unsigned LevelRenderer::levels() const
{
    return static_cast<unsigned>(mParts->triangles().size());
}

std::size_t LevelRenderer::triangles(unsigned level) const
{
    LODSMITH_ASSERT(level < levels(), "the level is one of the mesh's");
    return mParts->triangles()[level];
}

Result<Image> LevelRenderer::picture(unsigned level, Paint paint, const Viewpoint& viewpoint)
{
    LODSMITH_ASSERT(level < levels(), "the level is one of the mesh's");
    LODSMITH_ASSERT(viewpoint.distance > 0, "the camera is somewhere else than what it looks at");
    LODSMITH_ASSERT(std::max(viewpoint.screen.width, viewpoint.screen.height) * kSamples <= OffscreenTarget::kMaxSize,
                    "the screen is no larger than 2048 pixels");
    return guarded(mParts->mesh()->getName(), [&]() -> Result<Image> { return mParts->draw(level, paint, viewpoint); });
}

Viewpoint LevelRenderer::closeUp(const Ogre::Vector3& direction, unsigned size) const
{
    return viewpointFor(mParts->points(), direction, size);
}

Result<Viewpoint> LevelRenderer::atSwitch(unsigned level, const Ogre::Vector3& direction, const Screen& screen) const
{
    const Result<double> distance = switchDistance(*mParts->mesh(), level, direction, screen);
    if (!distance)
        return distance.error();
    if (!std::isfinite(distance.value()))
        return Error{ErrorCode::Unsupported, "level " + std::to_string(level) + " appears nowhere in sight",
                     mParts->mesh()->getName()};
    return Viewpoint{Ogre::Vector3::ZERO, direction, distance.value(), screen};
}

} // namespace lodsmith
