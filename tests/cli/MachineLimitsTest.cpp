#include "MachineLimits.h"

#include "support/TestDirectory.h"

#include <gtest/gtest.h>

namespace lodsmith::cli {

namespace {

using lodsmith::test::TestDirectory;

constexpr const char* kMemory = "MemTotal:       900 kB\nMemFree:        100 kB\nMemAvailable:   500 kB\n";

} // namespace

TEST(MachineLimits, whatIsFreeIsAvailable)
{
    const TestDirectory root;
    root.write("proc/meminfo", kMemory);
    EXPECT_EQ(availableMemory(root.path()), 500u * 1024);
}

TEST(MachineLimits, theTightestControlGroupBinds)
{
    const TestDirectory root;
    root.write("proc/meminfo", kMemory);
    root.write("proc/self/cgroup", "1:name=other:/x\n0::/job/step\n");
    root.write("sys/fs/cgroup/job/step/memory.max", "max\n");
    EXPECT_EQ(availableMemory(root.path()), 500u * 1024) << "no limit";
    root.write("sys/fs/cgroup/job/memory.max", "400000\n");
    root.write("sys/fs/cgroup/job/memory.current", "100000\n");
    EXPECT_EQ(availableMemory(root.path()), 300000u) << "that of the group around it";
    root.write("sys/fs/cgroup/job/step/memory.max", "200000\n");
    EXPECT_EQ(availableMemory(root.path()), 200000u);
    root.write("sys/fs/cgroup/job/step/memory.current", "250000\n");
    EXPECT_EQ(availableMemory(root.path()), 0u);
    root.write("sys/fs/cgroup/job/step/memory.stat", "anon 90000\ninactive_anon 1\ninactive_file 160000\n");
    EXPECT_EQ(availableMemory(root.path()), 110000u) << "what was read from files can be dropped";
}

TEST(MachineLimits, aSystemThatDoesNotTellHasNoNumber)
{
    const TestDirectory root;
    EXPECT_EQ(availableMemory(root.path()), std::nullopt);
}

TEST(MachineLimits, thisMachineTells)
{
    EXPECT_GT(availableMemory(), std::uint64_t(1) << 20);
    EXPECT_GE(usableProcessors(), 1u);
}

} // namespace lodsmith::cli
