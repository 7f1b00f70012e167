#include "EditorSession.h"

#include <gmock/gmock.h>

#include <chrono>
#include <random>

namespace fs = std::filesystem;

namespace lodsmith::test {
namespace {

using testing::HasSubstr;
using testing::Not;

// As many as xdotool sends at once.
constexpr int kEventsARound = 20;
constexpr auto kDuration = std::chrono::seconds(60);

const char* const kKeys[] = {"Tab",    "shift+Tab", "Return", "Escape",    "space",   "Up",        "Down",   "Left",
                             "Right",  "Home",      "End",    "Delete",    "ctrl+z",  "ctrl+y",    "ctrl+a", "ctrl+c",
                             "ctrl+v", "ctrl+x",    "ctrl+s", "ctrl+o",    "0",       "1",         "7",      "period",
                             "minus",  "e",         "a",      "BackSpace", "Page_Up", "Page_Down", "F5",     "slash"};

/// Some of what a hand can do, as xdotool's words.
std::string someEvent(std::mt19937& random, ScreenPoint screen)
{
    const auto number = [&](int below) { return int(random() % unsigned(below)); };
    switch (number(8)) {
    case 0:
    case 1:
    case 2: return " mousemove " + std::to_string(number(screen.x)) + " " + std::to_string(number(screen.y));
    case 3: return " click 1";
    case 4: return " mousedown 1";
    case 5: return " mouseup 1";
    case 6: return " click " + std::to_string(2 + number(4)); // the other buttons, and the wheel
    default: return std::string(" key ") + kKeys[number(int(std::size(kKeys)))];
    }
}

TEST(MonkeyTest, AMinuteOfNonsenseDoesNoHarm)
{
    if (!EditorSession::isAvailable())
        GTEST_SKIP() << "Xvfb or xdotool is not installed";
    TestDirectory models;
    fs::copy(LODSMITH_MEDIA_DIR "/lantern", models.path(), fs::copy_options::recursive);
    constexpr ScreenPoint kScreen{1280, 1024};
    EditorSession session({(models / "lantern.mesh").string()}, kScreen);
    ASSERT_TRUE(session.waitFor("lodsmith.panel.state.mesh ~= nil"));
    std::mt19937 random(2012);
    int events = 0;
    for (const auto start = std::chrono::steady_clock::now(); std::chrono::steady_clock::now() - start < kDuration;) {
        std::string round;
        for (int i = 0; i < kEventsARound; ++i)
            round += someEvent(random, kScreen);
        session.perform(round);
        events += kEventsARound;
        // Nonsense may have asked for the end; an unsaved definition keeps it from that, or it ends as it should.
        ASSERT_EQ(session.ask("1 + 1"), "2") << events << " events; " << session.errors();
    }
    EXPECT_GE(events, 200);
    session.tell("lodsmith.editor:quit()");
    EXPECT_EQ(session.wait(), 0) << session.errors();
    EXPECT_THAT(session.errors(), Not(HasSubstr("Sanitizer")));
    EXPECT_THAT(session.errors(), Not(HasSubstr("stack traceback")));
    EXPECT_THAT(session.errors(), Not(HasSubstr(".lua:")));
}

} // namespace
} // namespace lodsmith::test
