#include "CommandLine.h"
#include "SampleFiles.h"

#include <support/VirtualDisplay.h>

#include <gmock/gmock.h>

#include <cstdlib>
#include <memory>
#include <optional>

namespace lodsmith::cli {

namespace {

using lodsmith::test::contentOf;
using lodsmith::test::TestDirectory;
using lodsmith::test::VirtualDisplay;
using test::Outcome;
using test::runLodsmith;
using testing::HasSubstr;

/// What is in a variable of the environment, for as long as the object lives.
class Environment {
public:
    Environment(std::string name, const std::string& value) : mName(std::move(name))
    {
        if (const char* before = std::getenv(mName.c_str()))
            mBefore = before;
        ::setenv(mName.c_str(), value.c_str(), 1);
    }
    ~Environment()
    {
        if (mBefore)
            ::setenv(mName.c_str(), mBefore->c_str(), 1);
        else
            ::unsetenv(mName.c_str());
    }
    Environment(const Environment&) = delete;
    Environment& operator=(const Environment&) = delete;

private:
    std::string mName;
    std::optional<std::string> mBefore;
};

class RenderWithoutDisplayTest : public testing::Test {
protected:
    std::string in(const std::string& name) const { return (mDirectory / name).string(); }

    TestDirectory mDirectory;
    Environment mCache{"XDG_CACHE_HOME", in("cache")}; // the OpenGL driver's
    std::string mMesh = mDirectory.write("a.mesh", test::torusMesh(24));
};

/// Skipped where there is no Xvfb.
class RenderCommandTest : public RenderWithoutDisplayTest {
protected:
    void SetUp() override
    {
        if (!VirtualDisplay::isAvailable())
            GTEST_SKIP() << "Xvfb is not installed";
        mDisplay = std::make_unique<VirtualDisplay>();
        // Far away the pictures are small, so that they take less time.
        const std::string levels = "150:proportional:0.5,300:proportional:0.75";
        ASSERT_EQ(runLodsmith({"generate", mMesh, "-o", mLods, "--levels", levels}).exitCode, 0);
    }

    Outcome render(std::vector<std::string> arguments) const
    {
        arguments.insert(arguments.begin(), {"render", "--size", "64"});
        return runLodsmith(arguments);
    }

    std::string mLods = in("lods.mesh");
    std::unique_ptr<VirtualDisplay> mDisplay;
};

/// Width and height of a PNG file; they follow its first chunk's head.
std::pair<unsigned, unsigned> sizeOfPng(const std::string& bytes)
{
    EXPECT_EQ(bytes.substr(0, 8), "\x89PNG\r\n\x1a\n");
    const auto number = [&](std::size_t at) {
        unsigned result = 0;
        for (std::size_t i = at; i < at + 4; ++i)
            result = result << 8 | static_cast<unsigned char>(bytes.at(i));
        return result;
    };
    return {number(16), number(20)};
}

} // namespace

TEST_F(RenderWithoutDisplayTest, isAnErrorThatSaysWhatHelps)
{
    const Environment none("DISPLAY", "");
    const Outcome outcome = runLodsmith({"render", mMesh, "-o", in("a.png")});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_THAT(outcome.err, HasSubstr("lodsmith: " + mMesh + ": pictures need an X display"));
    EXPECT_THAT(outcome.err, HasSubstr("xvfb-run"));
    EXPECT_FALSE(std::filesystem::exists(in("a.png")));
    const Environment wrong("DISPLAY", ":54321");
    const nlohmann::json record = runLodsmith({"render", mMesh, "-o", in("a.png"), "--json"}).records().at(0);
    EXPECT_THAT(record["error"].get<std::string>(), HasSubstr("there is none at :54321"));
    EXPECT_EQ(record["error_code"], "unsupported");
}

TEST_F(RenderWithoutDisplayTest, wrongOptionsAreRefused)
{
    const std::vector<std::vector<std::string>> lines{{},
                                                      {mMesh},
                                                      {mMesh, "-o", ""},
                                                      {mMesh, "-o", in("a.jpg")},
                                                      {mMesh, "-o", mMesh, "--force"},
                                                      {mMesh, mMesh, "-o", in("a.png")},
                                                      {mMesh, "-o", in("a.png"), "--size", "63"},
                                                      {mMesh, "-o", in("a.png"), "--size", "2049"},
                                                      {mMesh, "-o", in("a.png"), "--size", "many"}};
    for (std::vector<std::string> line : lines) {
        line.insert(line.begin(), "render");
        const Outcome outcome = runLodsmith(line);
        EXPECT_EQ(outcome.exitCode, 2) << testing::PrintToString(line);
        EXPECT_EQ(outcome.out, "");
    }
    EXPECT_EQ(contentOf(mMesh), test::torusMesh(24));
}

TEST_F(RenderCommandTest, drawsASheetOfTheLevelsThatTheFileHas)
{
    const Outcome outcome = render({mLods, "-o", in("sheet.png"), "--json"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const nlohmann::json record = outcome.records().at(0);
    EXPECT_EQ(record["automatic"], false);
    EXPECT_EQ(record["strategy"], "distance_sphere");
    EXPECT_EQ(record["error"], nullptr);
    ASSERT_EQ(record["levels"].size(), 3u);
    EXPECT_EQ(record["levels"][0]["triangles"], test::torusTriangles(24));
    EXPECT_EQ(record["levels"][0]["switch_radius"], nullptr);
    EXPECT_EQ(record["levels"][0]["at_switch"]["lit"]["largest"], 0);
    const double radius = record["radius"].get<double>();
    for (const int level : {1, 2}) {
        const nlohmann::json& one = record["levels"][std::size_t(level)];
        EXPECT_NEAR(one["switch_distance"].get<double>(), std::hypot(150.0 * level, radius), 1e-3);
        for (const char* where : {"at_switch", "popping", "close_up"})
            for (const char* paint : {"lit", "checker"}) {
                EXPECT_GT(one[where][paint]["mean"].get<double>(), 0) << where << " " << paint;
                EXPECT_LT(one[where][paint]["ssim"].get<double>(), 1) << where << " " << paint;
                EXPECT_NEAR(one[where][paint]["coverage"].get<double>(), 1, 0.2) << where << " " << paint;
            }
    }
    // Three rows of pictures 64 pixels high, and two columns of them.
    const auto [width, height] = sizeOfPng(contentOf(in("sheet.png")));
    EXPECT_GT(width, 2 * 64u);
    EXPECT_GT(height, 3 * 64u);
}

TEST_F(RenderCommandTest, givesAMeshWithoutLevelsItsAutomaticOnes)
{
    const Outcome outcome = render({mMesh, "-o", in("sheet.png"), "--json"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const nlohmann::json record = outcome.records().at(0);
    EXPECT_EQ(record["automatic"], true);
    EXPECT_GT(record["levels"].size(), 1u);
    EXPECT_EQ(contentOf(mMesh), test::torusMesh(24)) << "the file stays as it is";
}

TEST_F(RenderCommandTest, theSameSheetComesOutAgain)
{
    const Outcome first = render({mLods, "-o", in("first.png")}), second = render({mLods, "-o", in("second.png")});
    ASSERT_EQ(first.exitCode, 0) << first.err;
    EXPECT_EQ(first.out, second.out);
    EXPECT_THAT(first.out, HasSubstr("SSIM"));
    EXPECT_TRUE(contentOf(in("first.png")) == contentOf(in("second.png")));
}

TEST_F(RenderCommandTest, takesMaterialsFromAnotherDirectory)
{
    // The torus asks for the material "Stone".
    const std::string material = "material Stone\n{\ntechnique\n{\npass\n{\nlighting off\ntexture_unit\n{\n"
                                 "colour_op_ex source1 src_manual src_current 0 1 0\n}\n}\n}\n}\n";
    mDirectory.write("paint/stone.material", material);
    const auto closeUp = [&](const std::vector<std::string>& more) {
        std::vector<std::string> arguments{mLods, "-o", in("sheet.png"), "--json", "--force"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const nlohmann::json record = render(arguments).records().at(0);
        EXPECT_EQ(record["error"], nullptr);
        return record["levels"][2]["close_up"];
    };
    const nlohmann::json grey = closeUp({}), painted = closeUp({"--materials", in("paint")});
    EXPECT_NE(painted["lit"], grey["lit"]);
    EXPECT_EQ(painted["checker"], grey["checker"]);
    mDirectory.write("stone.material", material);
    EXPECT_EQ(closeUp({}), painted) << "the same beside the mesh";
    const Outcome outcome = render({mLods, "-o", in("other.png"), "--materials", in("nowhere")});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_THAT(outcome.err, HasSubstr("lodsmith: " + in("nowhere") + ": no such directory"));
}

TEST_F(RenderCommandTest, takesNothingButMaterialsFromThere)
{
    mDirectory.write("paint/lods.mesh", test::torusMesh(12));
    const nlohmann::json record =
        render({mLods, "-o", in("sheet.png"), "--json", "--materials", in("paint")}).records().at(0);
    EXPECT_EQ(record["automatic"], false);
    ASSERT_EQ(record["levels"].size(), 3u);
    EXPECT_EQ(record["levels"][0]["triangles"], test::torusTriangles(24));
}

TEST_F(RenderCommandTest, texturesThatAreNotThereAreGreyAndNoted)
{
    const auto closeUp = [&](const std::string& material, const std::vector<std::string>& notes) {
        mDirectory.write("stone.material", material);
        const nlohmann::json record = render({mLods, "-o", in("sheet.png"), "--json", "--force"}).records().at(0);
        EXPECT_EQ(record["error"], nullptr);
        EXPECT_EQ(record["notes"], nlohmann::json(notes));
        return record["levels"][2]["close_up"]["lit"];
    };
    const nlohmann::json none = closeUp("", {"submesh 0 has no material that is there: drawn grey"});
    const nlohmann::json missing =
        closeUp("material Stone\n{\ntechnique\n{\npass\n{\ntexture_unit\n{\ntexture gone.png\n}\n}\n}\n}\n",
                {"texture 'gone.png' of material 'Stone' cannot be read: drawn grey"});
    EXPECT_EQ(missing, none);
}

TEST_F(RenderCommandTest, aHandMadeLevelThatIsNotThereIsNamed)
{
    mDirectory.write("flat.mesh", test::torusMesh(8));
    const std::string mesh = in("hand.mesh");
    ASSERT_EQ(runLodsmith({"generate", mMesh, "-o", mesh, "--levels", "150:mesh:" + in("flat.mesh")}).exitCode, 0);
    for (const char* content : {"", "no mesh"}) {
        mDirectory.write("flat.mesh", content);
        const Outcome outcome = render({mesh, "-o", in("sheet.png")});
        EXPECT_EQ(outcome.exitCode, 1);
        EXPECT_THAT(outcome.err, HasSubstr("level 1: the mesh 'flat.mesh' is not there"));
    }
    std::filesystem::remove(in("flat.mesh"));
    EXPECT_THAT(render({mesh, "-o", in("sheet.png")}).err, HasSubstr("level 1: the mesh 'flat.mesh' is not there"));
}

TEST_F(RenderCommandTest, overwritesOnRequestAlone)
{
    mDirectory.write("sheet.png", "mine");
    const Outcome outcome = render({mLods, "-o", in("sheet.png")});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_THAT(outcome.err, HasSubstr("--force"));
    EXPECT_EQ(contentOf(in("sheet.png")), "mine");
    EXPECT_EQ(render({mLods, "-o", in("sheet.png"), "--force"}).exitCode, 0);
    EXPECT_NE(contentOf(in("sheet.png")), "mine");
}

TEST_F(RenderCommandTest, aBrokenMeshIsAnErrorAndLeavesNothing)
{
    const std::string bytes = test::torusMesh(24);
    for (const std::string& content : {std::string(), std::string("no mesh"), bytes.substr(0, bytes.size() / 2)}) {
        const std::string broken = mDirectory.write("broken.mesh", content);
        const Outcome outcome = render({broken, "-o", in("sheet.png")});
        EXPECT_EQ(outcome.exitCode, 1);
        EXPECT_THAT(outcome.err, HasSubstr("lodsmith: " + broken + ": "));
        EXPECT_FALSE(std::filesystem::exists(in("sheet.png")));
    }
    const Outcome missing = render({in("missing.mesh"), "-o", in("sheet.png")});
    EXPECT_EQ(missing.exitCode, 1);
    EXPECT_THAT(missing.err, HasSubstr("lodsmith: " + in("missing.mesh") + ": "));
}

TEST_F(RenderCommandTest, aFullDiskLeavesNothing)
{
    const Outcome outcome = runLodsmith({"render", "--size", "64", mLods, "-o", in("full/sheet.png")}, 2000);
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_FALSE(std::filesystem::exists(in("full/sheet.png")));
    EXPECT_TRUE(!std::filesystem::exists(in("full")) || std::filesystem::is_empty(in("full")));
}

} // namespace lodsmith::cli
