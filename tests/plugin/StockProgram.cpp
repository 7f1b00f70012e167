// A program as people write it with OGRE, that knows nothing of levels: what it gets, it gets by its plugins.cfg.
//   lodsmith_stock_program PLUGINS.CFG MODELS SECONDS
// shows the meshes MODELS/NAME/NAME.mesh far away, until each has levels or the time is over. Prints for each mesh its name and number of
// levels, then `triangles` and the triangles of the last frame.

#include <OgreCamera.h>
#include <OgreEntity.h>
#include <OgreLogManager.h>
#include <OgreMesh.h>
#include <OgreRenderWindow.h>
#include <OgreResourceGroupManager.h>
#include <OgreRoot.h>
#include <OgreSceneManager.h>
#include <OgreSceneNode.h>
#include <OgreViewport.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace {

constexpr const char* kModels[] = {"cottage", "drake", "lantern"};

class StockProgram {
public:
    StockProgram(const std::string& plugins, const std::string& models) : mRoot(plugins, "", "")
    {
        mRoot.setRenderSystem(mRoot.getAvailableRenderers().front());
        mRoot.initialise(false);
        mWindow = mRoot.createRenderWindow("stock program", 640, 480, false);
        auto& resources = Ogre::ResourceGroupManager::getSingleton();
        for (const std::string name : kModels)
            resources.addResourceLocation(models + "/" + name, "FileSystem");
        resources.initialiseAllResourceGroups();
        makeScene();
    }

    void renderFor(double seconds)
    {
        const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
        while (!allHaveLevels() && std::chrono::steady_clock::now() < end)
            mRoot.renderOneFrame();
        mRoot.renderOneFrame();
    }

    void report() const
    {
        for (const Ogre::Entity* entity : mEntities)
            std::cout << entity->getMesh()->getName() << ' ' << entity->getMesh()->getNumLodLevels() << '\n';
        std::cout << "triangles " << mWindow->getStatistics().triangleCount << std::endl;
    }

private:
    void makeScene()
    {
        Ogre::SceneManager* scene = mRoot.createSceneManager();
        scene->setAmbientLight(Ogre::ColourValue::White);
        Ogre::Camera* camera = scene->createCamera("camera");
        scene->getRootSceneNode()->createChildSceneNode(Ogre::Vector3(0, 0, 300))->attachObject(camera);
        mWindow->addViewport(camera);
        for (const std::string name : kModels) {
            mEntities.push_back(scene->createEntity(name + ".mesh"));
            scene->getRootSceneNode()->createChildSceneNode()->attachObject(mEntities.back());
        }
    }

    bool allHaveLevels() const
    {
        return std::all_of(mEntities.begin(), mEntities.end(),
                           [](const Ogre::Entity* entity) { return entity->getMesh()->getNumLodLevels() > 1; });
    }

    Ogre::Root mRoot;
    Ogre::RenderWindow* mWindow = nullptr;
    std::vector<Ogre::Entity*> mEntities;
};

} // namespace

int main(int argc, char** argv)
{
    if (argc != 4)
        return 2;
    Ogre::LogManager log;
    log.createLog("", true, false, true);
    StockProgram program(argv[1], argv[2]);
    program.renderFor(std::atof(argv[3]));
    program.report();
}
