#include <support/MeshBuilders.h>
#include <support/OgreLog.h>
#include <support/OgreMeshBuilder.h>
#include <support/OgreSession.h>
#include <support/TestDirectory.h>

#include <OgreMeshManager.h>
#include <OgreMeshSerializer.h>
#include <OgrePlugin.h>
#include <OgreRoot.h>
#include <OgreSubMesh.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
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

/// A program with one line in its plugins.cfg, in a working directory of its own and for a user of its own.
class PluginTest : public testing::Test {
protected:
    PluginTest()
    {
        fs::current_path(mDirectory.path());
        fs::create_directory("caches");
        useCaches(mDirectory / "caches");
    }
    ~PluginTest() override { fs::current_path(mBefore); }

    static void useCaches(const fs::path& directory) { ::setenv("XDG_CACHE_HOME", directory.c_str(), 1); }

    void start()
    {
        std::ofstream("plugins.cfg") << "PluginFolder=" LODSMITH_PLUGIN_DIR "\nPlugin=Plugin_Lodsmith\n";
        mSession = std::make_unique<OgreSession>("plugins.cfg");
        const OgreLog log;
        // As OGRE does once there is a window.
        for (Ogre::Plugin* plugin : Ogre::Root::getSingleton().getInstalledPlugins())
            plugin->initialise();
        mLog = log.lines();
    }

    Ogre::MeshPtr load(const std::string& name = "rock.mesh", int segments = 40)
    {
        Ogre::MeshSerializer().exportMesh(makeOgreMesh("source of " + name, makeUvSphere(segments, 30)).get(),
                                          (mSession->directory() / name).string());
        return mSession->loadSaved(name);
    }

    static void renderUntilThereAreLevels(const Ogre::Mesh& mesh)
    {
        const auto end = std::chrono::steady_clock::now() + kPatience;
        while (mesh.getNumLodLevels() == 1 && std::chrono::steady_clock::now() < end) {
            Ogre::Root::getSingleton()._fireFrameStarted();
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    }

    /// One run of the program: loads meshes, waits for their levels and ends.
    std::vector<std::vector<std::uint32_t>> run(int meshes = 1)
    {
        start();
        std::vector<std::vector<std::uint32_t>> levels;
        auto log = std::make_unique<OgreLog>();
        for (int i = 0; i < meshes; ++i) {
            const Ogre::MeshPtr mesh = load();
            renderUntilThereAreLevels(*mesh);
            for (const Ogre::IndexData* level : mesh->getSubMesh(0)->mLodFaceList)
                levels.push_back(indicesOf(*level));
            Ogre::MeshManager::getSingleton().removeAll();
        }
        mLog = log->lines();
        log.reset();
        mSession.reset();
        return levels;
    }

    long warnings(const std::string& words) const
    {
        return std::count_if(mLog.begin(), mLog.end(),
                             [&](const std::string& line) { return line.find(words) != std::string::npos; });
    }

    std::vector<fs::path> entries(const fs::path& directory) const
    {
        std::vector<fs::path> paths;
        for (const std::string& name : mDirectory.files())
            if (fs::path(name).parent_path() == directory)
                paths.push_back(mDirectory / name);
        return paths;
    }

    std::vector<std::string> mLog;
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
    std::ofstream("lodsmith.cfg") << "min_triangles=3000\n";
    start();
    const Ogre::MeshPtr small = load("small.mesh", 40);
    const Ogre::MeshPtr large = load("large.mesh", 80);
    renderUntilThereAreLevels(*large);
    EXPECT_GT(large->getNumLodLevels(), 1);
    EXPECT_EQ(small->getNumLodLevels(), 1);
}

TEST_F(PluginTest, IsOffWhenItsSettingsAreWrong)
{
    std::ofstream("lodsmith.cfg") << "min_triangles=many\n";
    start();
    EXPECT_EQ(warnings("Lodsmith is off: lodsmith.cfg:1: 'many' has to be"), 1);
}

TEST_F(PluginTest, IsOffWhenItsSettingsCannotBeRead)
{
    fs::create_directory("lodsmith.cfg");
    start();
    EXPECT_EQ(warnings("Lodsmith is off: lodsmith.cfg: "), 1);
    mSession.reset();
    fs::remove("lodsmith.cfg");
    fs::create_symlink("nowhere", "lodsmith.cfg");
    start();
    EXPECT_EQ(warnings("Lodsmith is off: lodsmith.cfg: "), 1);
}

TEST_F(PluginTest, IsMadeOnceHoweverOftenOgreInitialisesIt)
{
    start();
    for (Ogre::Plugin* plugin : Ogre::Root::getSingleton().getInstalledPlugins())
        plugin->initialise();
    const Ogre::MeshPtr mesh = load();
    renderUntilThereAreLevels(*mesh);
    EXPECT_GT(mesh->getNumLodLevels(), 1);
}

class PluginCacheTest : public PluginTest {};

TEST_F(PluginCacheTest, LevelsAreKeptForTheUserAndTakenFromThereAtTheNextStart)
{
    const auto first = run();
    ASSERT_EQ(entries("caches/lodsmith").size(), 1u);
    const fs::path entry = entries("caches/lodsmith").front();
    const auto longAgo = fs::file_time_type::clock::now() - std::chrono::hours(100);
    fs::last_write_time(entry, longAgo);
    const std::string before = contentOf(entry);
    EXPECT_EQ(run(), first);
    EXPECT_THAT(entries("caches/lodsmith"), testing::ElementsAre(entry));
    EXPECT_EQ(contentOf(entry), before);
    EXPECT_GT(fs::last_write_time(entry), longAgo) << "it was marked as used";
}

TEST_F(PluginCacheTest, SettingsSayWhereAndHowMuch)
{
    std::ofstream("lodsmith.cfg") << "cache_directory=mine/levels\n";
    EXPECT_FALSE(run().empty());
    EXPECT_EQ(entries("mine/levels").size(), 1u);
    EXPECT_TRUE(entries("caches/lodsmith").empty());

    std::ofstream("lodsmith.cfg") << "cache_directory=other\ncache_mib=0\n";
    EXPECT_FALSE(run().empty());
    EXPECT_FALSE(fs::exists("other"));
}

TEST_F(PluginCacheTest, WhatCannotBeKeptIsOneWarningAndNoMore)
{
    mDirectory.write("blocked", "");
    std::ofstream("lodsmith.cfg") << "cache_directory=blocked/levels\n";
    EXPECT_EQ(run(3).size(), 3 * run(1).size());
    EXPECT_EQ(warnings("Lodsmith cannot keep levels for the next start: "), 1);
}

TEST_F(PluginCacheTest, AUserWithoutADirectoryHasNone)
{
    useCaches(mDirectory.write("blocked", ""));
    EXPECT_FALSE(run().empty());
    for (const std::string& name : mDirectory.files())
        EXPECT_EQ(name.find(".lodchain"), std::string::npos) << name;
}

} // namespace
} // namespace lodsmith::test
