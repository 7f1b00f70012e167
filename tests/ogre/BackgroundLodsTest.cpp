#include "BackgroundLods.h"

#include <support/OgreMeshBuilder.h>
#include <support/OgreSession.h>

#include <gtest/gtest.h>

namespace lodsmith::test {
namespace {

TEST(BackgroundLodsTest, GivesMeshesTheirLevels)
{
    OgreSession session;
    BackgroundLods lods;
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", makeTerrain(30));
    lods.request(mesh);
    lods.finishLoadingScreen();
    EXPECT_GT(mesh->getNumLodLevels(), 1);
}

} // namespace
} // namespace lodsmith::test
