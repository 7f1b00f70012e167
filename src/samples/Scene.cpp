#include "Scene.h"

#include <OgreAnimationState.h>
#include <OgreCamera.h>
#include <OgreImage.h>
#include <OgreLight.h>
#include <OgreMaterialManager.h>
#include <OgreMeshManager.h>
#include <OgrePass.h>
#include <OgreResourceGroupManager.h>
#include <OgreSceneNode.h>
#include <OgreTechnique.h>
#include <OgreTextureManager.h>
#include <OgreViewport.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace lodsmith::samples {

namespace {

constexpr float kWidth = 340.0f; ///< metres, of the square that the models stand in
constexpr float kLane = 3.0f;    ///< half of what stays free in its middle, along z
constexpr float kAnimatedUpTo = 60.0f;
const Ogre::ColourValue kSky(0.62f, 0.74f, 0.85f);

struct Model {
    const char* mesh;
    float share; ///< of all models, with those before it
    float smallest, largest;
};

constexpr Model kModels[] = {{"tree.mesh", 0.62f, 0.8f, 1.4f},
                             {"lantern.mesh", 0.76f, 2.0f, 3.5f},
                             {"drake.mesh", 0.88f, 1.5f, 3.5f},
                             {"cottage.mesh", 1.0f, 0.9f, 1.1f}};

/// Numbers of 0..1 that are the same on every machine.
class Random {
public:
    float operator()() { return static_cast<float>(mEngine()) / static_cast<float>(std::minstd_rand::max()); }

private:
    std::minstd_rand mEngine{7};
};

void findModels()
{
    auto& resources = Ogre::ResourceGroupManager::getSingleton();
    for (const std::string model : {"tree", "cottage", "lantern", "drake"})
        resources.addResourceLocation(LODSMITH_MEDIA_DIR "/" + model, "FileSystem");
    resources.initialiseAllResourceGroups();
}

Ogre::MaterialPtr makeGrass()
{
    constexpr Ogre::uint32 size = 256;
    std::vector<Ogre::uint8> pixels;
    Random random;
    for (Ogre::uint32 i = 0; i < size * size; ++i) {
        const float light = 0.6f + 0.4f * random();
        pixels.insert(pixels.end(), {Ogre::uint8(92 * light), Ogre::uint8(120 * light), Ogre::uint8(58 * light)});
    }
    Ogre::Image image;
    image.loadDynamicImage(pixels.data(), size, size, Ogre::PF_BYTE_RGB);
    Ogre::TextureManager::getSingleton().loadImage("grass", Ogre::RGN_DEFAULT, image);
    auto grass = Ogre::MaterialManager::getSingleton().create("grass", Ogre::RGN_DEFAULT);
    grass->getTechnique(0)->getPass(0)->createTextureUnitState("grass");
    return grass;
}

} // namespace

Scene::Scene(Engine& engine, Ogre::RenderTarget& target, unsigned objects)
    : mManager(engine.root().createSceneManager())
{
    findModels();
    mManager->addRenderQueueListener(&engine.overlays());
    makeSkyAndGround();
    place(objects);
    makeCamera(target);
}

void Scene::makeSkyAndGround()
{
    mManager->setFog(Ogre::FOG_LINEAR, kSky, 0, 150, 450);
    mManager->setAmbientLight(Ogre::ColourValue(0.45f, 0.47f, 0.5f));
    Ogre::Light* sun = mManager->createLight();
    sun->setType(Ogre::Light::LT_DIRECTIONAL);
    Ogre::SceneNode* sky = mManager->getRootSceneNode()->createChildSceneNode();
    sky->attachObject(sun);
    sky->setDirection(Ogre::Vector3(-0.6f, -1.0f, -0.5f));
    const Ogre::MeshPtr ground = Ogre::MeshManager::getSingleton().createPlane(
        "ground", Ogre::RGN_DEFAULT, Ogre::Plane(Ogre::Vector3::UNIT_Y, 0), 1200, 1200, 12, 12, true, 1, 300, 300,
        Ogre::Vector3::UNIT_Z);
    Ogre::Entity* entity = mManager->createEntity(ground);
    entity->setMaterial(makeGrass());
    mManager->getRootSceneNode()->attachObject(entity);
}

/// One model a cell of a grid, anywhere in it.
void Scene::place(unsigned objects)
{
    Random random;
    const auto columns = static_cast<unsigned>(std::ceil(std::sqrt(objects)));
    const float cell = kWidth / static_cast<float>(columns);
    for (unsigned i = 0; i < objects; ++i) {
        const unsigned column = i % columns, row = i / columns;
        float x = cell * (static_cast<float>(column) + 0.2f + 0.6f * random()) - kWidth / 2;
        const float z = -cell * (static_cast<float>(row) + 0.2f + 0.6f * random());
        x += std::copysign(kLane, x);
        const float choice = random();
        const Model& model = *std::find_if(std::begin(kModels), std::end(kModels),
                                           [&](const Model& candidate) { return choice <= candidate.share; });
        Ogre::Entity* entity = mManager->createEntity(model.mesh);
        Ogre::SceneNode* node = mManager->getRootSceneNode()->createChildSceneNode(Ogre::Vector3(x, 0, z));
        node->yaw(Ogre::Degree(360 * random()));
        node->setScale(Ogre::Vector3(model.smallest + (model.largest - model.smallest) * random()));
        node->attachObject(entity);
        if (entity->hasSkeleton() && std::abs(x) < kAnimatedUpTo && z > -kAnimatedUpTo)
            mAnimated.push_back(entity);
    }
}

void Scene::makeCamera(Ogre::RenderTarget& target)
{
    Ogre::Camera* camera = mManager->createCamera("camera");
    camera->setNearClipDistance(0.5f);
    camera->setFarClipDistance(900);
    camera->setAutoAspectRatio(true);
    mCameraNode = mManager->getRootSceneNode()->createChildSceneNode();
    mCameraNode->setFixedYawAxis(true);
    mCameraNode->attachObject(camera);
    target.addViewport(camera)->setBackgroundColour(kSky);
    // Down the lane among the models, up and round, and back high above them.
    const Ogre::Vector3 stations[] = {{0, 4, 15},      {0, 3, -20},   {0, 4, -100}, {10, 16, -190}, {110, 40, -250},
                                      {190, 50, -130}, {100, 40, 40}, {20, 15, 60}, {0, 4, 15}};
    for (const Ogre::Vector3& station : stations)
        mPath.addPoint(station);
}

void Scene::update(double share, double seconds)
{
    const Ogre::Vector3 place = mPath.interpolate(static_cast<Ogre::Real>(share));
    // Ahead where it goes in among the models, and at the middle of them from outside.
    const Ogre::Vector3 middle(0, 2, -kWidth / 3), ahead(place.x, 3, place.z - 40);
    const float inside = std::clamp((0.35f - static_cast<float>(share)) / 0.1f, 0.0f, 1.0f);
    mCameraNode->setPosition(place);
    mCameraNode->lookAt(middle + inside * (ahead - middle), Ogre::Node::TS_WORLD);
    for (Ogre::Entity* entity : mAnimated) {
        // Asked for each time: levels that come later may make an entity's inside anew.
        Ogre::AnimationState* idle = entity->getAnimationState("idle");
        idle->setEnabled(true);
        idle->addTime(static_cast<Ogre::Real>(seconds));
    }
}

} // namespace lodsmith::samples
