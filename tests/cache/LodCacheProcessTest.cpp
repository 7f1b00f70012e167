#include <lodsmith/cache/LodCache.h>

#include "Chains.h"
#include "EntryCodec.h"
#include "support/Child.h"
#include "support/MeshBuilders.h"
#include "support/TestDirectory.h"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace fs = std::filesystem;

namespace lodsmith {

namespace {

using test::same;
using test::sampleChain;
using test::sampleKey;
using test::TestDirectory;

constexpr std::uint64_t kRoomy = 1 << 26;
constexpr std::size_t kIndices = 2000;
constexpr std::uint32_t kSeeds = 40;

/// Stores and looks for entries at random; whether all that was found was right, and something was.
bool hammer(const fs::path& directory, std::uint64_t limit, std::uint32_t randomSeed)
{
    LodCache cache(directory, limit);
    test::TestRandom random(randomSeed);
    int found = 0;
    for (int i = 0; i < 1000; ++i) {
        const std::uint32_t seed = random.bits() % kSeeds;
        const auto chain = cache.find(sampleKey(seed));
        if (chain && !same(*chain, sampleChain(seed, kIndices)))
            return false;
        found += chain ? 1 : 0;
        if (!chain && !cache.store(sampleKey(seed), sampleChain(seed, kIndices)))
            return false;
    }
    return found > 0;
}

/// Stores large entries until it is killed.
bool storeForEver(const fs::path& directory)
{
    LodCache cache(directory, kRoomy);
    std::vector<LodChain> chains;
    for (std::uint32_t seed = 0; seed < 4; ++seed)
        chains.push_back(sampleChain(seed, 100000));
    for (;;)
        for (std::uint32_t seed = 0; seed < 4; ++seed)
            if (!cache.store(sampleKey(seed), chains[seed]))
                return false;
}

/// Every file is a whole entry or a temporary one; the number of the latter.
int countLeftovers(const TestDirectory& directory)
{
    const LodCache cache(directory.path(), kRoomy);
    std::size_t whole = 0;
    for (std::uint32_t seed = 0; seed < 4; ++seed)
        if (fs::exists(directory / (toHex(sampleKey(seed)) + ".lodchain"))) {
            const auto chain = cache.find(sampleKey(seed));
            EXPECT_TRUE(chain && same(*chain, sampleChain(seed, 100000))) << seed;
            ++whole;
        }
    int leftovers = 0;
    for (const std::string& name : directory.files())
        leftovers += name.find(".tmp") != std::string::npos ? 1 : 0;
    EXPECT_EQ(directory.files().size(), whole + static_cast<std::size_t>(leftovers));
    return leftovers;
}

void expectLeftoversToGoWithTime(const TestDirectory& directory)
{
    for (const std::string& name : directory.files())
        if (name.find(".tmp") != std::string::npos)
            fs::last_write_time(directory / name, fs::file_time_type::clock::now() - std::chrono::hours(2));
    LodCache cache(directory.path(), kRoomy);
    EXPECT_TRUE(cache.store(sampleKey(0), sampleChain(0, 100000)));
    EXPECT_EQ(countLeftovers(directory), 0);
}

} // namespace

TEST(LodCacheProcess, twoHammerOneDirectory)
{
    const TestDirectory directory;
    // Room for half of the entries, so that each removes what the other is about to read.
    const std::uint64_t limit = kSeeds / 2 * encodeEntry(sampleKey(0), sampleChain(0, kIndices)).size();
    const pid_t one = test::startChild([&] { return hammer(directory.path(), limit, 1); });
    const pid_t other = test::startChild([&] { return hammer(directory.path(), limit, 2); });
    EXPECT_EQ(test::waitFor(one), 0);
    EXPECT_EQ(test::waitFor(other), 0);
    std::uintmax_t bytes = 0;
    for (const std::string& name : directory.files())
        bytes += fs::file_size(directory / name);
    EXPECT_LE(bytes, limit);
    EXPECT_GT(bytes, 0u);
}

TEST(LodCacheProcess, aKillAtAnyMomentLeavesEveryEntryWhole)
{
    const TestDirectory directory;
    test::TestRandom random(1);
    for (int kill = 0; kill < 40; ++kill) {
        const pid_t child = test::startChild([&] { return storeForEver(directory.path()); });
        ::usleep(5000 + random.bits() % 20000);
        ASSERT_EQ(::kill(child, SIGKILL), 0);
        ASSERT_TRUE(WIFSIGNALED(test::waitFor(child)));
        countLeftovers(directory);
        ASSERT_FALSE(testing::Test::HasFailure()) << "kill " << kill;
    }
    expectLeftoversToGoWithTime(directory);
}

TEST(LodCacheProcess, aKillInMidWriteLeavesATemporaryFileAndNoMore)
{
    const TestDirectory directory;
    const int status = test::waitFor(test::startChild([&] {
        // The system ends the process in the middle of its write, just there.
        const rlimit noCore = {0, 0}, limit = {100000, 100000};
        ::setrlimit(RLIMIT_CORE, &noCore);
        ::signal(SIGXFSZ, SIG_DFL);
        ::setrlimit(RLIMIT_FSIZE, &limit);
        return storeForEver(directory.path());
    }));
    ASSERT_TRUE(WIFSIGNALED(status));
    EXPECT_EQ(countLeftovers(directory), 1);
    EXPECT_EQ(directory.files().size(), 1u);
    expectLeftoversToGoWithTime(directory);
}

} // namespace lodsmith
