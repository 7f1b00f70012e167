#include <lodsmith/cache/LodCache.h>

#include "Chains.h"
#include "support/Child.h"
#include "support/TestDirectory.h"

#include <gmock/gmock.h>

#include <csignal>
#include <iterator>

#include <sched.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace fs = std::filesystem;

namespace lodsmith {

namespace {

using test::inChild;
using test::same;
using test::sampleChain;
using test::sampleKey;
using test::TestDirectory;
using testing::IsEmpty;
using testing::StartsWith;

constexpr std::uint64_t kRoomy = 1 << 24;
constexpr int kNotPossible = 77;

/// Root may write anywhere: become somebody who may not.
bool becomeNobody()
{
    constexpr uid_t kNobody = 65534;
    return ::geteuid() != 0 || (::setgid(kNobody) == 0 && ::setuid(kNobody) == 0);
}

/// A directory of its own with hardly any room, for this process alone and until it ends.
bool mountTinyDisk(const fs::path& directory)
{
    return ::unshare(CLONE_NEWNS) == 0 && ::mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0
           && ::mount("tmpfs", directory.c_str(), "tmpfs", 0, "size=256k") == 0;
}

/// Stores until there is no room any more: whether that came as an error, left nothing half-written, and what had been stored
/// can be found.
bool fillsDiskWithoutHarm(const fs::path& directory)
{
    LodCache cache(directory, kRoomy);
    std::uint32_t stored = 0;
    Result<Done> last = Done{};
    while (stored < 100 && (last = cache.store(sampleKey(stored), sampleChain(stored, 10000))))
        ++stored;
    if (last || last.error().code != ErrorCode::Io || stored == 0 || cache.find(sampleKey(stored)))
        return false;
    for (std::uint32_t seed = 0; seed < stored; ++seed) {
        const auto chain = cache.find(sampleKey(seed));
        if (!chain || !same(*chain, sampleChain(seed, 10000)))
            return false;
    }
    return std::distance(fs::directory_iterator(directory), {}) == stored;
}

} // namespace

TEST(LodCacheFault, aDirectoryThatCannotBeMadeIsAnError)
{
    const TestDirectory directory;
    directory.write("file", "");
    LodCache cache(directory / "file/cache", kRoomy);
    EXPECT_FALSE(cache.find(sampleKey(1)));
    const Result<Done> stored = cache.store(sampleKey(1), sampleChain(1));
    ASSERT_FALSE(stored);
    EXPECT_EQ(stored.error().code, ErrorCode::Io);
    EXPECT_THAT(stored.error().file, StartsWith((directory / "file").string()));
}

TEST(LodCacheFault, aReadOnlyDirectoryIsReadAndNotWritten)
{
    const TestDirectory directory;
    LodCache cache(directory.path(), kRoomy);
    ASSERT_TRUE(cache.store(sampleKey(1), sampleChain(1)));
    fs::permissions(directory.path(), fs::perms(0555));
    EXPECT_TRUE(inChild([&] {
        if (!becomeNobody())
            return false;
        const Result<Done> stored = cache.store(sampleKey(2), sampleChain(2));
        const auto found = cache.find(sampleKey(1));
        return !stored && stored.error().code == ErrorCode::Io && found && same(*found, sampleChain(1))
               && !cache.find(sampleKey(2));
    }));
    fs::permissions(directory.path(), fs::perms(0755));
    EXPECT_EQ(directory.files().size(), 1u);
}

TEST(LodCacheFault, anEntryThatMayNotBeReadIsNotFoundAndNotRemoved)
{
    const TestDirectory directory;
    LodCache cache(directory.path(), kRoomy);
    ASSERT_TRUE(cache.store(sampleKey(1), sampleChain(1)));
    fs::permissions(directory.path(), fs::perms(0777));
    fs::permissions(directory / directory.files()[0], fs::perms(0));
    EXPECT_TRUE(inChild([&] { return becomeNobody() && !cache.find(sampleKey(1)); }));
    EXPECT_EQ(directory.files().size(), 1u);
}

TEST(LodCacheFault, aFullDiskIsAnErrorAndLeavesNothingHalfWritten)
{
    const TestDirectory directory;
    const int status = test::waitFor(test::startChild([&] {
        if (!mountTinyDisk(directory.path()))
            ::_exit(kNotPossible);
        return fillsDiskWithoutHarm(directory.path());
    }));
    if (WIFEXITED(status) && WEXITSTATUS(status) == kNotPossible)
        GTEST_SKIP() << "a small disk cannot be mounted here; the limit on file sizes stands for it";
    EXPECT_EQ(status, 0);
}

TEST(LodCacheFault, aLimitOnFileSizesIsAnErrorAndLeavesNothingHalfWritten)
{
    const TestDirectory directory;
    EXPECT_TRUE(inChild([&] {
        ::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit = {1000, 1000};
        ::setrlimit(RLIMIT_FSIZE, &limit);
        LodCache cache(directory.path(), kRoomy);
        const Result<Done> stored = cache.store(sampleKey(1), sampleChain(1, 10000));
        return !stored && stored.error().code == ErrorCode::Io && !cache.find(sampleKey(1));
    }));
    EXPECT_THAT(directory.files(), IsEmpty());
}

} // namespace lodsmith
