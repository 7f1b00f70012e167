#include "CommandLine.h"
#include "SampleFiles.h"

#include "support/MeshBuilders.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <csignal>

#include <unistd.h>

namespace fs = std::filesystem;

namespace lodsmith::cli {

namespace {

using Clock = std::chrono::steady_clock;
using lodsmith::test::contentOf;
using lodsmith::test::TestDirectory;

constexpr int kKills = 24;
constexpr int kKillsInMidWrite = 12;
constexpr unsigned kSegments = 64; // enough for a file of many blocks

/// `lodsmith generate MESH -o MESH --force`, again and again, each time from the mesh without levels.
class GenerateKillTest : public testing::Test {
protected:
    GenerateKillTest()
    {
        restore();
        const auto start = Clock::now();
        EXPECT_EQ(test::waitForGroup(this->start()), 0);
        mDuration = Clock::now() - start;
        mNew = contentOf(mMesh);
        EXPECT_GT(mNew.size(), mOld.size());
    }

    void restore() const { mDirectory.write("a.mesh", mOld); }

    pid_t start() const
    {
        return test::startLodsmith({"generate", mMesh, "-o", mMesh, "--force", "--levels", "10:proportional:0.1"});
    }

    /// Kills the program and whatever it has started, all at once, and waits until they are gone.
    static void killAll(pid_t leader)
    {
        ASSERT_EQ(::kill(-leader, SIGKILL), 0);
        test::waitForGroup(leader);
    }

    bool hasTemporary() const
    {
        const std::vector<std::string> names = mDirectory.files();
        return std::any_of(names.begin(), names.end(),
                           [](const std::string& name) { return name.rfind(".lodsmith-", 0) == 0; });
    }

    void removeTemporaries() const
    {
        for (const std::string& name : mDirectory.files())
            if (name != "a.mesh")
                fs::remove(mDirectory / name);
    }

    /// The old mesh or the new one, whole: whether it is the new one.
    bool isNew() const
    {
        const std::string content = contentOf(mMesh);
        EXPECT_TRUE(content == mOld || content == mNew) << content.size() << " bytes";
        return content == mNew;
    }

    TestDirectory mDirectory;
    lodsmith::test::TestRandom mRandom{3};
    std::string mOld = test::torusMesh(kSegments);
    std::string mMesh = (mDirectory / "a.mesh").string();
    std::string mNew;
    Clock::duration mDuration{};
};

} // namespace

TEST_F(GenerateKillTest, atAnyMomentLeavesTheOldMeshOrTheNewOne)
{
    int news = 0;
    // Homes in on the moment when the new mesh comes, however busy the machine is.
    double microseconds = std::chrono::duration<double, std::micro>(mDuration).count();
    for (int kill = 0; kill < kKills; ++kill) {
        restore();
        const pid_t leader = start();
        ::usleep(static_cast<useconds_t>(microseconds * mRandom.uniform(0.3, 1.4)));
        killAll(leader);
        const bool replaced = isNew();
        microseconds *= replaced ? 0.8 : 1.25;
        news += replaced ? 1 : 0;
    }
    EXPECT_GT(news, 0);
    EXPECT_LT(news, kKills);
}

TEST_F(GenerateKillTest, whileItWritesLeavesTheOldMeshOrTheNewOne)
{
    int midWrite = 0;
    for (int kill = 0; kill < kKillsInMidWrite; ++kill) {
        restore();
        removeTemporaries();
        const pid_t leader = start();
        const auto end = Clock::now() + 10 * mDuration + std::chrono::seconds(1);
        while (!hasTemporary() && Clock::now() < end)
            ::usleep(100);
        ::usleep(mRandom.bits() % 500);
        killAll(leader);
        midWrite += hasTemporary() ? 1 : 0;
        isNew();
    }
    EXPECT_GT(midWrite, 0) << "no kill came while the file was written";
}

} // namespace lodsmith::cli
