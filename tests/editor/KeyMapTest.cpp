#include <KeyMap.h>

#include <gtest/gtest.h>

#include <set>

namespace lodsmith::editor {
namespace {

using Scan = CEGUI::Key::Scan;

TEST(KeyMap, GoesByWhatIsPrintedOnTheKey)
{
    EXPECT_EQ(keyFor(SDLK_a), Scan::A);
    EXPECT_EQ(keyFor(SDLK_y), Scan::Y);
    EXPECT_EQ(keyFor(SDLK_z), Scan::Z);
    EXPECT_EQ(keyFor(SDLK_0), Scan::Zero);
    EXPECT_EQ(keyFor(SDLK_9), Scan::Nine);
    EXPECT_EQ(keyFor(SDLK_DELETE), Scan::Delete);
    EXPECT_EQ(keyFor(SDLK_F12), Scan::F12);
}

TEST(KeyMap, HasADifferentNameForEachLetterAndDigit)
{
    std::set<int> names;
    for (SDL_Keycode key = SDLK_a; key <= SDLK_z; ++key)
        names.insert(keyFor(key));
    for (SDL_Keycode key = SDLK_0; key <= SDLK_9; ++key)
        names.insert(keyFor(key));
    EXPECT_EQ(names.size(), 36u);
    EXPECT_EQ(names.count(Scan::Unknown), 0u);
}

TEST(KeyMap, KnowsWhatItDoesNotKnow)
{
    EXPECT_EQ(keyFor(SDLK_VOLUMEUP), Scan::Unknown);
    EXPECT_EQ(keyFor(0), Scan::Unknown);
    EXPECT_EQ(buttonFor(0), CEGUI::NoButton);
    EXPECT_EQ(buttonFor(9), CEGUI::NoButton);
    EXPECT_EQ(buttonFor(SDL_BUTTON_LEFT), CEGUI::LeftButton);
    EXPECT_EQ(buttonFor(SDL_BUTTON_RIGHT), CEGUI::RightButton);
}

} // namespace
} // namespace lodsmith::editor
