#include "LabFixture.h"

#include <gmock/gmock.h>

#include <filesystem>

namespace lodsmith::benchmarks {

namespace {

using cli::test::Outcome;
using cli::test::runLodsmith; // the program of these tests: lodsmith_lab
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class LabCommandTest : public LabFixture {
protected:
    void change(const std::string& database, const std::string& statement) const
    {
        Database opened(path(database), Database::Mode::Existing);
        opened.change([&](soci::session& session) { session << statement; });
    }
};

TEST_F(LabCommandTest, measuresEveryPairOnceAndShowsProgress)
{
    const Outcome first = runLodsmith(runWords("a.db"));
    EXPECT_EQ(first.exitCode, 0) << first.err;
    EXPECT_THAT(first.err, HasSubstr("[1/2] planet-1k, halvings: ogre-curvature "));
    EXPECT_THAT(first.err, HasSubstr(" a minute, about "));
    EXPECT_EQ(count("a.db", "SELECT count(*) FROM run"), 4);
    EXPECT_EQ(count("a.db", "SELECT count(*) FROM round WHERE seconds > 0 AND planning_seconds >= 0 "
                            "AND planning_seconds <= seconds AND processor_seconds > 0 AND reference_seconds > 0"),
              8);
    EXPECT_EQ(count("a.db", "SELECT count(*) FROM run WHERE peak_kb > 0"), 4);
    const std::string shapesBefore = shapes("a.db");
    const Outcome second = runLodsmith(runWords("a.db"));
    EXPECT_EQ(second.exitCode, 0);
    EXPECT_THAT(second.err, IsEmpty());
    EXPECT_EQ(count("a.db", "SELECT max(id) FROM run"), 4);
    EXPECT_EQ(shapes("a.db"), shapesBefore);
}

TEST_F(LabCommandTest, levelsHaveTheFiguresThatTheirDefinitionsSay)
{
    ASSERT_EQ(runLodsmith(runWords("a.db")).exitCode, 0);
    // An index has 32 bits in this mesh.
    EXPECT_EQ(count("a.db", "SELECT count(*) FROM level WHERE bytes <> 12 * triangles"), 0);
    // Only what says when it appears has a size on screen, and a level without triangles has no deviation.
    EXPECT_EQ(count("a.db", "SELECT count(*) FROM level WHERE (pixels IS NULL) <> (target_kind = 'proportional')"), 0);
    EXPECT_EQ(count("a.db", "SELECT count(*) FROM level WHERE pixels > 0 AND NOT abs(visible_px - surface_maximum / "
                            "(SELECT 5.63205528259277 * 32) * sqrt(pixels / pi())) < 1e-3"),
              0); // R / 32 is the fourth level's cost, as in the planet's configuration
    EXPECT_EQ(
        count("a.db", "SELECT count(*) FROM level WHERE surface_mean > surface_rms OR surface_rms > surface_maximum"),
        0);
}

TEST_F(LabCommandTest, moreRoundsAreMeasuredAnewAndFewerAreNot)
{
    ASSERT_EQ(runLodsmith(runWords("a.db")).exitCode, 0);
    ASSERT_EQ(runLodsmith(runWords("a.db", withRounds("1"))).exitCode, 0);
    EXPECT_EQ(count("a.db", "SELECT max(id) FROM run"), 4);
    ASSERT_EQ(runLodsmith(runWords("a.db", withRounds("3"))).exitCode, 0);
    EXPECT_EQ(count("a.db", "SELECT count(*) FROM run"), 4);
    EXPECT_EQ(count("a.db", "SELECT count(*) FROM round"), 12);
}

TEST_F(LabCommandTest, againReplacesWhatIsThere)
{
    ASSERT_EQ(runLodsmith(runWords("a.db")).exitCode, 0);
    const std::string before = shapes("a.db");
    change("a.db", "UPDATE round SET seconds = 1000");
    ASSERT_EQ(runLodsmith(runWords("a.db", {"--again"})).exitCode, 0);
    EXPECT_EQ(shapes("a.db"), before);
    EXPECT_EQ(count("a.db", "SELECT count(*) FROM round"), 8);
    EXPECT_EQ(count("a.db", "SELECT count(*) FROM round WHERE seconds >= 1000"), 0);
}

TEST_F(LabCommandTest, aMeshThatCannotBeLoadedKeepsNoOtherFromBeingMeasured)
{
    mDirectory.write("meshes/broken.mesh", "no mesh");
    Work work;
    work.meshes.push_back(path("meshes"));
    const Outcome outcome = runLodsmith(runWords("a.db", work));
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_THAT(outcome.err, HasSubstr("broken: "));
    EXPECT_EQ(count("a.db", "SELECT count(*) FROM run"), 4);
}

TEST_F(LabCommandTest, showsViewsAndTablesAsMarkdown)
{
    ASSERT_EQ(runLodsmith(runWords("a.db", {"--label", "mine"})).exitCode, 0);
    const Outcome view = runLodsmith({"show", path("a.db"), "speed_up"});
    EXPECT_EQ(view.exitCode, 0) << view.err;
    EXPECT_THAT(view.out, HasSubstr("mine on "));
    EXPECT_THAT(view.out, HasSubstr("| configuration |"));
    EXPECT_THAT(view.out, HasSubstr("planet-1k"));
    EXPECT_THAT(view.out, HasSubstr("geometric mean"));
    const Outcome tables = runLodsmith({"tables", path("a.db"), "--label", "mine"});
    EXPECT_EQ(tables.exitCode, 0) << tables.err;
    for (const char* heading : {"## Time", "## Memory", "## Faults", "## Visible error", "## Worst cases"})
        EXPECT_THAT(tables.out, HasSubstr(heading));
}

TEST_F(LabCommandTest, plotsAreThereWhenTheirLevelsAre)
{
    Work work;
    work.generators = "lodsmith,lodsmith-curvature";
    work.configurations = "classic";
    work.rounds = "1";
    ASSERT_EQ(runLodsmith(runWords("a.db", work)).exitCode, 0);
    const Outcome tooEarly = runLodsmith({"plots", path("a.db"), "-o", path("")});
    EXPECT_EQ(tooEarly.exitCode, 1);
    EXPECT_THAT(tooEarly.err, HasSubstr("nothing on \"all nine candidates"));
    EXPECT_FALSE(std::filesystem::exists(path("automatic-triangles.svg")));

    work.configurations = "candidates";
    ASSERT_EQ(runLodsmith(runWords("a.db", work)).exitCode, 0);
    const Outcome plots = runLodsmith({"plots", path("a.db"), "-o", path("")});
    EXPECT_EQ(plots.exitCode, 0) << plots.err;
    EXPECT_TRUE(std::filesystem::exists(path("automatic-triangles.svg")));
    EXPECT_TRUE(std::filesystem::exists(path("automatic-error.svg")));
    EXPECT_EQ(runLodsmith({"plots", path("a.db"), "-o", path("nowhere")}).exitCode, 2);
}

TEST_F(LabCommandTest, viewsAndLabelsThatAreNotThereAreNamed)
{
    ASSERT_EQ(runLodsmith(runWords("a.db")).exitCode, 0);
    const Outcome view = runLodsmith({"show", path("a.db"), "nonsense"});
    EXPECT_EQ(view.exitCode, 2);
    EXPECT_THAT(view.err, HasSubstr("speed_up, "));
    EXPECT_EQ(runLodsmith({"show", path("a.db"), "run"}).exitCode, 2); // a table, not a view
    const Outcome label = runLodsmith({"tables", path("a.db"), "--label", "other"});
    EXPECT_EQ(label.exitCode, 1);
    EXPECT_THAT(label.err, HasSubstr("has no results of other"));
    EXPECT_EQ(runLodsmith({"compare", path("a.db"), "other", "another"}).exitCode, 1);
}

TEST_F(LabCommandTest, wrongCommandLinesAreRefusedAndMakeNothing)
{
    for (const Words& words : std::vector<Words>{{},
                                                 {"run"},
                                                 {"fly", "a.db"},
                                                 runWords("a.db", withRounds("0")),
                                                 runWords("a.db", {"--generators", "gnomes"}),
                                                 runWords("a.db", {"--configurations", "none"}),
                                                 {"compare", path("a.db")},
                                                 {"compare", path("a.db"), "x", "y", "z"}})
        EXPECT_EQ(runLodsmith(words).exitCode, 2) << testing::PrintToString(words);
    Work unicorn;
    unicorn.meshes = {"unicorn"};
    EXPECT_EQ(runLodsmith(runWords("a.db", unicorn)).exitCode, 1);
    EXPECT_THAT(mDirectory.files(), IsEmpty());
}

/// Two builds measured one after the other, which are the same program.
class LabCompareTest : public LabCommandTest {
protected:
    /// @param rounds  on a small mesh many of them take no time
    void measureBoth(const std::string& rounds) const
    {
        for (const char* label : {"old", "new"})
            ASSERT_EQ(runLodsmith(runWords("a.db", withRounds(rounds), {"--label", label})).exitCode, 0);
    }

    Outcome compare() const { return runLodsmith({"compare", path("a.db"), "old", "new"}); }

    static std::string ofNew(const std::string& generator)
    {
        return " (SELECT run.id FROM run JOIN build ON build.id = build_id WHERE label = 'new' AND generator = '"
               + generator + "')";
    }
};

TEST_F(LabCompareTest, isSilentOnTwoRunsOfTheSameAndFindsASlowdown)
{
    measureBoth("60");
    const Outcome same = compare();
    EXPECT_EQ(same.exitCode, 0) << same.out;
    EXPECT_THAT(same.out, HasSubstr("2 runs compared: 0 worse, "));
    EXPECT_THAT(same.out, Not(HasSubstr("## Levels")));

    change("a.db",
           "UPDATE round SET processor_seconds = 2.5 * processor_seconds WHERE run_id IN" + ofNew("ogre-curvature"));
    EXPECT_EQ(compare().exitCode, 0) << "what others do is no regression";

    change("a.db", "UPDATE round SET processor_seconds = 2.5 * processor_seconds WHERE run_id IN" + ofNew("lodsmith"));
    const Outcome slower = compare();
    EXPECT_EQ(slower.exitCode, 0) << "everything is slower: this is the machine's doing\n" << slower.out;

    change("a.db",
           "UPDATE round SET processor_seconds = processor_seconds / 2.5 WHERE run_id IN" + ofNew("ogre-curvature"));
    const Outcome worse = compare();
    EXPECT_EQ(worse.exitCode, 1) << worse.out;
    EXPECT_THAT(worse.out, HasSubstr("## Single meshes"));
    EXPECT_THAT(worse.out, HasSubstr("WORSE"));
}

TEST_F(LabCompareTest, findsALevelThatIsWorse)
{
    measureBoth("1");
    change("a.db", "UPDATE level SET surface_maximum = 1.5 * surface_maximum, new_border_edges = 1 WHERE number = 3 "
                   "AND run_id IN"
                       + ofNew("lodsmith"));
    const Outcome outcome = compare();
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_THAT(outcome.out, HasSubstr("maximum surface"));
    EXPECT_THAT(outcome.out, HasSubstr("new border edges"));
    EXPECT_THAT(outcome.out, HasSubstr("planet-1k 3"));
    // From another file the newest build is taken.
    ASSERT_EQ(runLodsmith(runWords("b.db", withRounds("1"), {"--label", "other"})).exitCode, 0);
    const Outcome files = runLodsmith({"compare", path("b.db"), path("a.db")});
    EXPECT_EQ(files.exitCode, 1);
    EXPECT_THAT(files.out, HasSubstr("# other -> new"));
}

} // namespace

} // namespace lodsmith::benchmarks
