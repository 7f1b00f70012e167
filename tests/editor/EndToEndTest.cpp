#include "EditorSession.h"

#include <lodsmith/loddef/LoddefXml.h>

#include <nlohmann/json.hpp>

#include <gmock/gmock.h>

#include <cstdlib>
#include <fstream>

namespace fs = std::filesystem;

namespace lodsmith::test {
namespace {

using testing::HasSubstr;

/// An artist's work, with mouse and keyboard, on a copy of one of the models.
class EndToEndTest : public testing::Test {
protected:
    void SetUp() override
    {
        if (!EditorSession::isAvailable())
            GTEST_SKIP() << "Xvfb or xdotool is not installed";
        fs::copy(LODSMITH_MEDIA_DIR "/drake", mModels.path(), fs::copy_options::recursive);
    }

    fs::path mesh() const { return mModels / "drake.mesh"; }
    fs::path loddef() const { return mModels / "drake.loddef"; }

    std::unique_ptr<EditorSession> open()
    {
        auto session = std::make_unique<EditorSession>(std::vector<std::string>{mesh().string()});
        EXPECT_TRUE(session->waitFor("lodsmith.panel.state.mesh ~= nil and " + kRests)) << session->errors();
        return session;
    }

    static bool rests(EditorSession& session) { return session.waitFor(kRests); }

    static int levelCount(EditorSession& session)
    {
        return std::stoi(session.ask("lodsmith.panel.state:levelCount()"));
    }

    static std::string message(EditorSession& session)
    {
        return session.ask("lodsmith.panel.state.message and lodsmith.panel.state.message.text");
    }

    /// Clears the box that has the focus, types, and presses Enter.
    static void enter(EditorSession& session, const std::string& box, const std::string& text)
    {
        session.click(box);
        session.key("ctrl+a");
        session.type(text);
        session.key("Return");
    }

    static void makeManual(EditorSession& session)
    {
        session.click(session.at("Automatic", 0.05));
        ASSERT_TRUE(session.waitFor("not lodsmith.panel.state.definition:isAutomatic()"));
    }

    static void addLevel(EditorSession& session, const std::string& value)
    {
        const int before = levelCount(session);
        session.click("Add");
        ASSERT_TRUE(session.waitFor("lodsmith.panel.valuePrompt.dialog.window:isVisible()"));
        session.key("ctrl+a");
        session.type(value);
        session.key("Return");
        ASSERT_TRUE(session.waitFor("lodsmith.panel.state:levelCount() == " + std::to_string(before + 1)))
            << message(session);
    }

    /// Triangles of each level as `lodsmith inspect` counts them in what `lodsmith generate` makes of the saved definition.
    std::vector<int> trianglesByCommand() const
    {
        const fs::path output = mModels / "with-levels.mesh";
        const fs::path record = mModels / "record.json";
        const std::string command = "'" LODSMITH_CLI "' generate '" + mesh().string() + "' -o '" + output.string()
                                    + "' --force > /dev/null 2>&1 && '" LODSMITH_CLI "' inspect --json '"
                                    + output.string() + "' > '" + record.string() + "'";
        EXPECT_EQ(std::system(command.c_str()), 0);
        std::vector<int> triangles;
        const auto inspected = nlohmann::json::parse(contentOf(record));
        for (const auto& level : inspected.at("levels"))
            triangles.push_back(level.at("triangles"));
        return triangles;
    }

    inline static const std::string kRests = "not lodsmith.panel.state:isGenerating()";

    TestDirectory mModels;
};

TEST_F(EndToEndTest, LevelsAreMadeSeenSavedAndFoundAgain)
{
    const auto session = open();
    EXPECT_EQ(session->ask("lodsmith.panel.state.mesh:name()"), "drake.mesh");
    makeManual(*session);
    for (const char* value : {"10", "20", "40"})
        addLevel(*session, value);
    ASSERT_TRUE(rests(*session));
    EXPECT_EQ(session->ask("#lodsmith.panel.state.mesh:info().levels"), "3");

    // The slider of the level that was added last, from where it is almost to its end.
    const std::string triangles = "lodsmith.panel.state.mesh:triangles(3)";
    const int before = std::stoi(session->ask(triangles));
    const ScreenPoint thumb = session->middleOf("lodsmith.panel.definitionPane.slider:getChild('__auto_thumb__')");
    const ScreenPoint end = session->at("AmountSlider", 0.95);
    session->press(thumb);
    for (int step = 1; step <= 5; ++step)
        session->move({thumb.x + (end.x - thumb.x) * step / 5, thumb.y});
    session->release();
    ASSERT_TRUE(session->waitFor(triangles + " < " + std::to_string(before * 2 / 3) + " and " + kRests));

    // The level is forced: the preview shows as many triangles as the mesh has there.
    session->tell("lodsmith.panel.previewPane:showLevel(3)");
    ASSERT_TRUE(session->waitFor("lodsmith.preview:shownLevel() == 3"));
    ASSERT_TRUE(session->waitFor("lodsmith.preview:triangles() == " + triangles));
    const int shown = std::stoi(session->ask("lodsmith.preview:triangles()"));

    session->key("ctrl+s");
    ASSERT_TRUE(session->waitFor("not lodsmith.panel.state:isDirty()")) << message(*session);
    const std::string amount = session->ask("lodsmith.panel.state:level(3):amount()");
    const std::vector<int> byCommand = trianglesByCommand();
    ASSERT_GE(byCommand.size(), 3u);
    EXPECT_EQ(byCommand.back(), shown);

    const auto again = open();
    EXPECT_EQ(levelCount(*again), 3);
    for (const auto& [level, value] : {std::pair(1, "10"), std::pair(2, "20"), std::pair(3, "40")})
        EXPECT_EQ(again->ask("lodsmith.panel.state:level(" + std::to_string(level) + "):value()"), value);
    EXPECT_EQ(again->ask("lodsmith.panel.state:level(3):amount()"), amount);
    EXPECT_TRUE(again->waitFor(triangles + " == " + std::to_string(shown)));
}

TEST_F(EndToEndTest, WrongInputIsSaidAndLosesNothing)
{
    const auto session = open();
    makeManual(*session);
    addLevel(*session, "10");

    // Nothing has been copied: the button is disabled, and the key says so.
    session->click("Paste");
    session->click("LevelList");
    session->key("ctrl+v");
    ASSERT_TRUE(
        session->waitFor("lodsmith.panel.state.message ~= nil and lodsmith.panel.state.message.kind == 'error'"));
    EXPECT_THAT(message(*session), HasSubstr("copied"));
    EXPECT_EQ(levelCount(*session), 1);
    EXPECT_EQ(session->ask("lodsmith.panel.valuePrompt.dialog.window:isVisible()"), "false");

    session->click("Add");
    ASSERT_TRUE(session->waitFor("lodsmith.panel.valuePrompt.dialog.window:isVisible()"));
    const std::string prompt = "lodsmith.panel.valuePrompt.dialog.parts.";
    for (const std::string wrong : {"10", "twelve", "-3", "1e30"}) {
        session->key("ctrl+a");
        session->type(wrong);
        session->key("Return");
        ASSERT_TRUE(session->waitFor(prompt + "PromptValue:getText() == '" + wrong + "' and " + prompt
                                     + "PromptError:getText() ~= ''"))
            << wrong;
        EXPECT_EQ(session->ask("lodsmith.panel.valuePrompt.dialog.window:isVisible()"), "true") << wrong;
    }
    session->key("Escape");
    ASSERT_TRUE(session->waitFor("not lodsmith.panel.valuePrompt.dialog.window:isVisible()"));
    EXPECT_EQ(levelCount(*session), 1);

    enter(*session, "Amount", "much");
    ASSERT_TRUE(session->waitFor("lodsmith.panel.definitionPane.parts.LevelError:getText() ~= ''"));
    EXPECT_EQ(session->ask("lodsmith.panel.state:level(1):amount()"), "0.5");
    enter(*session, "Amount", "0.75");
    ASSERT_TRUE(session->waitFor("lodsmith.panel.state:level(1):amount() == 0.75"));

    session->key("ctrl+z");
    ASSERT_TRUE(session->waitFor("lodsmith.panel.state:level(1):amount() == 0.5"));
    session->key("ctrl+y");
    ASSERT_TRUE(session->waitFor("lodsmith.panel.state:level(1):amount() == 0.75"));
}

TEST_F(EndToEndTest, AHandMadeLevelThatIsMissingIsSaid)
{
    std::ofstream(loddef()) << "<lod><automatic enabled=\"false\"/><manual><type>user</type>"
                               "<level distance=\"30\"><meshName>nowhere.mesh</meshName></level></manual></lod>";
    const auto session = open();
    ASSERT_TRUE(session->waitFor("lodsmith.panel.state:levelCount() == 1"));
    session->tell("lodsmith.panel.state:apply()");
    EXPECT_TRUE(
        session->waitFor("(lodsmith.panel.state.message or {text=''}).text:find('nowhere.mesh', 1, true) ~= nil"))
        << message(*session);
    EXPECT_EQ(session->ask("lodsmith.panel.state:level(1):meshName()"), "nowhere.mesh");
}

TEST_F(EndToEndTest, ChangesAreNotLostByLeaving)
{
    const auto session = open();
    makeManual(*session);
    session->key("ctrl+q");
    ASSERT_TRUE(session->waitFor("lodsmith.panel.question.dialog.window:isVisible()"));
    session->key("Escape");
    ASSERT_TRUE(session->waitFor("not lodsmith.panel.question.dialog.window:isVisible()"));
    EXPECT_EQ(session->ask("lodsmith.panel.state:isDirty()"), "true");
    session->key("ctrl+q");
    ASSERT_TRUE(session->waitFor("lodsmith.panel.question.dialog.window:isVisible()"));
    session->click("First");
    EXPECT_EQ(session->wait(), 0);
    const auto saved = readLoddefFile(loddef());
    ASSERT_TRUE(saved.ok());
    EXPECT_FALSE(saved.definition->automatic);
}

TEST_F(EndToEndTest, AnErrorInAHandlerIsShownAndTheEditorLivesOn)
{
    const auto session = open();
    session->tell("lodsmith.panel.state.undo = function() error('broken on purpose') end");
    session->key("ctrl+z");
    EXPECT_TRUE(
        session->waitFor("(lodsmith.panel.state.message or {text=''}).text:find('broken on purpose', 1, true) ~= nil"))
        << message(*session);
    EXPECT_THAT(session->errors(), HasSubstr("broken on purpose"));
    makeManual(*session);
}

} // namespace
} // namespace lodsmith::test
