#pragma once

#include <lodsmith/ogre/QueuedProgressiveMeshGenerator.h>

#include <OgreLogManager.h>

/// Gives meshes levels of detail while the program runs. Made after Ogre::Root, which makes it work at the start of each
/// frame.
class BackgroundLods {
public:
    BackgroundLods()
    {
        mQueue.signals().injected.connect([](const Ogre::MeshPtr& mesh, const lodsmith::LodReport& report) {
            Ogre::LogManager::getSingleton().stream() << mesh->getName() << ": " << report.levels.size() << " levels";
        });
        mQueue.signals().failed.connect([](const Ogre::MeshPtr&, const lodsmith::Error& error) {
            Ogre::LogManager::getSingleton().logError(lodsmith::describe(error));
        });
    }

    void request(const Ogre::MeshPtr& mesh)
    {
        // Large ones first. What can be wrong with the settings is said here, all the rest by `failed`.
        const auto queued = mQueue.generateAutoconfiguredLodLevels(mesh, mesh->getBoundingSphereRadius());
        if (!queued)
            Ogre::LogManager::getSingleton().logError(lodsmith::describe(queued.error()));
    }

    void finishLoadingScreen() { mQueue.injector().finishAll(); }

private:
    lodsmith::QueuedProgressiveMeshGenerator mQueue;
};
