#include "LivingEntities.h"

#include "OgreVersion.h"

#include <OgreRoot.h>
#include <OgreSceneManager.h>

namespace lodsmith {

std::vector<Ogre::Entity*> livingEntities(const Ogre::Mesh& mesh)
{
    std::vector<Ogre::Entity*> entities;
    for (const auto& [name, sceneManager] : Ogre::Root::getSingleton().getSceneManagers())
        for (const auto& [entityName, object] : sceneManager->getMovableObjects(entityType()))
            if (auto* entity = static_cast<Ogre::Entity*>(object); entity->getMesh().get() == &mesh)
                entities.push_back(entity);
    return entities;
}

} // namespace lodsmith
