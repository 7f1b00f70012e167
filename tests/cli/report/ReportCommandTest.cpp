#include "../CommandLine.h"
#include "../SampleFiles.h"

#include <gmock/gmock.h>

#include <cstdlib>

namespace lodsmith::cli {

namespace {

using lodsmith::test::contentOf;
using lodsmith::test::TestDirectory;
using test::Outcome;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

/// Without a display, so that there are no pictures.
class ReportCommandTest : public testing::Test {
protected:
    ReportCommandTest() { ::unsetenv("DISPLAY"); }

    std::string in(const std::string& name) const { return (mDirectory / name).string(); }

    Outcome report(std::vector<std::string> arguments) const
    {
        arguments.insert(arguments.begin(), {"report", "--samples", "1000", "-o", in("report")});
        return test::runLodsmith(arguments);
    }

    nlohmann::json index() const { return nlohmann::json::parse(contentOf(mDirectory / "report/report.json")); }
    std::string page(const std::string& name) const { return contentOf(mDirectory / ("report/" + name)); }

    TestDirectory mDirectory;
};

} // namespace

TEST_F(ReportCommandTest, aMeshAloneIsOnePage)
{
    const Outcome outcome = report({mDirectory.write("a.mesh", test::torusMesh(24))});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_THAT(mDirectory.files(), ElementsAre("a.mesh", "report/index.html", "report/report.json"));
    const nlohmann::json mesh = index()["meshes"].at(0);
    EXPECT_EQ(mesh["levels_from"], "automatic");
    EXPECT_EQ(mesh["levels"][0]["triangles"], test::torusTriangles(24));
    EXPECT_EQ(mesh["drawn"]["now"], test::torusTriangles(24));
    EXPECT_THAT(page("index.html"), HasSubstr("The file has <strong>no levels</strong>"));
    EXPECT_THAT(page("index.html"), HasSubstr("there is no X display"));
}

TEST_F(ReportCommandTest, levelsInTheFileAreJudgedAsTheyAre)
{
    const std::string mesh = mDirectory.write("a.mesh", test::torusMesh(24));
    ASSERT_EQ(test::runLodsmith({"generate", mesh, "-o", in("b.mesh"), "--levels", "40:triangles:500,90:triangles:100"})
                  .exitCode,
              0);
    EXPECT_EQ(report({in("b.mesh")}).exitCode, 0);
    const nlohmann::json judged = index()["meshes"].at(0);
    EXPECT_EQ(judged["levels_from"], "file");
    ASSERT_EQ(judged["levels"].size(), 3u);
    EXPECT_NEAR(judged["levels"][1]["distance"].get<double>(), std::hypot(40.0, 3.0), 0.1) << "a sphere of radius 3";
    EXPECT_LE(judged["levels"][2]["triangles"], 100);
    const nlohmann::json measured =
        test::runLodsmith({"measure", in("b.mesh"), "--json", "--samples", "1000"}).records().at(0);
    EXPECT_EQ(judged["levels"][2]["surface"], measured["levels"][2]["surface"]);
    // 1080 pixels high, 45 degrees.
    const double pixels = 540.0 / std::tan(M_PI / 8.0) / judged["levels"][2]["distance"].get<double>();
    EXPECT_NEAR(judged["levels"][2]["visible_error"].get<double>(),
                judged["levels"][2]["surface"]["max"].get<double>() * pixels, 1e-6);
    EXPECT_EQ(judged["levels"][2]["stop"], nullptr);
}

TEST_F(ReportCommandTest, aDefinitionBesideTheMeshSaysItsLevels)
{
    const std::string mesh = mDirectory.write("a.mesh", test::torusMesh(24));
    mDirectory.write("a.loddef",
                     "<lod><automatic enabled=\"false\"/><manual><type>automatic</type><strategy>distance</strategy>"
                     "<level distance=\"30\"><method>proportional</method><value>0.5</value></level></manual></lod>");
    EXPECT_EQ(report({mesh}).exitCode, 0);
    const nlohmann::json judged = index()["meshes"].at(0);
    EXPECT_EQ(judged["levels_from"], "definition");
    EXPECT_EQ(judged["definition"], in("a.loddef"));
    EXPECT_EQ(judged["levels"].size(), 2u);
    EXPECT_GT(judged["automatic_levels"].size(), 2u);
}

TEST_F(ReportCommandTest, directoriesGetAnOverviewAndAPageAMesh)
{
    mDirectory.write("in/b/x.mesh", test::torusMesh(8));
    mDirectory.write("in/a/x.mesh", test::torusMesh(30));
    const Outcome outcome = report({in("in"), in("in/a/x.mesh"), in("in/b"), "-j", "2"});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    const nlohmann::json meshes = index()["meshes"];
    ASSERT_EQ(meshes.size(), 2u) << "each file once";
    EXPECT_EQ(meshes[0]["page"], "pages/a_x.mesh.html");
    EXPECT_EQ(index()["totals"]["meshes"], 2);
    const std::string overview = page("index.html");
    EXPECT_LT(overview.find("pages/a_x.mesh.html"), overview.find("pages/b_x.mesh.html")) << "most to be saved first";
    EXPECT_THAT(page("pages/a_x.mesh.html"), HasSubstr("href=\"../index.html\""));
}

TEST_F(ReportCommandTest, equalNamesGetPagesOfTheirOwn)
{
    const std::string first = mDirectory.write("one/x.mesh", test::torusMesh(8));
    const std::string second = mDirectory.write("two/x.mesh", test::torusMesh(9));
    EXPECT_EQ(report({first, second}).exitCode, 0);
    const nlohmann::json meshes = index()["meshes"];
    EXPECT_NE(meshes[0]["page"], meshes[1]["page"]);
    EXPECT_NE(page(meshes[0]["page"]), page(meshes[1]["page"]));
}

TEST_F(ReportCommandTest, aMeshThatFailsIsARow)
{
    mDirectory.write("in/good.mesh", test::torusMesh(8));
    mDirectory.write("in/bad.mesh", "no mesh at all");
    const Outcome outcome = report({in("in"), in("gone.mesh")});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_THAT(outcome.err, HasSubstr("bad.mesh"));
    EXPECT_THAT(outcome.err, HasSubstr("gone.mesh: no such file"));
    EXPECT_EQ(index()["totals"]["failed"], 2);
    EXPECT_EQ(index()["meshes"][0]["page"], nullptr);
    EXPECT_THAT(page("index.html"), HasSubstr("gone.mesh: no such file"));
}

TEST_F(ReportCommandTest, aMeshAloneThatFailsStillHasAFrontPage)
{
    EXPECT_EQ(report({mDirectory.write("bad.mesh", "no mesh at all")}).exitCode, 1);
    EXPECT_THAT(page("index.html"), HasSubstr("bad.mesh"));
}

TEST_F(ReportCommandTest, namesAreEscapedAndPagesHavePlainOnes)
{
    const std::string name = "<img src=x>&\"'\xFF樹 #%.mesh";
    mDirectory.write("in/" + name, test::torusMesh(8));
    mDirectory.write("in/plain.mesh", test::torusMesh(8));
    const Outcome outcome = report({in("in")});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    const std::string first = index()["meshes"][0]["page"];
    EXPECT_THAT(first, testing::MatchesRegex("pages/[A-Za-z0-9_.-]+[.]html"));
    for (const std::string& html : {page("index.html"), page(first)}) {
        EXPECT_THAT(html, Not(HasSubstr("<img src=x>")));
        EXPECT_THAT(html, HasSubstr("&lt;img src=x&gt;&amp;&quot;&#39;\xEF\xBF\xBD樹 #%.mesh"));
        EXPECT_THAT(html, Not(HasSubstr("\xFF")));
    }
}

TEST_F(ReportCommandTest, twoRunsGiveTheSameBytes)
{
    mDirectory.write("in/a.mesh", test::torusMesh(20));
    mDirectory.write("in/b.mesh", test::torusMesh(16));
    EXPECT_EQ(report({in("in"), "-j", "2"}).exitCode, 0);
    std::vector<std::string> before;
    for (const std::string& file : mDirectory.files())
        before.push_back(contentOf(mDirectory / file));
    EXPECT_EQ(report({in("in")}).exitCode, 0) << "over its own report";
    std::size_t i = 0;
    for (const std::string& file : mDirectory.files())
        EXPECT_EQ(contentOf(mDirectory / file), before.at(i++)) << file;
}

TEST_F(ReportCommandTest, otherDirectoriesAreRefused)
{
    const std::string mesh = mDirectory.write("a.mesh", test::torusMesh(8));
    mDirectory.write("report/notes.txt", "mine");
    const Outcome outcome = report({mesh});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_THAT(outcome.err, HasSubstr("--force"));
    EXPECT_THAT(mDirectory.files(), ElementsAre("a.mesh", "report/notes.txt"));
    EXPECT_EQ(report({mesh, "--force"}).exitCode, 0);
    EXPECT_THAT(mDirectory.files(),
                ElementsAre("a.mesh", "report/index.html", "report/notes.txt", "report/report.json"));
}

TEST_F(ReportCommandTest, oddOptionsAreRefused)
{
    const std::string mesh = mDirectory.write("a.mesh", test::torusMesh(8));
    for (const std::vector<std::string>& odd : {std::vector<std::string>{mesh, "--pixels", "0"},
                                                {mesh, "--pixels", "x"},
                                                {mesh, "--samples", "0"},
                                                {mesh, "-j", "0"},
                                                {}})
        EXPECT_EQ(report(odd).exitCode, 2);
    EXPECT_EQ(test::runLodsmith({"report", mesh}).exitCode, 2) << "nowhere to go";
    EXPECT_EQ(test::runLodsmith({"report", mesh, "-o", ""}).exitCode, 2);
    EXPECT_EQ(test::runLodsmith({"report", mesh, "-o", mesh}).exitCode, 2) << "a file";
    EXPECT_THAT(mDirectory.files(), ElementsAre("a.mesh"));
}

TEST_F(ReportCommandTest, theBudgetDecidesWhatIsWarnedOf)
{
    const std::string mesh = mDirectory.write("a.mesh", test::torusMesh(24));
    EXPECT_EQ(report({mesh, "--pixels", "1000"}).exitCode, 0);
    EXPECT_EQ(index()["totals"]["above_budget"], 0);
    EXPECT_EQ(report({mesh, "--pixels", "0.01"}).exitCode, 0);
    EXPECT_EQ(index()["totals"]["above_budget"], 1);
}

} // namespace lodsmith::cli
