#include "AtomicFile.h"

#include "support/TestDirectory.h"

#include <gmock/gmock.h>

#include <csignal>

#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace fs = std::filesystem;

namespace lodsmith {

namespace {

using test::contentOf;
using test::TestDirectory;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Result<Done> write(const fs::path& target, const std::string& content, Existing existing)
{
    AtomicFile file(target, existing);
    auto prepared = file.prepare(content);
    return prepared ? file.commit() : prepared;
}

} // namespace

TEST(AtomicFile, appearsWithItsDirectories)
{
    const TestDirectory directory;
    ASSERT_TRUE(write(directory / "a/b/file", "content", Existing::Keep));
    EXPECT_EQ(contentOf(directory / "a/b/file"), "content");
    EXPECT_THAT(directory.files(), ElementsAre("a/b/file"));
}

TEST(AtomicFile, isNotThereBeforeItIsCommitted)
{
    const TestDirectory directory;
    {
        AtomicFile file(directory / "file", Existing::Keep);
        ASSERT_TRUE(file.prepare("content"));
        EXPECT_FALSE(fs::exists(directory / "file"));
    }
    EXPECT_THAT(directory.files(), IsEmpty());
}

TEST(AtomicFile, keepsOrReplacesWhatIsThere)
{
    const TestDirectory directory;
    directory.write("file", "old");
    const Result<Done> kept = write(directory / "file", "new", Existing::Keep);
    ASSERT_FALSE(kept);
    EXPECT_EQ(kept.error().file, (directory / "file").string());
    EXPECT_EQ(contentOf(directory / "file"), "old");
    ASSERT_TRUE(write(directory / "file", "new", Existing::Replace));
    EXPECT_EQ(contentOf(directory / "file"), "new");
    EXPECT_THAT(directory.files(), ElementsAre("file"));
}

TEST(AtomicFile, aFileThatCameInTheMeantimeIsKept)
{
    const TestDirectory directory;
    AtomicFile file(directory / "file", Existing::Keep);
    ASSERT_TRUE(file.prepare("new"));
    directory.write("file", "faster");
    EXPECT_FALSE(file.commit());
    EXPECT_EQ(contentOf(directory / "file"), "faster");
}

TEST(AtomicFile, neverReplacesWhatIsNoFile)
{
    const TestDirectory directory;
    fs::create_directory(directory / "directory");
    ASSERT_EQ(::mkfifo((directory / "pipe").c_str(), 0600), 0);
    EXPECT_FALSE(write(directory / "directory", "x", Existing::Replace));
    EXPECT_FALSE(write(directory / "pipe", "x", Existing::Replace));
    EXPECT_TRUE(fs::is_directory(directory / "directory"));
    EXPECT_TRUE(fs::is_fifo(directory / "pipe"));
}

TEST(AtomicFile, neverReplacesALinkToWhatIsNoFile)
{
    const TestDirectory directory;
    for (const fs::path& target : {fs::path("/dev/null"), directory.path()}) {
        const fs::path link = directory / "link";
        fs::create_symlink(target, link);
        AtomicFile file(link, Existing::Replace);
        const Result<Done> prepared = file.prepare("new");
        ASSERT_FALSE(prepared);
        EXPECT_THAT(prepared.error().message, HasSubstr("is no regular file"));
        EXPECT_TRUE(fs::is_symlink(link));
        fs::remove(link);
    }
}

TEST(AtomicFile, replacesALinkToNothing)
{
    const TestDirectory directory;
    fs::create_symlink("nowhere", directory / "link");
    AtomicFile file(directory / "link", Existing::Replace);
    ASSERT_TRUE(file.prepare("new"));
    ASSERT_TRUE(file.commit());
    EXPECT_EQ(contentOf(directory / "link"), "new");
}

TEST(AtomicFile, replacesALinkAndNotWhatItPointsTo)
{
    const TestDirectory directory;
    directory.write("elsewhere", "old");
    fs::create_symlink(directory / "elsewhere", directory / "link");
    ASSERT_TRUE(write(directory / "link", "new", Existing::Replace));
    EXPECT_EQ(contentOf(directory / "elsewhere"), "old");
    EXPECT_EQ(contentOf(directory / "link"), "new");
}

TEST(AtomicFile, keepsThePermissionsOfWhatItReplaces)
{
    const TestDirectory directory;
    directory.write("file", "old");
    fs::permissions(directory / "file", fs::perms::owner_read | fs::perms::owner_write);
    ASSERT_TRUE(write(directory / "file", "new", Existing::Replace));
    EXPECT_EQ(fs::status(directory / "file").permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST(AtomicFile, runningOutOfSpaceLeavesNothing)
{
    const TestDirectory directory;
    directory.write("file", "old");
    // A limit on file sizes looks like a full disk to write(), and needs no disk of one's own. In a child, since it
    // stays.
    const pid_t child = ::fork();
    if (child == 0) {
        ::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit = {1000, 1000};
        ::setrlimit(RLIMIT_FSIZE, &limit);
        const Result<Done> written = write(directory / "file", std::string(2000, 'x'), Existing::Replace);
        ::_exit(written ? 1 : 0);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
    EXPECT_EQ(contentOf(directory / "file"), "old");
    EXPECT_THAT(directory.files(), ElementsAre("file"));
}

TEST(AtomicFile, leftoversOfTheDeadAreRemovedAndNoOthers)
{
    const TestDirectory directory;
    const std::string others = AtomicFile::temporaryPrefix(47110) + "0.tmp";
    directory.write(AtomicFile::temporaryPrefix(4711) + "0.tmp", "half");
    directory.write(others, "of another process");
    directory.write("mine", "whole");
    AtomicFile::removeLeftovers(directory.path(), 4711);
    EXPECT_THAT(directory.files(), ElementsAre(others, "mine"));
}

TEST(AtomicFile, onlyOldTemporaryFilesAreAbandoned)
{
    const TestDirectory directory;
    const auto now = fs::file_time_type::clock::now();
    for (const char* name : {".lodsmith-1-0.tmp", ".lodsmith-2-0.tmp", "old", ".lodsmith"})
        fs::last_write_time(directory.write(name, ""), now - std::chrono::hours(2));
    fs::last_write_time(directory / ".lodsmith-2-0.tmp", now - std::chrono::minutes(50));
    AtomicFile::removeAbandoned(directory.path());
    EXPECT_THAT(directory.files(), ElementsAre(".lodsmith", ".lodsmith-2-0.tmp", "old"));
    AtomicFile::removeAbandoned(directory / "nothing");
}

TEST(AtomicFile, isWrittenWholeWhetherItHasToOutliveAPowerCutOrNot)
{
    const TestDirectory directory;
    AtomicFile file(directory / "a/file", Existing::Replace, Durability::None);
    ASSERT_TRUE(file.prepare("content"));
    ASSERT_TRUE(file.commit());
    EXPECT_EQ(contentOf(directory / "a/file"), "content");
    EXPECT_THAT(directory.files(), ElementsAre("a/file"));
}

TEST(AtomicFile, knowsTemporaryFilesByTheirNames)
{
    const TestDirectory directory;
    AtomicFile file(directory / "file", Existing::Keep);
    ASSERT_TRUE(file.prepare("content"));
    ASSERT_EQ(directory.files().size(), 1u);
    EXPECT_TRUE(AtomicFile::isTemporary(directory.files()[0]));
    for (const char* name :
         {"", "file", "file.tmp", ".lodsmith-", ".lodsmith-.tmp", ".lodsmith.tmp", ".lodsmith-1-0.tmpx"})
        EXPECT_FALSE(AtomicFile::isTemporary(name)) << name;
}

TEST(ReadFile, namesWhatCannotBeRead)
{
    const TestDirectory directory;
    EXPECT_EQ(readFile(directory / "nothing").error().code, ErrorCode::NotFound);
    EXPECT_EQ(readFile(directory.path()).error().code, ErrorCode::Io);
    EXPECT_EQ(readFile("/dev/zero").error().code, ErrorCode::Io);
    EXPECT_EQ(readFile("/proc/self/mem").error().code, ErrorCode::Io);
    EXPECT_EQ(readFile(directory.write("file", std::string("a\0b", 3))).value(), std::string("a\0b", 3));
}

TEST(ReadFile, refusesWhatIsLargerThanAsked)
{
    const TestDirectory directory;
    const std::string file = directory.write("file", "12345");
    EXPECT_EQ(readFile(file, 5).value(), "12345");
    const Result<std::string> larger = readFile(file, 4);
    ASSERT_FALSE(larger);
    EXPECT_EQ(larger.error().code, ErrorCode::Io);
    EXPECT_EQ(larger.error().message, "is larger than 4 bytes");
}

} // namespace lodsmith
