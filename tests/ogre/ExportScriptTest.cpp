#include <support/TestDirectory.h>

#include <lodsmith/loddef/LoddefXml.h>
#include <lodsmith/ogre/LodDefinitionManager.h>

#include <gmock/gmock.h>

namespace fs = std::filesystem;

namespace lodsmith::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

LodDefinition sample()
{
    LodDefinition definition;
    definition.automatic = false;
    definition.levels.push_back({20.0f, {LevelTarget::Kind::Triangles, 400}, "", ""});
    return definition;
}

class ExportScriptTest : public testing::Test {
protected:
    Result<fs::path> write(const std::string& meshName, const LodDefinition& definition = sample()) const
    {
        return LodDefinitionManager::exportScript(meshName, definition, mDirectory / "out");
    }

    TestDirectory mDirectory;
};

TEST_F(ExportScriptTest, ADefinitionGoesBesideItsMeshAndIsReadAgain)
{
    const Result<fs::path> path = write("dir/a.b.mesh");
    ASSERT_TRUE(path) << describe(path.error());
    EXPECT_EQ(path.value(), mDirectory / "out/dir/a.b.loddef");
    EXPECT_THAT(mDirectory.files(), ElementsAre("out/dir/a.b.loddef"));
    const LoddefReading reading = readLoddefFile(path.value());
    ASSERT_TRUE(reading.ok());
    EXPECT_EQ(*reading.definition, sample());
}

TEST_F(ExportScriptTest, WhatIsThereIsReplacedOrStaysAsItWas)
{
    mDirectory.write("out/a.loddef", "<lod/>");
    LodDefinition wrong = sample();
    wrong.levels[0].value = 0.0f;
    const Result<fs::path> refused = write("a.mesh", wrong);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::InvalidSetting);
    EXPECT_EQ(contentOf(mDirectory / "out/a.loddef"), "<lod/>");
    ASSERT_TRUE(write("a.mesh"));
    EXPECT_EQ(contentOf(mDirectory / "out/a.loddef"), loddefText(sample()).value());
    EXPECT_THAT(mDirectory.files(), ElementsAre("out/a.loddef"));
}

TEST_F(ExportScriptTest, NoMeshNameLeadsOut)
{
    const std::string absolute = (mDirectory / "absolute.mesh").string();
    for (const std::string& name :
         {std::string("../a.mesh"), std::string("dir/../../a.mesh"), std::string("dir/..\\..\\a.mesh"),
          std::string("\\\\server\\a.mesh"), std::string("C:a.mesh"), std::string("C:/a.mesh"), absolute,
          std::string("./a.mesh"), std::string("dir//a.mesh"), std::string(), std::string("dir/"), std::string("/")}) {
        const Result<fs::path> refused = write(name);
        ASSERT_FALSE(refused) << name;
        EXPECT_EQ(refused.error().code, ErrorCode::InvalidSetting) << name;
        EXPECT_THAT(refused.error().message, testing::Not(IsEmpty()));
    }
    EXPECT_THAT(mDirectory.files(), IsEmpty());
    EXPECT_TRUE(write("...mesh")) << "dots alone lead nowhere";
}

TEST_F(ExportScriptTest, LinkedDirectoriesDoNotLeadOut)
{
    mDirectory.write("elsewhere/a.loddef", "<lod/>");
    fs::create_directories(mDirectory / "out/real");
    fs::create_directory_symlink(mDirectory / "elsewhere", mDirectory / "out/link");
    fs::create_directory_symlink(mDirectory / "nowhere", mDirectory / "out/dangling");
    fs::create_directory_symlink("real", mDirectory / "out/inside");
    EXPECT_FALSE(write("link/a.mesh"));
    EXPECT_FALSE(write("link/new/a.mesh"));
    EXPECT_FALSE(write("dangling/a.mesh"));
    EXPECT_TRUE(write("inside/a.mesh"));
    EXPECT_EQ(contentOf(mDirectory / "elsewhere/a.loddef"), "<lod/>");
    EXPECT_FALSE(fs::exists(mDirectory / "nowhere"));
    EXPECT_TRUE(fs::exists(mDirectory / "out/real/a.loddef"));
}

TEST_F(ExportScriptTest, ALinkInPlaceOfTheFileIsReplacedAndNotFollowed)
{
    mDirectory.write("elsewhere/secret", "untouched");
    fs::create_directories(mDirectory / "out");
    fs::create_symlink(mDirectory / "elsewhere/secret", mDirectory / "out/a.loddef");
    ASSERT_TRUE(write("a.mesh"));
    EXPECT_EQ(contentOf(mDirectory / "elsewhere/secret"), "untouched");
    EXPECT_TRUE(fs::is_regular_file(fs::symlink_status(mDirectory / "out/a.loddef")));
}

TEST_F(ExportScriptTest, WhereNothingCanBeWrittenTheReasonIsSaid)
{
    mDirectory.write("out", "a file");
    const Result<fs::path> refused = write("a.mesh");
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::Io);
    EXPECT_THAT(describe(refused.error()), HasSubstr("out"));
    EXPECT_FALSE(LodDefinitionManager::exportScript("a.mesh", sample(), ""));
}

} // namespace
} // namespace lodsmith::test
