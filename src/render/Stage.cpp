#include <lodsmith/render/Stage.h>

#include <OgreCamera.h>
#include <OgreLight.h>
#include <OgreRoot.h>
#include <OgreSceneManager.h>
#include <OgreSceneNode.h>

namespace lodsmith {

Stage::Stage(const Ogre::String& name)
    : scene(*Ogre::Root::getSingleton().createSceneManager(Ogre::DefaultSceneManagerFactory::FACTORY_TYPE_NAME, name)),
      cameraNode(*scene.getRootSceneNode()->createChildSceneNode()),
      subject(*scene.getRootSceneNode()->createChildSceneNode()), camera(*scene.createCamera(name))
{
    cameraNode.attachObject(&camera);
    scene.setAmbientLight(Ogre::ColourValue(0.28f, 0.28f, 0.30f));
    Ogre::Light* light = scene.createLight();
    light->setType(Ogre::Light::LT_DIRECTIONAL);
    light->setDiffuseColour(Ogre::ColourValue(0.80f, 0.80f, 0.78f));
    light->setSpecularColour(Ogre::ColourValue(0.3f, 0.3f, 0.3f));
    Ogre::SceneNode* overShoulder = cameraNode.createChildSceneNode();
    overShoulder->attachObject(light);
    overShoulder->setDirection(Ogre::Vector3(-0.35f, -0.45f, -1.0f), Ogre::Node::TS_PARENT);
}

Stage::~Stage()
{
    if (Ogre::Root* root = Ogre::Root::getSingletonPtr())
        root->destroySceneManager(&scene);
}

} // namespace lodsmith
