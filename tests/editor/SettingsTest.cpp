#include <Settings.h>

#include <support/TestDirectory.h>

#include <gmock/gmock.h>

#include <cstdlib>
#include <fstream>

namespace lodsmith::editor {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class SettingsTest : public testing::Test {
protected:
    void TearDown() override
    {
        ::unsetenv("XDG_CONFIG_HOME");
        ::setenv("HOME", mHome.c_str(), 1);
    }

    test::TestDirectory mDirectory;
    std::filesystem::path mFile = mDirectory / "lodsmith" / "editor.json";
    std::string mHome = std::getenv("HOME") ? std::getenv("HOME") : "";
};

TEST_F(SettingsTest, ComeBackAsTheyWere)
{
    Settings settings;
    settings.window = WindowPlace{-20, 30, 1280, 1024, true};
    settings.addRecentFile("/a/ö \"quoted\".mesh");
    settings.addRecentFile("/b.mesh");
    ASSERT_TRUE(writeSettings(mFile, settings));
    const auto read = readSettings(mFile);
    ASSERT_TRUE(read) << describe(read.error());
    ASSERT_TRUE(read.value().window);
    EXPECT_EQ(read.value().window->x, -20);
    EXPECT_EQ(read.value().window->y, 30);
    EXPECT_EQ(read.value().window->width, 1280);
    EXPECT_EQ(read.value().window->height, 1024);
    EXPECT_TRUE(read.value().window->maximised);
    EXPECT_THAT(read.value().recentFiles, ElementsAre("/b.mesh", "/a/ö \"quoted\".mesh"));
}

TEST_F(SettingsTest, HaveDefaultsWithoutAFile)
{
    const auto read = readSettings(mFile);
    ASSERT_TRUE(read);
    EXPECT_FALSE(read.value().window);
    EXPECT_THAT(read.value().recentFiles, IsEmpty());
}

TEST_F(SettingsTest, SayWhatIsWrongWithAFile)
{
    std::filesystem::create_directories(mFile.parent_path());
    for (const char* text : {"", "{", "[]", "{\"recentFiles\": 3}", "{\"recentFiles\": [], \"window\": {\"x\": \"a\"}}",
                             "{\"recentFiles\": [1]}", "{\"recentFiles\": [], \"window\": 1}"}) {
        std::ofstream(mFile) << text;
        const auto read = readSettings(mFile);
        ASSERT_FALSE(read) << text;
        EXPECT_EQ(read.error().code, ErrorCode::BadFile) << text;
        EXPECT_THAT(describe(read.error()), HasSubstr("editor.json: not the editor's settings")) << text;
    }
}

TEST_F(SettingsTest, KeepARecentFileOnceAndOnlySoMany)
{
    Settings settings;
    settings.addRecentFile("/first.mesh");
    for (std::size_t i = 0; i < Settings::kMaxRecentFiles - 1; ++i)
        settings.addRecentFile("/" + std::to_string(i) + ".mesh");
    settings.addRecentFile("/first.mesh");
    EXPECT_EQ(settings.recentFiles.size(), Settings::kMaxRecentFiles);
    EXPECT_EQ(settings.recentFiles.front(), "/first.mesh");
    settings.addRecentFile("/new.mesh");
    EXPECT_EQ(settings.recentFiles.size(), Settings::kMaxRecentFiles);
    EXPECT_EQ(settings.recentFiles.front(), "/new.mesh");
    EXPECT_EQ(settings.recentFiles.back(), "/1.mesh");
}

TEST_F(SettingsTest, AreTakenWithANameThatIsNoUtf8)
{
    Settings settings;
    settings.addRecentFile("/bad\xff.mesh");
    ASSERT_TRUE(writeSettings(mFile, settings));
    EXPECT_TRUE(readSettings(mFile));
}

TEST_F(SettingsTest, AreWhereTheEnvironmentSays)
{
    ::setenv("XDG_CONFIG_HOME", "/config", 1);
    EXPECT_EQ(settingsFile(), "/config/lodsmith/editor.json");
    // A relative directory is to be ignored, says the specification of these variables.
    ::setenv("XDG_CONFIG_HOME", "config", 1);
    ::setenv("HOME", "/home/me", 1);
    EXPECT_EQ(settingsFile(), "/home/me/.config/lodsmith/editor.json");
    ::unsetenv("HOME");
    EXPECT_EQ(settingsFile(), "");
}

TEST_F(SettingsTest, ThatCannotBeWrittenAreAnError)
{
    std::ofstream(mDirectory / "lodsmith") << "a file where a directory should be";
    const auto written = writeSettings(mFile, {});
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().code, ErrorCode::Io);
}

} // namespace
} // namespace lodsmith::editor
