#include "LodManagerFixture.h"

#include <OgreMeshManager.h>
#include <OgreMeshSerializer.h>

#include <filesystem>
#include <fstream>

namespace lodsmith::test {

const std::string kTwoLevels = "<lod><automatic enabled='false'/><manual>"
                               "<level distance='20'><value>0.5</value></level>"
                               "<level distance='40'><value>0.75</value></level></manual></lod>";

std::string handMade(const std::vector<std::pair<std::string, std::string>>& levels)
{
    std::string text = "<lod><automatic enabled='false'/><manual><type>user</type>";
    for (const auto& [distance, mesh] : levels)
        text.append("<level distance='")
            .append(distance)
            .append("'><meshName>")
            .append(mesh)
            .append("</meshName></level>");
    return text + "</manual></lod>";
}

std::vector<Ogre::Real> values(const Ogre::MeshPtr& mesh)
{
    std::vector<Ogre::Real> values;
    for (Ogre::ushort level = 1; level < mesh->getNumLodLevels(); ++level)
        values.push_back(mesh->getLodLevel(level).userValue);
    return values;
}

std::vector<Ogre::Real> automaticValues(const Ogre::MeshPtr& mesh, const AutomaticLods& automatic)
{
    const Ogre::MeshPtr copy = mesh->clone("copy of " + mesh->getName());
    copy->removeLodLevels();
    EXPECT_TRUE(ProgressiveMeshGenerator().generateAutoconfiguredLodLevels(copy, nullptr, automatic));
    const std::vector<Ogre::Real> result = values(copy);
    Ogre::MeshManager::getSingleton().remove(copy);
    return result;
}

void LodManagerTest::writeMesh(const std::string& name, const TestMesh& source, bool withLevels)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("of " + name, source);
    if (withLevels) {
        LodConfig config;
        config.mesh = mesh;
        config.levels = {{7.0f, {LevelTarget::Kind::Proportional, 0.3}, ""}};
        EXPECT_TRUE(ProgressiveMeshGenerator().generateLodLevels(config));
    }
    Ogre::MeshSerializer().exportMesh(mesh.get(), (mSession.directory() / name).string());
    Ogre::MeshManager::getSingleton().remove(mesh);
    list();
}

void LodManagerTest::writeDefinition(const std::string& name, const std::string& text)
{
    std::ofstream(mSession.directory() / name) << text;
    list();
}

void LodManagerTest::removeFile(const std::string& name)
{
    std::filesystem::remove(mSession.directory() / name);
    list();
}

void LodManagerTest::list()
{
    // OGRE lists a location once, when it is added.
    auto& groups = Ogre::ResourceGroupManager::getSingleton();
    groups.removeResourceLocation(mSession.directory().string(), mSession.group());
    groups.addResourceLocation(mSession.directory().string(), "FileSystem", mSession.group());
}

Ogre::MeshPtr LodManagerTest::load(const std::string& name)
{
    const Ogre::MeshPtr mesh = Ogre::MeshManager::getSingleton().load(name, mSession.group());
    finish();
    return mesh;
}

} // namespace lodsmith::test
