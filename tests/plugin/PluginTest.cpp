#include <support/MeshBuilders.h>
#include <support/OgreMeshBuilder.h>
#include <support/OgreSession.h>
#include <support/TestDirectory.h>

#include <OgreMeshManager.h>
#include <OgreMeshSerializer.h>
#include <OgrePlugin.h>
#include <OgreRoot.h>

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <thread>

namespace fs = std::filesystem;

namespace lodsmith::test {
namespace {

// Far beyond what anything here takes: a test that has gone wrong ends too.
constexpr std::chrono::seconds kPatience(60);

/// A program with one line in its plugins.cfg, in a working directory of its own.
class PluginTest : public testing::Test {
protected:
    PluginTest() { fs::current_path(mDirectory.path()); }
    ~PluginTest() override { fs::current_path(mBefore); }

    void start()
    {
        std::ofstream("plugins.cfg") << "PluginFolder=" LODSMITH_PLUGIN_DIR "\nPlugin=Plugin_Lodsmith\n";
        mSession = std::make_unique<OgreSession>("plugins.cfg");
        // As OGRE does once there is a window.
        for (Ogre::Plugin* plugin : Ogre::Root::getSingleton().getInstalledPlugins())
            plugin->initialise();
    }

    Ogre::MeshPtr load()
    {
        Ogre::MeshSerializer().exportMesh(makeOgreMesh("sphere", makeUvSphere(40, 30)).get(),
                                          (mSession->directory() / "rock.mesh").string());
        return mSession->loadSaved("rock.mesh");
    }

    static void renderUntilThereAreLevels(const Ogre::Mesh& mesh)
    {
        const auto end = std::chrono::steady_clock::now() + kPatience;
        while (mesh.getNumLodLevels() == 1 && std::chrono::steady_clock::now() < end) {
            Ogre::Root::getSingleton()._fireFrameStarted();
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    }

    fs::path mBefore = fs::current_path();
    TestDirectory mDirectory;
    std::unique_ptr<OgreSession> mSession;
};

TEST_F(PluginTest, OneLineOfPluginsCfgGivesLevelsToEveryMesh)
{
    start();
    const Ogre::MeshPtr mesh = load();
    EXPECT_EQ(mesh->getNumLodLevels(), 1);
    renderUntilThereAreLevels(*mesh);
    EXPECT_GT(mesh->getNumLodLevels(), 1);
}

TEST_F(PluginTest, IsSetUpByLodsmithCfg)
{
    std::ofstream("lodsmith.cfg") << "min_triangles=1000000\n";
    start();
    const Ogre::MeshPtr mesh = load();
    for (int frame = 0; frame < 100; ++frame)
        Ogre::Root::getSingleton()._fireFrameStarted();
    EXPECT_EQ(mesh->getNumLodLevels(), 1);
}

TEST_F(PluginTest, IsOffWhenItsSettingsAreWrong)
{
    std::ofstream("lodsmith.cfg") << "min_triangles=many\n";
    start();
    const Ogre::MeshPtr mesh = load();
    EXPECT_EQ(mesh->getNumLodLevels(), 1);
}

} // namespace
} // namespace lodsmith::test
