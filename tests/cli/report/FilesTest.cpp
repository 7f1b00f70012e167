#include "report/ReportFiles.h"

#include "files/AtomicFile.h"
#include "files/TemporaryDirectory.h"
#include "support/TestDirectory.h"

#include <gmock/gmock.h>

#include <unistd.h>

namespace fs = std::filesystem;

namespace lodsmith::cli {

namespace {

using lodsmith::test::contentOf;
using lodsmith::test::TestDirectory;
using testing::ElementsAre;

std::string index(const std::string& files)
{
    return "{\"format\": \"lodsmith-report\", \"files\": [" + files + "]}";
}

void publish(const fs::path& directory, const std::vector<std::pair<std::string, std::string>>& files)
{
    ReportFiles report(directory);
    for (const auto& [name, bytes] : files)
        ASSERT_TRUE(report.add(name, bytes));
    const Result<Done> published = report.publish();
    ASSERT_TRUE(published) << describe(published.error());
}

} // namespace

TEST(ReportFiles, nothingIsThereBeforeItIsPublished)
{
    const TestDirectory directory;
    ReportFiles report(directory / "report");
    ASSERT_TRUE(report.add("pages/a.html", "a"));
    ASSERT_TRUE(report.add("index.html", std::string("b\0c", 3)));
    EXPECT_TRUE(directory.files().empty());
    ASSERT_TRUE(report.publish());
    EXPECT_THAT(directory.files(), ElementsAre("report/index.html", "report/pages/a.html"));
    EXPECT_EQ(contentOf(directory / "report/index.html"), std::string("b\0c", 3));
}

TEST(ReportFiles, onlyReportsAndEmptyDirectoriesAreWrittenOver)
{
    const TestDirectory directory;
    EXPECT_TRUE(ReportFiles::check(directory / "new", Existing::Keep));
    fs::create_directory(directory / "empty");
    EXPECT_TRUE(ReportFiles::check(directory / "empty", Existing::Keep));
    directory.write("report/report.json", index(""));
    EXPECT_TRUE(ReportFiles::check(directory / "report", Existing::Keep));
    for (const char* other : {"", "{", "[]", "{\"format\": \"other\"}", "{\"format\": [[[1]]]}"}) {
        directory.write("other/report.json", other);
        EXPECT_FALSE(ReportFiles::check(directory / "other", Existing::Keep)) << other;
    }
    directory.write("full/a.txt", "a");
    const Result<Done> refused = ReportFiles::check(directory / "full", Existing::Keep);
    ASSERT_FALSE(refused);
    EXPECT_THAT(refused.error().message, testing::HasSubstr("--force"));
    EXPECT_TRUE(ReportFiles::check(directory / "full", Existing::Replace));
    EXPECT_FALSE(ReportFiles::check(directory / "full/a.txt", Existing::Replace)) << "a file";
}

TEST(ReportFiles, whatAnEarlierReportLeftGoesAndWhatIsNotItsOwnStays)
{
    const TestDirectory directory;
    directory.write("notes.txt", "mine");
    publish(directory.path(), {{"pages/a.html", "1"},
                               {"pages/b.html", "1"},
                               {"report.json", index("\"pages/a.html\", \"pages/b.html\", \"report.json\"")}});
    publish(directory.path(), {{"pages/b.html", "2"}, {"report.json", index("\"pages/b.html\", \"report.json\"")}});
    EXPECT_THAT(directory.files(), ElementsAre("notes.txt", "pages/b.html", "report.json"));
    EXPECT_EQ(contentOf(directory / "pages/b.html"), "2");
}

TEST(ReportFiles, anEarlierReportCannotHaveOtherFilesRemoved)
{
    const TestDirectory directory;
    const std::string precious = directory.write("precious.txt", "mine");
    directory.write("report/report.json",
                    index("\"../precious.txt\", \"" + precious + "\", 7, \"a/../../precious.txt\""));
    publish(directory / "report", {{"report.json", index("")}});
    EXPECT_THAT(directory.files(), ElementsAre("precious.txt", "report/report.json"));
}

TEST(ReportFiles, aFailureLeavesTheEarlierReport)
{
    const TestDirectory directory;
    publish(directory.path(), {{"index.html", "1"}, {"report.json", index("")}});
    fs::create_directories(directory / "pages/a.html/in the way");
    ReportFiles report(directory.path());
    ASSERT_TRUE(report.add("index.html", "2"));
    ASSERT_TRUE(report.add("pages/a.html", "2"));
    EXPECT_FALSE(report.publish());
    EXPECT_EQ(contentOf(directory / "index.html"), "1");
    EXPECT_THAT(directory.files(), ElementsAre("index.html", "report.json"));
}

TEST(TemporaryDirectory, goesWithTheObject)
{
    fs::path path;
    {
        Result<TemporaryDirectory> made = TemporaryDirectory::create();
        ASSERT_TRUE(made);
        const TemporaryDirectory directory = std::move(made).value();
        path = directory.path();
        fs::create_directories(path / "deep/inside");
        EXPECT_TRUE(fs::is_directory(path));
    }
    EXPECT_FALSE(fs::exists(path));
}

TEST(TemporaryDirectory, ofAProcessThatDiedIsSweptAway)
{
    const TestDirectory directory;
    const pid_t dead = 123456789; // beyond any that the system gives
    const std::string name = AtomicFile::temporaryPrefix(dead);
    directory.write(name + "abc/deep/a.mesh", "a");
    directory.write(name + "1.tmp", "a");
    directory.write(AtomicFile::temporaryPrefix(dead + 1) + "abc/a.mesh", "another's");
    directory.write(".lodsmith-0-" + std::to_string(dead) + "-1.tmp", "another machine's");
    AtomicFile::removeLeftovers(directory.path(), dead);
    EXPECT_EQ(directory.files().size(), 2u);
}

} // namespace lodsmith::cli
