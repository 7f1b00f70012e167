#include <support/OgreMeshBuilder.h>
#include <support/OgreSession.h>

#include <lodsmith/ogre/ProgressiveMeshGenerator.h>

#include <OgreMeshManager.h>
#include <OgreSubMesh.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>

namespace lodsmith::test {
namespace {

/// Read, reduce, write, save and load again: every mesh file below the directory of further media.
TEST(RealMediaTest, EveryMeshGetsLevelsThatSurviveAFile)
{
    const std::filesystem::path directory = LODSMITH_EXTRA_MEDIA;
    if (directory.empty())
        GTEST_SKIP() << "LODSMITH_EXTRA_MEDIA is empty";
    OgreSession session;
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(directory))
        if (entry.path().extension() == ".mesh")
            files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    ASSERT_FALSE(files.empty());

    for (const auto& file : files) {
        SCOPED_TRACE(file.string());
        const Ogre::MeshPtr mesh = session.load(file);
        LodConfig config;
        config.mesh = mesh;
        for (const double removed : {0.5, 0.75, 0.875, 0.9375})
            config.levels.push_back(
                {static_cast<Ogre::Real>(100 * removed), {LevelTarget::Kind::Proportional, removed}, {}});
        const auto report = ProgressiveMeshGenerator().generateLodLevels(config);
        ASSERT_TRUE(report) << describe(report.error());
        EXPECT_THAT(brokenLevels(*mesh), testing::IsEmpty());
        ASSERT_GT(mesh->getNumLodLevels(), 1);

        const Ogre::MeshPtr reloaded = session.saveAndReload(mesh);
        EXPECT_THAT(brokenLevels(*reloaded), testing::IsEmpty());
        ASSERT_EQ(reloaded->getNumLodLevels(), mesh->getNumLodLevels());
        for (unsigned short level = 1; level < mesh->getNumLodLevels(); ++level) {
            EXPECT_EQ(reloaded->getLodLevel(level).userValue, mesh->getLodLevel(level).userValue);
            for (std::size_t i = 0; i < mesh->getNumSubMeshes(); ++i)
                EXPECT_EQ(indicesOf(*reloaded->getSubMesh(i)->mLodFaceList[level - 1]),
                          indicesOf(*mesh->getSubMesh(i)->mLodFaceList[level - 1]));
        }
        Ogre::MeshManager::getSingleton().remove(mesh->getHandle());
        Ogre::MeshManager::getSingleton().remove(reloaded->getHandle());
    }
}

} // namespace
} // namespace lodsmith::test
