#include <support/TestDirectory.h>
#include <support/VirtualDisplay.h>

#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>
#include <string>

namespace fs = std::filesystem;

namespace lodsmith::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Value;

/// The sample client in a small window, for some frames.
class SampleTest : public testing::Test {
protected:
    void SetUp() override
    {
        if (!VirtualDisplay::isAvailable())
            GTEST_SKIP() << "Xvfb is not installed";
    }

    /// What it prints.
    std::string run(const std::string& options)
    {
        const VirtualDisplay display;
        const std::string command = "XDG_CACHE_HOME='" + mDirectory.path().string()
                                    + "' '" LODSMITH_SAMPLE "' --objects 30 --width 160 --height 90 --frames 5 "
                                    + options + " > '" + (mDirectory / "output").string() + "' 2> '"
                                    + errorFile().string() + "'";
        mStatus = std::system(command.c_str());
        return contentOf(mDirectory / "output");
    }

    /// What it prints when the levels have been made while it warmed up, however slow the machine is.
    template <class Test>
    std::string runUntil(const std::string& options, const Test& isComplete)
    {
        std::string output;
        for (const char* seconds : {"2", "10", "60"})
            if (output = run(options + " --warm-up " + seconds); isComplete(output))
                break;
        return output;
    }

    fs::path errorFile() const { return mDirectory / "errors"; }

    TestDirectory mDirectory;
    int mStatus = -1;
};

/// The median of a frame, as the summary has it.
int trianglesOf(const std::string& output)
{
    const std::string before = "ms; median ";
    const std::size_t at = output.find(before);
    return at == std::string::npos ? 0 : std::stoi(output.substr(at + before.size()));
}

TEST_F(SampleTest, HasItsLevelsFromTheLibrary)
{
    const auto allMeshes = AllOf(HasSubstr("tree.mesh: "), HasSubstr("cottage.mesh: "), HasSubstr("lantern.mesh: "),
                                 HasSubstr("drake.mesh: "));
    const std::string output = runUntil("", [&](const std::string& text) { return Value(text, allMeshes); });
    EXPECT_EQ(mStatus, 0);
    EXPECT_THAT(output, allMeshes);
    EXPECT_THAT(output, HasSubstr("5 frames: median "));
    EXPECT_THAT(contentOf(errorFile()), IsEmpty());
}

TEST_F(SampleTest, HasThemFromThePluginOrNone)
{
    const int whole = trianglesOf(run("--no-lods"));
    EXPECT_EQ(mStatus, 0);
    const auto isReduced = [&](const std::string& output) { return trianglesOf(output) < whole / 2; };
    const std::string output = runUntil("--plugin", isReduced);
    EXPECT_EQ(mStatus, 0);
    EXPECT_TRUE(isReduced(output)) << output << " where it was " << whole;
    EXPECT_GT(trianglesOf(output), 0);
    EXPECT_THAT(contentOf(errorFile()), IsEmpty());
}

TEST_F(SampleTest, WritesAPicture)
{
    const fs::path picture = mDirectory / "picture.png";
    run("--screenshot '" + picture.string() + "'");
    EXPECT_EQ(mStatus, 0);
    EXPECT_THAT(contentOf(picture), HasSubstr("PNG"));
}

TEST_F(SampleTest, SaysWhatIsWrong)
{
    run("--screenshot '" + (mDirectory / "missing/picture.png").string() + "'");
    EXPECT_NE(mStatus, 0);
    EXPECT_THAT(contentOf(errorFile()), HasSubstr("lodsmith_sample: "));
    run("--plugin --no-lods");
    EXPECT_NE(mStatus, 0);
    EXPECT_THAT(contentOf(errorFile()), HasSubstr("--no-lods"));
}

} // namespace
} // namespace lodsmith::test
