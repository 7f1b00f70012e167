#include <lodsmith/cache/LodCache.h>

#include "Chains.h"
#include "EntryCodec.h"
#include "support/TestDirectory.h"

#include <gmock/gmock.h>

#include <chrono>
#include <limits>

namespace fs = std::filesystem;

namespace lodsmith {

namespace {

using test::sampleChain;
using test::sampleKey;
using test::TestDirectory;
using testing::Contains;
using testing::ElementsAre;
using testing::Not;

/// Entries of sampleChain() have all about this size.
std::uint64_t entryBytes()
{
    return encodeEntry(sampleKey(0), sampleChain(0)).size();
}

fs::path fileOf(const TestDirectory& directory, std::uint32_t seed)
{
    return directory / (toHex(sampleKey(seed)) + ".lodchain");
}

void makeOlder(const fs::path& path, std::chrono::seconds age)
{
    fs::last_write_time(path, fs::file_time_type::clock::now() - age);
}

std::uintmax_t bytesIn(const TestDirectory& directory)
{
    std::uintmax_t bytes = 0;
    for (const std::string& name : directory.files())
        bytes += fs::file_size(directory / name);
    return bytes;
}

/// The seeds of the entries that are there, out of the first few.
std::vector<std::uint32_t> seedsIn(const TestDirectory& directory)
{
    std::vector<std::uint32_t> seeds;
    for (std::uint32_t seed = 0; seed < 100; ++seed)
        if (fs::exists(fileOf(directory, seed)))
            seeds.push_back(seed);
    return seeds;
}

} // namespace

TEST(LodCacheLimit, holdsAfterEveryStore)
{
    const TestDirectory directory;
    const std::uint64_t limit = 50 * entryBytes();
    LodCache cache(directory.path(), limit);
    for (std::uint32_t seed = 0; seed < 200; ++seed) {
        ASSERT_TRUE(cache.store(sampleKey(seed), sampleChain(seed, seed)));
        ASSERT_LE(bytesIn(directory), limit) << seed;
        ASSERT_TRUE(cache.find(sampleKey(seed))) << seed;
    }
    EXPECT_GE(bytesIn(directory), limit / 2);
}

TEST(LodCacheLimit, whatWasNotUsedForLongestGoesFirst)
{
    const TestDirectory directory;
    // Room for four, whatever their exact sizes.
    LodCache cache(directory.path(), 5 * entryBytes());
    for (const std::uint32_t seed : {2, 0, 3, 1})
        ASSERT_TRUE(cache.store(sampleKey(seed), sampleChain(seed)));
    ASSERT_THAT(seedsIn(directory), ElementsAre(0, 1, 2, 3));
    makeOlder(fileOf(directory, 2), std::chrono::seconds(10));
    makeOlder(fileOf(directory, 0), std::chrono::seconds(40));
    makeOlder(fileOf(directory, 3), std::chrono::seconds(30));
    makeOlder(fileOf(directory, 1), std::chrono::seconds(20));
    ASSERT_TRUE(cache.find(sampleKey(0))); // used just now, so that it stays longest
    ASSERT_TRUE(cache.store(sampleKey(4), sampleChain(4)));
    EXPECT_THAT(seedsIn(directory), ElementsAre(0, 1, 2, 4));
    ASSERT_TRUE(cache.store(sampleKey(5), sampleChain(5)));
    EXPECT_THAT(seedsIn(directory), ElementsAre(0, 2, 4, 5));
}

TEST(LodCacheLimit, whatOthersStoredCountsToo)
{
    const TestDirectory directory;
    const std::uint64_t limit = 40 * entryBytes();
    LodCache one(directory.path(), limit), other(directory.path(), limit);
    for (std::uint32_t seed = 0; seed < 100; ++seed) {
        ASSERT_TRUE((seed % 3 == 0 ? one : other).store(sampleKey(seed), sampleChain(seed)));
        ASSERT_LE(bytesIn(directory), limit) << seed;
    }
}

TEST(LodCacheLimit, anEntryLargerThanItIsNotStored)
{
    const TestDirectory directory;
    LodCache cache(directory.path(), 2 * entryBytes());
    ASSERT_TRUE(cache.store(sampleKey(1), sampleChain(1)));
    const Result<Done> stored = cache.store(sampleKey(2), sampleChain(2, 10000));
    ASSERT_FALSE(stored);
    EXPECT_EQ(stored.error().code, ErrorCode::Unsupported);
    EXPECT_THAT(seedsIn(directory), ElementsAre(1));
    LodCache none(directory / "none", 0);
    EXPECT_FALSE(none.store(sampleKey(1), sampleChain(1)));
    EXPECT_FALSE(fs::exists(directory / "none"));
}

TEST(LodCacheLimit, thereMayBeNone)
{
    const TestDirectory directory;
    LodCache cache(directory.path(), std::numeric_limits<std::uint64_t>::max());
    for (std::uint32_t seed = 0; seed < 20; ++seed)
        ASSERT_TRUE(cache.store(sampleKey(seed), sampleChain(seed)));
    EXPECT_EQ(directory.files().size(), 20u);
}

TEST(LodCacheLimit, aSmallerOneThanBeforeIsKeptFromTheFirstStoreOn)
{
    const TestDirectory directory;
    LodCache before(directory.path(), 100 * entryBytes());
    for (std::uint32_t seed = 0; seed < 20; ++seed)
        ASSERT_TRUE(before.store(sampleKey(seed), sampleChain(seed)));
    LodCache after(directory.path(), 5 * entryBytes());
    ASSERT_TRUE(after.store(sampleKey(20), sampleChain(20)));
    EXPECT_LE(bytesIn(directory), 5 * entryBytes());
    EXPECT_THAT(seedsIn(directory), Contains(20));
}

TEST(LodCacheLimit, filesThatAreNoEntriesAreLeftAlone)
{
    const TestDirectory directory;
    const std::string name = toHex(sampleKey(1));
    const std::vector<std::string> names = {"a.lodchain", name, name + ".lodchain.bak", "x" + name + ".lodchain",
                                            "readme.txt"};
    for (const std::string& foreign : names)
        makeOlder(directory.write(foreign, std::string(1000, 'x')), std::chrono::hours(48));
    fs::create_directory(directory / (name + ".lodchain"));
    LodCache cache(directory.path(), 2 * entryBytes());
    for (std::uint32_t seed = 2; seed < 10; ++seed)
        ASSERT_TRUE(cache.store(sampleKey(seed), sampleChain(seed)));
    for (const std::string& foreign : names)
        EXPECT_TRUE(fs::exists(directory / foreign)) << foreign;
    EXPECT_FALSE(cache.find(sampleKey(1)));
    EXPECT_FALSE(cache.store(sampleKey(1), sampleChain(1)));
}

TEST(LodCacheLimit, oldTemporaryFilesAreClearedAwayAndYoungOnesAreNot)
{
    const TestDirectory directory;
    makeOlder(directory.write(".lodsmith-47-0.tmp", "of somebody killed"), std::chrono::hours(2));
    makeOlder(directory.write(".lodsmith-48-0.tmp", "perhaps being written"), std::chrono::minutes(30));
    LodCache cache(directory.path(), 1 << 20);
    ASSERT_TRUE(cache.store(sampleKey(1), sampleChain(1)));
    EXPECT_THAT(directory.files(), ElementsAre(".lodsmith-48-0.tmp", fileOf(directory, 1).filename().string()));
}

TEST(LodCacheLimit, theDirectoryIsNotLookedAtInEveryStore)
{
    const TestDirectory directory;
    const std::uint64_t limit = 1600 * entryBytes();
    LodCache cache(directory.path(), limit);
    ASSERT_TRUE(cache.store(sampleKey(0), sampleChain(0)));
    // It stays for as long as nobody looks.
    const std::string witness = ".lodsmith-47-0.tmp";
    makeOlder(directory.write(witness, "of somebody killed"), std::chrono::hours(2));
    for (std::uint32_t seed = 1; seed < 90; ++seed)
        ASSERT_TRUE(cache.store(sampleKey(seed), sampleChain(seed)));
    EXPECT_THAT(directory.files(), Contains(witness));
    for (std::uint32_t seed = 90; seed < 120; ++seed)
        ASSERT_TRUE(cache.store(sampleKey(seed), sampleChain(seed)));
    EXPECT_THAT(directory.files(), Not(Contains(witness)));
}

} // namespace lodsmith
