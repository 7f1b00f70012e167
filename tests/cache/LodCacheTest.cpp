#include <lodsmith/cache/LodCache.h>

#include "Chains.h"
#include "EntryCodec.h"
#include "support/TestDirectory.h"

#include <gmock/gmock.h>

#include <atomic>
#include <thread>

namespace fs = std::filesystem;

namespace lodsmith {

namespace {

using test::contentOf;
using test::same;
using test::sampleChain;
using test::sampleKey;
using test::TestDirectory;
using testing::ElementsAre;
using testing::IsEmpty;

constexpr std::uint64_t kRoomy = 1 << 24;

std::string fileOf(const CacheKey& key)
{
    return toHex(key) + ".lodchain";
}

bool finds(const LodCache& cache, const CacheKey& key, const LodChain& chain)
{
    const auto found = cache.find(key);
    return found && same(*found, chain);
}

} // namespace

TEST(LodCache, keepsChainsFromOneObjectToTheNext)
{
    const TestDirectory directory;
    {
        LodCache cache(directory / "a/b", kRoomy);
        ASSERT_TRUE(cache.store(sampleKey(1), sampleChain(1)));
        ASSERT_TRUE(cache.store(sampleKey(2), sampleChain(2, 30000)));
    }
    const LodCache cache(directory / "a/b", kRoomy);
    EXPECT_TRUE(finds(cache, sampleKey(1), sampleChain(1)));
    EXPECT_TRUE(finds(cache, sampleKey(2), sampleChain(2, 30000)));
    EXPECT_FALSE(cache.find(sampleKey(3)));
    EXPECT_THAT(directory.files(), ElementsAre("a/b/" + fileOf(sampleKey(1)), "a/b/" + fileOf(sampleKey(2))));
}

TEST(LodCache, touchesNothingBeforeSomethingIsStored)
{
    const TestDirectory directory;
    const LodCache cache(directory / "cache", kRoomy);
    EXPECT_FALSE(cache.find(sampleKey(1)));
    EXPECT_FALSE(fs::exists(directory / "cache"));
}

TEST(LodCache, aLaterChainReplacesAnEarlierOne)
{
    const TestDirectory directory;
    LodCache cache(directory.path(), kRoomy);
    ASSERT_TRUE(cache.store(sampleKey(1), sampleChain(1)));
    ASSERT_TRUE(cache.store(sampleKey(1), sampleChain(2)));
    EXPECT_TRUE(finds(cache, sampleKey(1), sampleChain(2)));
    EXPECT_EQ(directory.files().size(), 1u);
}

TEST(LodCache, removesAnEntryWithAnyByteChanged)
{
    const TestDirectory directory;
    LodCache cache(directory.path(), kRoomy);
    const std::string entry = encodeEntry(sampleKey(1), sampleChain(1));
    for (std::size_t i = 0; i < entry.size(); ++i) {
        std::string changed = entry;
        changed[i] = static_cast<char>(changed[i] + 1);
        directory.write(fileOf(sampleKey(1)), changed);
        EXPECT_FALSE(cache.find(sampleKey(1))) << i;
        EXPECT_THAT(directory.files(), IsEmpty()) << i;
    }
    ASSERT_TRUE(cache.store(sampleKey(1), sampleChain(1)));
    EXPECT_EQ(contentOf(directory / fileOf(sampleKey(1))), entry);
}

TEST(LodCache, removesAnEntryOfAnyOtherLength)
{
    const TestDirectory directory;
    const LodCache cache(directory.path(), kRoomy);
    const std::string entry = encodeEntry(sampleKey(1), sampleChain(1));
    for (std::size_t length = 0; length < entry.size(); ++length) {
        directory.write(fileOf(sampleKey(1)), entry.substr(0, length));
        EXPECT_FALSE(cache.find(sampleKey(1))) << length;
        EXPECT_THAT(directory.files(), IsEmpty()) << length;
    }
    directory.write(fileOf(sampleKey(1)), entry + '\0');
    EXPECT_FALSE(cache.find(sampleKey(1)));
    EXPECT_THAT(directory.files(), IsEmpty());
}

TEST(LodCache, removesAnEntryThatIsOfAnotherKeyThanItsName)
{
    const TestDirectory directory;
    LodCache cache(directory.path(), kRoomy);
    ASSERT_TRUE(cache.store(sampleKey(1), sampleChain(1)));
    fs::rename(directory / fileOf(sampleKey(1)), directory / fileOf(sampleKey(2)));
    EXPECT_FALSE(cache.find(sampleKey(2)));
    EXPECT_THAT(directory.files(), IsEmpty());
}

TEST(LodCache, aFileTooLargeForAnEntryIsNotRead)
{
    const TestDirectory directory;
    const LodCache cache(directory.path(), kRoomy);
    const std::string path = directory.write(fileOf(sampleKey(1)), "lodchain");
    // A hole: of this size only where it is read.
    fs::resize_file(path, std::uintmax_t(1) << 40);
    EXPECT_FALSE(cache.find(sampleKey(1)));
}

TEST(LodCache, manyThreadsShareOneObject)
{
    const TestDirectory directory;
    const std::size_t entryBytes = encodeEntry(sampleKey(0), sampleChain(0, 1000)).size();
    LodCache cache(directory.path(), 20 * entryBytes);
    std::atomic<int> wrong{0}, found{0};
    std::vector<std::thread> threads;
    for (std::uint32_t t = 0; t < 4; ++t)
        threads.emplace_back([&, t] {
            for (std::uint32_t i = 0; i < 100; ++i) {
                const std::uint32_t seed = (i * (t + 1)) % 30;
                if (const auto chain = cache.find(sampleKey(seed))) {
                    ++found;
                    wrong += same(*chain, sampleChain(seed, 1000)) ? 0 : 1;
                } else {
                    wrong += cache.store(sampleKey(seed), sampleChain(seed, 1000)) ? 0 : 1;
                }
            }
        });
    for (std::thread& thread : threads)
        thread.join();
    EXPECT_EQ(wrong, 0);
    EXPECT_GT(found, 0);
    std::uintmax_t bytes = 0;
    for (const std::string& name : directory.files())
        bytes += fs::file_size(directory / name);
    EXPECT_LE(bytes, 20 * entryBytes);
}

} // namespace lodsmith
