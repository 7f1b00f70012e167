#include "InsidePath.h"

#include "support/TestDirectory.h"

#include <gmock/gmock.h>

namespace fs = std::filesystem;

namespace lodsmith {

namespace {

using test::TestDirectory;
using testing::HasSubstr;

class InsidePathTest : public testing::Test {
protected:
    Result<fs::path> at(const std::string& name) const { return pathInside(mDirectory / "base", name); }

    void expectRefused(const std::string& name, const std::string& about) const
    {
        const Result<fs::path> path = at(name);
        ASSERT_FALSE(path) << name;
        EXPECT_EQ(path.error().code, ErrorCode::InvalidSetting);
        EXPECT_EQ(path.error().file, name);
        EXPECT_THAT(path.error().message, HasSubstr(about));
    }

    TestDirectory mDirectory;
};

} // namespace

TEST_F(InsidePathTest, ordinaryNamesGoBelowTheDirectory)
{
    for (const char* name : {"a", "a.loddef", ".a", "..a", "a..", "...", "a b", "dir/a", "dir/../.a/b"}) {
        const bool ordinary = std::string(name).find("/../") == std::string::npos;
        const Result<fs::path> path = at(name);
        ASSERT_EQ(path.ok(), ordinary) << name;
        if (ordinary) {
            EXPECT_EQ(path.value(), mDirectory / "base" / name);
        }
    }
    EXPECT_FALSE(fs::exists(mDirectory / "base")) << "nothing is made";
}

TEST_F(InsidePathTest, namesThatLeadOutAreRefused)
{
    for (const char* name :
         {"", "/", "/a", "//a", "..", "../a", "a/..", "a/../../b", ".", "./a", "a/./b", "a//b", "a/"})
        expectRefused(name, "no relative path");
}

TEST_F(InsidePathTest, namesOfOtherSystemsAreRefused)
{
    for (const char* name : {"..\\a", "a\\b", "\\a", "c:a", "C:/a", "a.loddef:stream", "a\nb", "a\x7f"})
        expectRefused(name, "a backslash, a colon or a control character");
    expectRefused(std::string("a\0b", 3), "control character");
}

TEST_F(InsidePathTest, linksMayNotLeadOut)
{
    mDirectory.write("outside/a", "");
    mDirectory.write("base/real/a", "");
    fs::create_directory_symlink(mDirectory / "outside", mDirectory / "base/out");
    fs::create_directory_symlink("../outside", mDirectory / "base/up");
    fs::create_directory_symlink("real", mDirectory / "base/in");
    fs::create_directory_symlink(mDirectory / "base/out", mDirectory / "base/twice");
    for (const char* name : {"out/a", "out/new/a", "up/a", "twice/a"})
        expectRefused(name, "symbolic link");
    EXPECT_TRUE(at("in/a"));
    EXPECT_TRUE(at("in/new/a"));
}

TEST_F(InsidePathTest, theDirectoryItselfMayBeALinkAndBeSpelledInAnyWay)
{
    mDirectory.write("base/a", "");
    fs::create_directory_symlink(mDirectory / "base", mDirectory / "link");
    for (const char* spelling : {"link", "link/", "base/", "base/.", "new/../base", "new", "new/"})
        EXPECT_TRUE(pathInside(mDirectory / spelling, "dir/a")) << spelling;
    EXPECT_TRUE(pathInside(".", "dir/a"));
    EXPECT_TRUE(pathInside("none", "dir/a"));
    EXPECT_TRUE(pathInside("/", "tmp/a"));
    EXPECT_FALSE(pathInside("", "a"));
}

TEST_F(InsidePathTest, aDirectoryOfASimilarNameIsOutside)
{
    fs::create_directories(mDirectory / "base");
    fs::create_directories(mDirectory / "base2");
    fs::create_directory_symlink(mDirectory / "base2", mDirectory / "base/out");
    expectRefused("out/a", "symbolic link");
}

TEST_F(InsidePathTest, linksThatGoInCirclesAreAnError)
{
    fs::create_directories(mDirectory / "base");
    fs::create_symlink("loop", mDirectory / "base/loop");
    const Result<fs::path> path = at("loop/a");
    ASSERT_FALSE(path);
    EXPECT_EQ(path.error().code, ErrorCode::Io);
}

} // namespace lodsmith
