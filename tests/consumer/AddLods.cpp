#include "AddLods.h"

#include <lodsmith/ogre/ProgressiveMeshGenerator.h>

#include <OgreLogManager.h>

bool addLods(const Ogre::MeshPtr& mesh)
{
    using Kind = lodsmith::LevelTarget::Kind;

    lodsmith::LodConfig config;
    config.mesh = mesh;
    config.levels = {
        {20.0f, {Kind::Proportional, 0.5}, ""}, // from 20 world units on, without half of the vertices
        {60.0f, {Kind::Proportional, 0.8}, ""},
    };
    const auto report = lodsmith::ProgressiveMeshGenerator().generateLodLevels(config);
    if (!report) {
        Ogre::LogManager::getSingleton().logError(lodsmith::describe(report.error()));
        return false;
    }
    for (const auto& level : report.value().levels)
        Ogre::LogManager::getSingleton().stream() << level.triangles << " triangles from " << level.value << " on";
    return true;
}
