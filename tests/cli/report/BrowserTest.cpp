#include "../CommandLine.h"
#include "../SampleFiles.h"
#include "support/VirtualDisplay.h"

#include <gmock/gmock.h>

#include <cstdlib>
#include <fstream>
#include <memory>
#include <regex>

namespace lodsmith::cli {

namespace {

using lodsmith::test::contentOf;
using lodsmith::test::TestDirectory;
using lodsmith::test::VirtualDisplay;
using test::Outcome;
using testing::HasSubstr;
using testing::Not;

constexpr const char* kBrowser = "chromium";

/// Says in the page what became of it, also in a frame as wide as a telephone, and after clicks. Frames of one document
/// share its origin, so that the page can look into them.
constexpr const char* kProbe = R"html(<script>
addEventListener("load", () => {
    const look = (page) => ({
        overflow: page.document.documentElement.scrollWidth - page.innerWidth,
        background: page.getComputedStyle(page.document.body).backgroundColor,
        pictures: Array.from(page.document.images).filter((image) => image.complete && image.naturalWidth > 0).length,
        first: page.document.querySelector("tbody th") ? page.document.querySelector("tbody th").dataset.value : ""
    });
    const say = (name, value) => {
        const element = document.createElement("pre");
        element.textContent = "PROBE " + name + " " + JSON.stringify(value);
        document.body.append(element);
    };
    if (window !== top)
        return;
    const frame = document.createElement("iframe");
    frame.style = "width: 360px; height: 640px; border: 0";
    frame.srcdoc = document.documentElement.outerHTML.replaceAll('loading="lazy"', "");
    frame.addEventListener("load", () => say("phone", look(frame.contentWindow)));
    document.querySelectorAll("img").forEach((image) => image.loading = "eager");
    say("page", look(window));
    document.querySelector("button.theme").click();
    say("clicked", look(window));
    document.querySelector("button.theme").click();
    const sort = document.querySelector("thead button");
    if (sort) {
        sort.click();
        say("up", look(window));
        sort.click();
        say("down", look(window));
    }
    document.body.append(frame);
});
</script>)html";

/// A page whose pictures are empty, so that it can be looked through.
std::string withoutPictures(std::string html)
{
    const std::string begin = "data:image/png;base64,";
    for (std::size_t at = html.find(begin); at != std::string::npos; at = html.find(begin, at)) {
        at += begin.size();
        html.erase(at, html.find('"', at) - at);
    }
    return html;
}

std::size_t count(const std::string& text, const std::string& part)
{
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size()))
        ++found;
    return found;
}

/// A report of two meshes with pictures, one in a directory that is made once.
class ReportBrowserTest : public testing::Test {
protected:
    static void SetUpTestSuite()
    {
        sDirectory = std::make_unique<TestDirectory>();
        // What the browser and OGRE keep stays in here too.
        for (const char* variable : {"HOME", "XDG_CONFIG_HOME", "XDG_CACHE_HOME"})
            ::setenv(variable, (*sDirectory / "home").c_str(), 1);
        sHasBrowser = test::runProgram({kBrowser, "--version"}).exitCode == 0;
        if (!sHasBrowser || !VirtualDisplay::isAvailable())
            return;
        const VirtualDisplay display;
        sDirectory->write("in/small.mesh", test::torusMesh(12));
        sDirectory->write("in/a-rather-long-name-for-a-mesh_that<b>never</b>ends.mesh", test::torusMesh(20));
        const Outcome outcome = test::runLodsmith(
            {"report", "--samples", "1000", "-o", (*sDirectory / "report").string(), (*sDirectory / "in").string()});
        ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    }
    static void TearDownTestSuite() { sDirectory.reset(); }

    void SetUp() override
    {
        if (!sHasBrowser)
            GTEST_SKIP() << kBrowser << " is not installed";
        if (!VirtualDisplay::isAvailable())
            GTEST_SKIP() << "Xvfb is not installed";
    }

    /// The pages of the report: the overview and that of the mesh with most triangles.
    static std::vector<std::string> pages()
    {
        return {(*sDirectory / "report/index.html").string(),
                (*sDirectory / "report/pages/a-rather-long-name-for-a-mesh_that_b_never__b_ends.mesh.html").string()};
    }

    static Outcome browse(const std::string& page, std::vector<std::string> options)
    {
        // A profile of its own: what one page stores is not there for the next.
        const TestDirectory profile;
        options.insert(options.begin(), {kBrowser, "--headless", "--no-sandbox", "--disable-gpu",
                                         "--disable-dev-shm-usage", "--enable-logging=stderr",
                                         "--virtual-time-budget=10000", "--user-data-dir=" + profile.path().string()});
        options.push_back("file://" + page);
        return test::runProgram(options);
    }

    /// What the probe has found, by what it says.
    static std::map<std::string, nlohmann::json> probe(const std::string& page,
                                                       const std::vector<std::string>& options = {})
    {
        const std::string probed = page + ".probe.html";
        std::string html = contentOf(page);
        html.insert(html.rfind("</body>"), kProbe);
        std::ofstream(probed) << html;
        std::vector<std::string> all{"--dump-dom", "--window-size=1280,900"};
        all.insert(all.end(), options.begin(), options.end());
        const Outcome outcome = browse(probed, all);
        EXPECT_THAT(outcome.err, Not(HasSubstr("CONSOLE")));
        std::map<std::string, nlohmann::json> found;
        const std::regex line("<pre>PROBE (\\w+) (.*?)</pre>");
        for (std::sregex_iterator match(outcome.out.begin(), outcome.out.end(), line), end; match != end; ++match)
            found[(*match)[1]] = nlohmann::json::parse((*match)[2].str());
        EXPECT_TRUE(found.count("phone")) << outcome.err;
        return found;
    }

    static std::unique_ptr<TestDirectory> sDirectory;
    static bool sHasBrowser;
};

std::unique_ptr<TestDirectory> ReportBrowserTest::sDirectory;
bool ReportBrowserTest::sHasBrowser = false;

} // namespace

TEST_F(ReportBrowserTest, pagesFitTelephonesAndScreens)
{
    for (const std::string& page : pages()) {
        std::map<std::string, nlohmann::json> found = probe(page);
        EXPECT_LE(found["page"]["overflow"], 0) << page;
        EXPECT_LE(found["phone"]["overflow"], 0) << page;
    }
}

TEST_F(ReportBrowserTest, lightAndDarkComeFromTheSystemAndFromTheButton)
{
    std::map<std::string, nlohmann::json> light = probe(pages()[1], {"--blink-settings=preferredColorScheme=1"});
    std::map<std::string, nlohmann::json> dark = probe(pages()[1], {"--blink-settings=preferredColorScheme=0"});
    EXPECT_NE(light["page"]["background"], dark["page"]["background"]);
    EXPECT_EQ(light["clicked"]["background"], dark["page"]["background"]);
    EXPECT_EQ(dark["clicked"]["background"], light["page"]["background"]);
}

TEST_F(ReportBrowserTest, theTableSortsAtAClick)
{
    std::map<std::string, nlohmann::json> found = probe(pages()[0]);
    EXPECT_THAT(found["page"]["first"].get<std::string>(), HasSubstr("a-rather")) << "most to be saved first";
    EXPECT_THAT(found["up"]["first"].get<std::string>(), HasSubstr("a-rather"));
    EXPECT_THAT(found["down"]["first"].get<std::string>(), HasSubstr("small"));
}

TEST_F(ReportBrowserTest, everyPictureIsShownAndNoneComesFromElsewhere)
{
    for (const std::string& page : pages()) {
        const std::string html = withoutPictures(contentOf(page));
        const std::regex address("(?:src|href|action|srcset|poster)=\"([^\"]*)\"");
        for (std::sregex_iterator match(html.begin(), html.end(), address), end; match != end; ++match) {
            const std::string where = (*match)[1];
            EXPECT_TRUE(where.rfind("data:", 0) == 0
                        || std::regex_match(where, std::regex("(\\.\\./)?[A-Za-z0-9_./-]+")))
                << where;
        }
        const std::size_t pictures = count(html, "<img ");
        EXPECT_GE(pictures, 2u);
        EXPECT_EQ(probe(page)["page"]["pictures"], pictures);
    }
}

TEST_F(ReportBrowserTest, printsHaveThePictures)
{
    for (const std::string& page : pages()) {
        const std::string pdf = (*sDirectory / "page.pdf").string();
        const Outcome outcome = browse(page, {"--print-to-pdf=" + pdf});
        EXPECT_GE(count(contentOf(pdf), "/Subtype /Image"), count(contentOf(page), "<img ")) << outcome.err;
    }
}

} // namespace lodsmith::cli
