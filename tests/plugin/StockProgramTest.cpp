#include <support/TestDirectory.h>
#include <support/VirtualDisplay.h>

#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <map>
#include <sstream>
#include <string>

namespace fs = std::filesystem;

namespace lodsmith::test {
namespace {

/// Runs a program that was built without Lodsmith, in a window.
class StockProgramTest : public testing::Test {
protected:
    using Figures = std::map<std::string, int>;

    void SetUp() override
    {
        if (!VirtualDisplay::isAvailable())
            GTEST_SKIP() << "Xvfb is not installed";
        fs::current_path(mDirectory.path());
    }

    void TearDown() override { fs::current_path(mBefore); }

    /// What the program prints, with a plugins.cfg of what it needs and of further lines.
    Figures run(const std::string& furtherLines, int seconds)
    {
        const VirtualDisplay display;
        mDirectory.write("plugins.cfg", "PluginFolder=/\n"
                                        "Plugin=" LODSMITH_OGRE_PLUGIN_DIR "/RenderSystem_GL\n"
                                        "Plugin=" LODSMITH_OGRE_PLUGIN_DIR "/Codec_STBI\n"
                                            + furtherLines);
        // The plugin's cache belongs to the test as well.
        const std::string command = "XDG_CACHE_HOME=\"$PWD\" '" LODSMITH_STOCK_PROGRAM
                                    "' plugins.cfg '" LODSMITH_MEDIA_DIR "' "
                                    + std::to_string(seconds) + " > figures";
        EXPECT_EQ(std::system(command.c_str()), 0);
        std::istringstream output(contentOf("figures"));
        Figures figures;
        std::string name;
        for (int figure; output >> name >> figure;)
            figures[name] = figure;
        return figures;
    }

    fs::path mBefore = fs::current_path();
    TestDirectory mDirectory;
};

TEST_F(StockProgramTest, GainsLevelsByOneLineOfPluginsCfg)
{
    Figures before = run("", 1);
    Figures after = run("Plugin=" LODSMITH_PLUGIN_DIR "/Plugin_Lodsmith\n", 60);
    ASSERT_EQ(before.size(), 4u);
    for (const char* mesh : {"cottage.mesh", "drake.mesh", "lantern.mesh"}) {
        EXPECT_EQ(before[mesh], 1) << mesh;
        EXPECT_GT(after[mesh], 1) << mesh;
    }
    EXPECT_GT(after["triangles"], 0);
    EXPECT_LT(after["triangles"], before["triangles"] / 4);
}

TEST_F(StockProgramTest, KeepsItsMeshesWhenThePluginIsSwitchedOff)
{
    mDirectory.write("lodsmith.cfg", "enabled=no\n");
    Figures figures = run("Plugin=" LODSMITH_PLUGIN_DIR "/Plugin_Lodsmith\n", 1);
    EXPECT_EQ(figures["cottage.mesh"], 1);
}

} // namespace
} // namespace lodsmith::test
