#include "LabFixture.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <thread>

#include <unistd.h>

namespace lodsmith::benchmarks {

namespace {

using cli::test::runLodsmith;
using cli::test::startLodsmith;
using cli::test::waitForGroup;

class LabKillTest : public LabFixture {
protected:
    int runsIn(const std::string& database) const
    {
        const bool isThere = std::filesystem::exists(path(database)) && std::filesystem::file_size(path(database)) > 0;
        return isThere ? count(database, "SELECT count(*) FROM run") : 0;
    }

    /// Starts a run and kills it and what it has started when there are so many runs, and a time after that.
    void runAndKill(const std::string& database, int runs, std::chrono::milliseconds after) const
    {
        const pid_t leader = startLodsmith(words(database));
        const auto latest = std::chrono::steady_clock::now() + std::chrono::minutes(2);
        while (runsIn(database) < runs && std::chrono::steady_clock::now() < latest)
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        std::this_thread::sleep_for(after);
        ::kill(-leader, SIGKILL);
        waitForGroup(leader);
    }

    Words words(const std::string& database) const
    {
        Work work;
        work.generators = "lodsmith,lodsmith-core,ogre-curvature";
        work.configurations = "halvings,classic,plain";
        return runWords(database, work);
    }
};

TEST_F(LabKillTest, aRunThatIsKilledGoesOnWhereItStopped)
{
    ASSERT_EQ(runLodsmith(words("whole.db")).exitCode, 0);
    const int all = runsIn("whole.db");
    bool wasPartly = false;
    int runs = 0;
    // At first as soon as there is one run more than before, then ever later: in the middle of another, or between two.
    for (const int delay : {0, 7, 20, 45}) {
        runAndKill("killed.db", std::min(runs + 1, all), std::chrono::milliseconds(delay));
        const int now = runsIn("killed.db");
        EXPECT_GE(now, runs);
        EXPECT_EQ(count("killed.db",
                        "SELECT count(*) FROM run WHERE (SELECT count(*) FROM round WHERE run_id = run.id) < 2 "
                        "OR NOT EXISTS (SELECT * FROM level WHERE run_id = run.id)"),
                  0)
            << "a run is there whole or not at all";
        runs = now;
        wasPartly |= runs > 0 && runs < all;
    }
    ASSERT_EQ(runLodsmith(words("killed.db")).exitCode, 0);
    EXPECT_EQ(shapes("killed.db"), shapes("whole.db"));
    EXPECT_EQ(count("killed.db", "SELECT count(*) FROM run"), all);
    EXPECT_EQ(count("killed.db", "SELECT max(id) FROM run"), all) << "something was done twice";
    EXPECT_TRUE(wasPartly) << "no kill came between the first run and the last";
}

TEST_F(LabKillTest, severalProcessesMayWriteOneDatabase)
{
    ASSERT_EQ(runLodsmith(runWords("one.db")).exitCode, 0);
    std::vector<pid_t> leaders;
    for (int i = 0; i < 3; ++i)
        leaders.push_back(startLodsmith(runWords("shared.db")));
    for (const pid_t leader : leaders)
        EXPECT_EQ(waitForGroup(leader), 0);
    EXPECT_EQ(shapes("shared.db"), shapes("one.db"));
    EXPECT_EQ(count("shared.db", "SELECT max(id) FROM run"), 4);
}

} // namespace

} // namespace lodsmith::benchmarks
